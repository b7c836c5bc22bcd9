// Slider of a value: its ends, keyboard and touch input, and the search for the border of the permitted values.

import { number } from "../core/words.js";
import * as typed from "../core/typed.js";

const HALVINGS = 7;
// Distance after which a touch moves the slider instead of the page, px.
const FINGER = 8;

// Ends of the sliders as given or typed: {from, to, step, unit}.
const ends = new Map();
// Value that is being dragged or typed: {key, text, at, gesture}.
let hand = null;
// Last value sent by a slider, until it is accepted: {key, at, gesture, border, seen}.
let slid = null;
let gesture = 0;
let pressed = 0;
let finger = null;
/** @type {(key: string, value: string, gesture: string) => void} */
let send = () => {};

export function load(onValue) {
  send = onValue;
}

export const held = (key) => (hand?.key === key ? hand : null);
export const gestureOf = (key) => `${key} ${gesture}`;
export function begin() {
  gesture += 1;
}
export function type(key, text) {
  hand = { key, text, typed: gestureOf(key) };
}

// Forgets a typed text when a change of another gesture follows.
export function follow(version) {
  if (hand?.typed && version && version.gesture !== hand.typed) hand = null;
}

export function release() {
  hand = null;
}

// Forgets the value being changed, for undo and for another version.
export function reset() {
  hand = null;
  slid = null;
}

export const forgetEnds = () => ends.clear();

// Ends of a slider. They stay unchanged while the value is between them.
export function extent(key, slider) {
  const kept = ends.get(key);
  const isInside = kept?.unit === slider.unit && slider.at >= kept.from && slider.at <= kept.to;
  if (kept && (isInside || held(key)?.at !== undefined)) return kept;
  ends.set(key, { from: slider.from, to: slider.to, step: slider.step, unit: slider.unit });
  return ends.get(key);
}

// Sets an end as typed. The present value stays within the ends.
export function setEnd(key, slider, end, text) {
  const range = extent(key, slider);
  const isCount = slider.step === 1 && slider.unit === "";
  const sent = typed.number(typed.value(text, ""));
  const x = isCount ? Math.round(sent) : sent;
  if (!Number.isFinite(x)) return;
  const next = { ...range, [end]: end === "to" ? Math.max(x, slider.at) : Math.min(x, slider.at) };
  if (next.to <= next.from) return;
  next.step = isCount ? 1 : 10 ** Math.floor(Math.log10((next.to - next.from) / 300));
  ends.set(key, next);
}

export function written(x, { step, unit }) {
  const decimals = Math.max(0, Math.min(8, -Math.floor(Math.log10(step) + 1e-9)));
  return Number(x.toFixed(decimals)) + unit;
}

function set(key, x, range, isHeld) {
  const text = written(x, range);
  hand = isHeld ? { key, text, at: x } : null;
  slid = { key, at: x, gesture: gestureOf(key), border: null, seen: null };
  send(key, text, slid.gesture);
}

// --- border of the permitted values -----------------------------------------------------------------

// Searches by bisection for the border between the last accepted value and a rejected one. The border becomes the end of the slider.
export function seek(version, fields) {
  if (!slid || !version || slid.seen === version.id) return;
  const change = version.pending.find((p) => p.keys.includes(slid.key));
  const field = fields[slid.key]?.slider;
  if (!field || (change && !change.fault)) return;
  slid.seen = version.id;
  if (change) {
    slid.border ??= { good: field.at, left: HALVINGS };
    slid.border.bad = slid.at;
    halve(field);
  } else if (!slid.border) slid = null;
  else {
    slid.border.good = slid.at;
    halve(field);
  }
}

function halve(field) {
  const { key, border } = slid;
  const range = extent(key, field);
  border.left -= 1;
  const isDone = border.left <= 0 || Math.abs(border.bad - border.good) <= 1.5 * range.step;
  const value = isDone ? border.good : (border.good + border.bad) / 2;
  if (isDone) ends.set(key, { ...range, [border.bad > border.good ? "to" : "from"]: value });
  if (hand?.key === key) hand = { ...hand, at: value, text: written(value, range) };
  const step = slid.gesture;
  slid = isDone ? null : { ...slid, at: value };
  // The change belongs to the same gesture, even if the user has released the slider.
  setTimeout(() => send(key, written(value, range), step));
}

// --- events -----------------------------------------------------------------------------------------

// Listeners of the slider of `key`. `of` returns its field, and `draw` draws the form again.
export const listeners = (key, of, draw) => ({
  pointerdown: (event) => {
    gesture += 1;
    const { pointerType, clientX: x, clientY: y, currentTarget } = event;
    finger = pointerType === "touch" ? { x, y, start: currentTarget.value, sets: false } : null;
  },
  // A vertical touch movement scrolls the page. Only a movement along the slider changes the value.
  pointermove: ({ clientX, clientY }) => {
    if (!finger) return;
    const [dx, dy] = [Math.abs(clientX - finger.x), Math.abs(clientY - finger.y)];
    finger.sets ||= dx > FINGER && dx > dy;
  },
  pointerup: lift,
  pointercancel: (event) => {
    if (finger && !finger.sets) event.currentTarget.value = finger.start;
    lift();
  },
  input: ({ currentTarget }) => {
    if (finger && !finger.sets) currentTarget.value = finger.start;
    else set(key, Number(currentTarget.value), extent(key, of().slider), true);
  },
  change: () => {
    hand = null;
    gesture += 1;
    draw();
  },
  keydown: (event) => {
    const way = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[event.key];
    if (way) turn(key, Number(event.currentTarget.value), extent(key, of().slider), way, event);
  },
});

// The final events of the touch follow this one, so the touch is forgotten after a delay.
function lift() {
  const lifted = finger;
  setTimeout(() => { if (finger === lifted) finger = null; }, 50);
}

// An arrow key moves to the next round number. Keys pressed within one second belong to one gesture.
function turn(key, at, range, way, event) {
  event.preventDefault();
  const step = Math.max(range.step, 10 ** Math.floor(Math.log10((range.to - range.from) / 20))) * (event.shiftKey ? 10 : 1);
  const next = (way > 0 ? Math.floor(at / step + 1 + 1e-6) : Math.ceil(at / step - 1 - 1e-6)) * step;
  if (event.timeStamp - pressed > 1000) gesture += 1;
  pressed = event.timeStamp;
  set(key, Math.max(range.from, Math.min(range.to, next)), range, false);
}

// The up and down keys in a text field change the number by one step of the slider.
export function nudge(key, slider, event) {
  event.preventDefault();
  const range = extent(key, slider);
  const by = (event.key === "ArrowUp" ? 1 : -1) * range.step * (event.shiftKey ? 10 : 1);
  const text = written((held(key)?.at ?? slider.at) + by, range);
  hand = { key, text, at: typed.number(text) };
  send(key, text, gestureOf(key));
}

export const shownEnd = (x) => number(x).replaceAll("−", "-");
