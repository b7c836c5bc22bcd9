// Texts of the page in both languages. A change of the language has an immediate effect.

import { speak } from "./net.js";

let all = { en: {}, es: {} };
let tag = document.documentElement.lang || "en";
const listeners = [];

export function load(words) {
  all = words;
}

export function language() {
  return tag;
}

// Text of a key; {name} is replaced by a value.
export function t(key, values = {}) {
  const text = all[tag][key] ?? key;
  return text.replace(/\{(\w+)\}/g, (whole, name) => values[name] ?? whole);
}

export function has(key) {
  return key in all[tag];
}

export function onLanguage(listener) {
  listeners.push(listener);
}

// Sets the text of every marked element below `root`.
export function translate(root = document) {
  for (const e of /** @type {NodeListOf<HTMLElement>} */ (root.querySelectorAll("[data-text]"))) e.textContent = t(e.dataset.text);
  for (const e of /** @type {NodeListOf<HTMLElement>} */ (root.querySelectorAll("[data-label]"))) {
    const text = t(e.dataset.label);
    e.setAttribute("aria-label", text);
    if (e.matches("button, label, select")) e.title = text;
  }
}

// Sets the language: the one selected in the page, else that of the command line, else the first supported language of the browser.
export function begin() {
  let kept = null;
  try { kept = localStorage.getItem("gaitcam-language"); } catch { /* A private window stores nothing. */ }
  const wished = [kept, document.documentElement.lang, ...(navigator.languages ?? [])];
  become(wished.map((tag) => tag?.slice(0, 2)).find((tag) => tag in all) ?? "en");
}

export function choose(next) {
  try { localStorage.setItem("gaitcam-language", next); } catch { /* as above */ }
  become(next);
}

function become(next) {
  tag = next;
  document.documentElement.lang = next;
  speak(next);
  translate();
  for (const listener of listeners) listener(next);
}

// Number with at most `digits` significant digits and without trailing zeros, as formatted by the program.
export function number(x, digits = 4) {
  if (x === null || x === undefined || !Number.isFinite(x)) return "–";
  const size = Math.abs(x);
  // This function is called for every frame. `toLocaleString` would take a hundred times longer.
  const plain = size !== 0 && (size < 1e-4 || size >= 1e9)
    ? x.toExponential(digits - 1).replace("e+", "e")
    : x.toFixed(size === 0 ? 0 : Math.max(0, digits - 1 - Math.floor(Math.log10(size))));
  const short = plain.replace(/\.0+(?=e|$)|(\.\d*[1-9])0+(?=e|$)/, "$1").replace(/^-0$/, "0");
  return (tag === "es" ? short.replace(".", ",") : short).replaceAll("-", "−");
}

// Text with numbers in the form of scenes, with the decimal sign of the language.
export const local = (text) => (tag === "es" ? text.replace(/(\d)\.(?=\d)/g, "$1,") : text);

// Number with its unit. A degree sign has no space before it.
export function quantity(x, unit, digits) {
  const gap = unit === "°" || unit === "" ? "" : "\u00a0";
  return number(x, digits) + (x === null || x === undefined ? "" : gap + unit);
}
