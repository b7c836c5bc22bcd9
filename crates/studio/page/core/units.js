// Lengths as they are shown: millimetres or inches. Scenes and files keep the units they have.

import { number } from "./words.js";

// Inches per unit.
const INCHES = { mm: 1 / 25.4, m: 1 / 0.0254 };
const UNIT = String.raw`(mm|m)(?=/rad[²³]?|/s[²³]?)(/rad[²³]?|/s[²³]?)|(mm)(?![\p{L}/²³])`;
const NUMBER = String.raw`[-−]?\d+(?:[.,]\d+)?`;
const ONE = new RegExp(`(${NUMBER}(?: … ))?(${NUMBER})([\\s\\u00a0]?)(?:${UNIT})`, "gu");
const watchers = [];
let inch = false;

export function load() {
  try { inch = localStorage.getItem("gaitcam-units") === "in"; } catch { /* private windows keep nothing */ }
}

export const name = () => (inch ? "in" : "mm");

export function choose(next) {
  inch = next === "in";
  try { localStorage.setItem("gaitcam-units", next); } catch { /* as above */ }
  for (const watcher of watchers) watcher();
}

export function watch(watcher) {
  watchers.push(watcher);
}

const parsed = (text) => Number(text.replace("−", "-").replace(",", "."));

// Every length in a text, ranges "a … b mm" too.
export function text(whole) {
  if (!inch) return whole;
  return whole.replace(ONE, (all, first, last, gap, per, rest, plain) => {
    const factor = INCHES[plain ?? per];
    const low = first ? `${number(factor * parsed(first.slice(0, -3)))} … ` : "";
    return `${low}${number(factor * parsed(last))}${gap}in${rest ?? ""}`;
  });
}

// A unit with the factor that leads to it.
export function unit(of) {
  const [, length, rest] = /^(mm|m)((?:\/.*)?)$/.exec(of) ?? [];
  return inch && length ? [`in${rest}`, INCHES[length]] : [of, 1];
}

// A diagram's panel in the units shown.
export function panel(whole) {
  const [to, factor] = unit(whole.unit);
  if (factor === 1) return whole;
  const scaled = (y) => (y === null ? null : y * factor);
  return { ...whole, unit: to, lines: whole.lines.map((l) => ({ ...l, y: l.y.map(scaled) })), levels: whole.levels.map(scaled) };
}
