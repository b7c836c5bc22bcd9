// Colour scale from dark blue over green to yellow, readable for colour-blind users on light and dark backgrounds.

const STOPS = [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37]];

function colour(u) {
  const x = Math.max(0, Math.min(0.9999, u)) * (STOPS.length - 1);
  const [a, b, f] = [STOPS[Math.floor(x)], STOPS[Math.floor(x) + 1], x % 1];
  return a.map((c, k) => Math.round(c + f * (b[k] - c)));
}

/** Colour at a position of the scale. @param {number} u From 0 to 1. */
export const shade = (u) => `rgb(${colour(u).join(" ")})`;

/** Whether white text has more contrast than black text on the colour. @param {number} u From 0 to 1. */
export function isDark(u) {
  const [r, g, b] = colour(u).map((c) => (c <= 10 ? c / 3295 : ((c / 255 + 0.055) / 1.055) ** 2.4));
  return 0.2126 * r + 0.7152 * g + 0.0722 * b < 0.179;
}
