// Feasible values of a slider: verdicts of the designs over its values, requested in the background during pauses.

import { engine, Fault } from "../core/net.js";
import { t, number } from "../core/words.js";
import { typeset } from "../core/units.js";
import * as blobs from "../core/blobs.js";
import * as designs from "../core/designs.js";
import * as versions from "../core/versions.js";

const COUNT = 17;
const HALVINGS = 4;
const REST = 400;
const KEPT = 40;
const COLOURS = { acceptable: "var(--possible)", "not-for-high-speed": "var(--possible-slow)" };
const classOf = ([, verdict]) => (verdict in COLOURS ? verdict : "none");

// Slider whose values are examined: {key, range}. It is the last one that was pointed at, focused or moved.
let aim = null;
let timer = 0;
let control = null;
let draw = () => {};
// Verdicts by their inputs: {points: [[value, verdict]], done}.
const found = new Map();

export function load(onFound) {
  draw = onFound;
  // Any input of the user interrupts the requests.
  for (const name of ["pointerdown", "keydown", "input"]) document.addEventListener(name, rest, { capture: true, passive: true });
}

export const aimed = () => aim?.key ?? null;

export function aimAt(key, range) {
  if (aim?.key === key) {
    if (!timer && !control) rest();
    return;
  }
  aim = { key, range };
  rest();
  draw();
}

function rest() {
  clearTimeout(timer);
  timer = 0;
  control?.abort();
  control = null;
  if (aim) timer = setTimeout(begin, REST);
}

// All inputs of the verdicts: every other value of the scene, its files, and the ends of the slider.
function depends({ key, range }) {
  const fields = Object.entries(designs.known()).filter(([other]) => other !== key).map(([, field]) => field.text);
  return JSON.stringify([key, range.from, range.to, range.unit, fields, versions.now()?.files]);
}

function keep(id, entry) {
  found.delete(id);
  found.set(id, entry);
  if (found.size > KEPT) found.delete(found.keys().next().value);
}

async function begin() {
  timer = 0;
  if (document.hidden || !document.querySelector(`input[data-key="${aim.key}"]`)?.checkVisibility()) return;
  if (!designs.isCurrent()) {
    timer = setTimeout(begin, REST);
    return;
  }
  const id = depends(aim);
  const entry = found.get(id) ?? { points: [], done: false };
  keep(id, entry);
  if (entry.done) return;
  const { signal } = control = new AbortController();
  try {
    await fill(entry, versions.now(), aim, signal);
    entry.done = true;
    draw();
  } catch (error) {
    // Another input interrupted the request, or the engine does not support it.
    if (!(error instanceof Fault) && error.name !== "AbortError") throw error;
  } finally {
    if (control?.signal === signal) control = null;
  }
}

async function fill(entry, version, { key, range: { from, to, step, unit } }, signal) {
  const question = { scene: version.scene, files: blobs.listed(version.files), key, unit };
  const count = step === 1 ? Math.min(COUNT, to - from + 1) : COUNT;
  const ask = async (block) => {
    const { values } = await engine.ask("range", { ...question, ...block }, { signal });
    entry.points = [...entry.points, ...values].sort(([a], [b]) => a - b);
    draw();
    return values;
  };
  const at = (i) => Number((from + (to - from) * i / Math.max(1, count - 1)).toPrecision(9));
  // An interrupted examination continues at the next value.
  for (let i = entry.points.length; i < count;) {
    i += (await ask({ from: at(i), to, count: count - i })).length;
  }
  for (const border of borders(entry.points)) await halve(border, step, ask);
}

export const borders = (points) => points.slice(1).map((p, i) => [points[i], p]).filter(([a, b]) => classOf(a) !== classOf(b));

async function halve([low, high], step, ask) {
  for (let i = 0; i < HALVINGS && high[0] - low[0] > 1.5 * step; i += 1) {
    const middle = (low[0] + high[0]) / 2;
    const [point] = await ask({ from: middle, to: middle, count: 1 });
    if (classOf(point) === classOf(low)) low = point;
    else high = point;
  }
}

// Adjacent points with the same class as [class, from, to].
export function stretches(points) {
  const all = [];
  for (const point of points) {
    const last = all.at(-1);
    if (last?.[0] === classOf(point)) last[2] = point[0];
    else all.push([classOf(point), point[0], point[0]]);
  }
  return all;
}

// Gradient for the track of the slider, and a text; null if no verdict is known.
export function shown(key, range) {
  if (aim?.key !== key) return null;
  aim.range = range;
  const entry = found.get(depends(aim));
  if (!entry || entry.points.length === 0) return null;
  const share = (x) => `${(100 * (x - range.from) / (range.to - range.from)).toFixed(2)}%`;
  const all = stretches(entry.points);
  const stops = all.map(([name, from, to], i) => {
    const [low, high] = name === "none" ? [all[i - 1]?.[2] ?? range.from, all[i + 1]?.[1] ?? to] : [from, to];
    return `${COLOURS[name] ?? "transparent"} ${share(low)} ${share(high)}`;
  });
  return { gradient: `linear-gradient(to right, ${stops.join(", ")}, transparent ${share(all.at(-1)[2])})`, words: entry.done ? words(all, range.unit) : "" };
}

function words(all, unit) {
  const passing = all.filter(([name]) => name !== "none");
  if (passing.length === 0) return t("studio-possible-none");
  const texts = passing.map(([name, from, to]) => t(name === "acceptable" ? "studio-possible" : "studio-possible-slow",
    { from: number(from, 3), to: number(to, 3), unit: typeset(unit.trim()) }).trim());
  return texts.join("; ");
}
