// Names of keys and choices, and the help text of a key with these names.

import { t, has, language } from "../core/words.js";

// Dotted keys, complete or as the start of other keys.
const KEY = /\b(gait|cam|drive|law|limits|machine|accuracy)(\.\w+)+\b/g;
const HYPHENATED = /\b[a-z]+(?:-[a-z]+)+\b/g;

const word = (key) => `studio-key-${key.replaceAll(".", "-")}`;

export function label(key) {
  // The number of an entry distinguishes it from the other entries of the list.
  const [, number] = /\.(\d+)\./.exec(key) ?? [];
  const whole = word(key.replace(/\.(\d+|N)\./, "."));
  const column = `studio-column-${key.split(".").at(-1)}`;
  const name = [whole, column].find(has);
  const text = name ? t(name) : key.split(".").at(-1).replaceAll("_", " ");
  return number ? `${text} ${number}` : text;
}

// Name of a check: a separate name, or the name of its limit.
export function criterion(key) {
  const own = `studio-criterion-${key}`;
  return has(own) ? t(own) : label(`limits.${key}`);
}

export const choice = (value) => (has(`studio-choice-${value}`) ? t(`studio-choice-${value}`) : value);

const quoted = (text) => (language() === "es" ? `«${text}»` : `“${text}”`);

// Description of a key, with the names of keys and choices instead of the keys and choices themselves.
export function help({ doc }) {
  const named = doc[language()].replace(KEY, (key) => (has(word(key)) ? quoted(t(word(key))) : key));
  return named.replace(HYPHENATED, (value) => (has(`studio-choice-${value}`) ? quoted(choice(value)) : value));
}
