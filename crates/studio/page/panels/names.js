// Names of keys and choices, and the help of a key in the words of the page.

import { t, has, language } from "../core/words.js";

// Dotted keys, single or as the beginning of others.
const KEY = /\b(gait|cam|drive|law|limits|machine|accuracy)(\.\w+)+\b/g;
const HYPHENATED = /\b[a-z]+(?:-[a-z]+)+\b/g;

const word = (key) => `studio-key-${key.replaceAll(".", "-")}`;

export function label(key) {
  // An entry of a list: its number tells it from the others.
  const [, number] = /\.(\d+)\./.exec(key) ?? [];
  const whole = word(key.replace(/\.(\d+|N)\./, "."));
  const column = `studio-column-${key.split(".").at(-1)}`;
  const name = [whole, column].find(has);
  const text = name ? t(name) : key.split(".").at(-1).replaceAll("_", " ");
  return number ? `${text} ${number}` : text;
}

// The name of a check: that of its limit, or its own.
export function criterion(key) {
  const own = `studio-criterion-${key}`;
  return has(own) ? t(own) : label(`limits.${key}`);
}

export const choice = (value) => (has(`studio-choice-${value}`) ? t(`studio-choice-${value}`) : value);

const quoted = (text) => (language() === "es" ? `«${text}»` : `“${text}”`);

// The description of a key; keys and choices in it are called by their names.
export function help({ doc }) {
  const named = doc[language()].replace(KEY, (key) => (has(word(key)) ? quoted(t(word(key))) : key));
  return named.replace(HYPHENATED, (value) => (has(`studio-choice-${value}`) ? quoted(choice(value)) : value));
}
