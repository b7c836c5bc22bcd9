// Values of a scene: differences between scenes, given values, and the position of a design on an axis.

import { local } from "../core/words.js";
import { choice, label } from "./names.js";

// Values of a scene by their keys, without empty ones.
export const inputsOf = (fields) => Object.fromEntries(Object.entries(fields).map(([key, { text }]) => [key, text]).filter(([, text]) => text !== ""));

// Values that are not the same in all scenes.
export function differing(all) {
  const keys = new Set(all.flatMap((p) => Object.keys(p.inputs ?? {})));
  const rows = [...keys].map((key) => [key, all.map((p) => p.inputs?.[key] ?? "")]);
  return rows.filter(([key, values]) => key !== "name" && new Set(values).size > 1);
}

/**
 * Name of the scene, with at most two values that differ from those of the design pinned last.
 * @param {{name: string, inputs: Record<string, string>}} made
 * @param {{name: string, inputs?: Record<string, string>}[]} others
 */
export function nameOf(made, others) {
  const last = others.at(-1);
  const changed = last ? differing([last, made]).slice(0, 2).map(([key, [, value]]) => `${label(key)} ${local(choice(value) || "–")}`) : [];
  const name = [made.name, ...changed].join(", ");
  const taken = others.filter((p) => p.name === name || p.name.startsWith(`${name} (`)).length;
  return taken > 0 ? `${name} (${taken + 1})` : name;
}

/**
 * Values of a scene: single values, and the entries of lists by their numbers.
 * @param {Record<string, {text: string}>} fields
 */
export function given(fields) {
  const set = Object.entries(fields).filter(([key, { text }]) => text !== "" && key !== "name");
  const entries = new Map();
  const single = [];
  for (const [key, { text }] of set) {
    const [, list, at, column] = /^(.*)\.(\d+)\.([^.]+)$/.exec(key) ?? [];
    if (!list) single.push([key, text]);
    else {
      const name = `${list}.${at}`;
      if (!entries.has(name)) entries.set(name, []);
      entries.get(name).push([column, text]);
    }
  }
  return { single, entries: [...entries] };
}

// `count` values from 50 % to 150 % of the present value, within the ends of the slider.
export function valuesAbout({ from, to, at, unit }, count) {
  const [low, high] = [Math.max(from, at - 0.5 * Math.abs(at)), Math.min(to, at + 0.5 * Math.abs(at))];
  return Array.from({ length: count }, (_, i) => `${Number((low + (high - low) * i / (count - 1)).toPrecision(4))}${unit}`);
}

/**
 * Index of the value of an axis that is nearest to the present value; −1 if the present value is not within half a step.
 * @param {string[]} list @param {number} at
 */
export function nearest(list, at) {
  const numbers = list.map(parseFloat);
  const half = 0.5 * Math.abs(numbers[1] - numbers[0]);
  return numbers.findIndex((x) => Math.abs(x - at) <= half);
}
