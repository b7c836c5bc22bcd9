// A scale of colours from dark blue over green to yellow: readable for colour-blind eyes on light and dark ground.

const STOPS = [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37]];

/** The colour of a part of the scale. @param {number} u From 0 to 1. */
export function shade(u) {
  const x = Math.max(0, Math.min(0.9999, u)) * (STOPS.length - 1);
  const [a, b, f] = [STOPS[Math.floor(x)], STOPS[Math.floor(x) + 1], x % 1];
  return `rgb(${a.map((c, k) => Math.round(c + f * (b[k] - c))).join(" ")})`;
}

/** Whether white text is read best on the colour. @param {number} u From 0 to 1. */
export const isDark = (u) => u < 0.45;
