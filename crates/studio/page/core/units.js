// Displayed units of lengths and speeds: millimetres or inches, rad/s or rpm. The units in scenes and files do not change.

import { number } from "./words.js";

// Alternative unit for each unit, and the factor to it.
const OTHERS = { mm: ["in", 1 / 25.4], m: ["in", 1 / 0.0254], "rad/s": ["rpm", 30 / Math.PI] };
const UNIT = String.raw`(mm|m)(?=/rad[²³]?|/s[²³]?)(/rad[²³]?|/s[²³]?)|(mm|rad/s)(?![\p{L}/²³])`;
const NUMBER = String.raw`[-−]?\d+(?:[.,]\d+)?`;
const ONE = new RegExp(`(${NUMBER}(?: … ))?(${NUMBER})([\\s\\u00a0]?)(?:${UNIT})`, "gu");
const watchers = [];
let chosen = new Set();

export function load() {
  try { chosen = new Set((localStorage.getItem("gaitcam-units") ?? "").split(" ").filter(Boolean)); } catch { /* A private window stores nothing. */ }
}

export const names = () => [...chosen].join(" ");

// Selects a displayed unit in place of another.
export function choose(next, before) {
  chosen.delete(before);
  chosen.add(next);
  try { localStorage.setItem("gaitcam-units", names()); } catch { /* as above */ }
  for (const watcher of watchers) watcher();
}

export function watch(watcher) {
  watchers.push(watcher);
}

const parsed = (text) => Number(text.replace("−", "-").replace(",", "."));

// Text with all lengths and speeds converted, including ranges such as "a … b mm".
export function text(whole) {
  return whole.replace(ONE, (all, first, last, gap, per, rest, plain) => {
    const [to, factor] = unit(plain ?? per);
    if (factor === 1) return all;
    const low = first ? `${number(factor * parsed(first.slice(0, -3)))} … ` : "";
    return `${low}${number(factor * parsed(last))}${gap}${to}${rest ?? ""}`;
  });
}

// Displayed unit for a unit, and the factor to it.
export function unit(of) {
  const [, base, rest] = /^(mm|m|rad\/s)((?:\/.*)?)$/.exec(of) ?? [];
  const [to, factor] = OTHERS[base] ?? [];
  return chosen.has(to) ? [to + rest, factor] : [of, 1];
}

// Panel of a diagram in the displayed units.
export function panel(whole) {
  const [to, factor] = unit(whole.unit);
  if (factor === 1) return whole;
  const scaled = (y) => (y === null ? null : y * factor);
  const lines = whole.lines.map((l) => ({ ...l, y: l.y.map(scaled) }));
  const levels = whole.levels.map((l) => ({ ...l, y: scaled(l.y), from: scaled(l.from) }));
  return { ...whole, unit: to, lines, levels };
}

// Text of a scene in printed form: superscript powers, and degree signs next to the number.
export function typeset(text) {
  return text.replace(/\^2\b/g, "²").replace(/\^3\b/g, "³").replace(/(\d) ?deg\b/g, "$1°").replace(/\bdeg\b/g, "°");
}
