// What the values of a scene say: which differ between scenes, which are given, where a design lies on an axis.

import { local } from "../core/words.js";
import { choice, label } from "./names.js";

// The values that a scene has, by their keys.
export const inputsOf = (fields) => Object.fromEntries(Object.entries(fields).map(([key, { text }]) => [key, text]).filter(([, text]) => text !== ""));

// The values of the scenes that are not the same in all of them.
export function differing(all) {
  const keys = new Set(all.flatMap((p) => Object.keys(p.inputs ?? {})));
  const rows = [...keys].map((key) => [key, all.map((p) => p.inputs?.[key] ?? "")]);
  return rows.filter(([key, values]) => key !== "name" && new Set(values).size > 1);
}

/**
 * The scene's name, and the values that differ from those of the designs pinned before.
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
 * The values of a scene: single ones, and the entries of lists by their numbers.
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

// From 50 % to 150 %, within the slider's ends.
export function valuesAbout({ from, to, at, unit }, count) {
  const [low, high] = [Math.max(from, at - 0.5 * Math.abs(at)), Math.min(to, at + 0.5 * Math.abs(at))];
  return Array.from({ length: count }, (_, i) => `${Number((low + (high - low) * i / (count - 1)).toPrecision(4))}${unit}`);
}

/**
 * The value of an axis that the present design has, or nearly has; −1 where it is elsewhere.
 * @param {string[]} list @param {number} at
 */
export function nearest(list, at) {
  const numbers = list.map(parseFloat);
  const half = 0.5 * Math.abs(numbers[1] - numbers[0]);
  return numbers.findIndex((x) => Math.abs(x - at) <= half);
}
