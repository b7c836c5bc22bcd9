// Segments of a programme, and the effect of an entry: it changes the angle of its own row and of the row that takes the rest. Only
// `rebalance` scales the other angles.
//
// A programme is {rows: [{motion, lift, angle}], locks: [boolean], rest: number or null, last: number or null, whole, unit}. `rows`
// contains texts as in the scene, and `locks` marks locked angles. `rest` is the row that the user chose to take the rest. `last` is the
// row changed last. `whole` is the required sum of the angles in `unit`, degrees or millimetres; it is null if the travel follows from the
// angles.

import { unitOf, value } from "./typed.js";

const SIZES = {
  "": 1, deg: 1, "°": 1, rad: 180 / Math.PI, rev: 360, turn: 360,
  mm: 1, um: 1e-3, "µm": 1e-3, cm: 10, m: 1000, in: 25.4, ft: 304.8,
};
const NEAR = 1e-6;
// Minimum angle or length of the segment that takes the rest, in degrees or millimetres.
const LEAST = 1;

const SIZE = /^\s*([-+]?[\d.]+(?:e[-+]?\d+)?)(?:\s*\/\s*([\d.]+))?\s*([^\d\s].*)?$/i;

// Value of a text in degrees or millimetres; NaN if the text is not a number.
export function size(typed) {
  const [, number, below = "1", unit = ""] = SIZE.exec(typed.replace(",", ".")) ?? [];
  return Number(number) / Number(below) * (SIZES[unit.trim()] ?? NaN);
}

// Typed text in the form of the scene file, from a field that shows `unit`.
const written = (typed, unit) => value(typed.replace("−", "-"), unit).replace(/\s*°/, " deg");

const digits = (x) => String(Number(x.toPrecision(12)));

// Text in a unit, from a value in degrees or millimetres.
export const text = (x, unit) => `${digits(x / SIZES[unit])} ${unit}`;

export const count = (p) => p.rows.length;
const angles = (p) => p.rows.map((row) => size(row.angle));
const sum = (list) => list.reduce((a, b) => a + b, 0);
const without = (list, i) => list.filter((_, k) => k !== i);

// Difference between the required sum of the angles and their sum; negative if the angles are too large.
export function gap(p) {
  if (p.whole === null || p.rows.length === 0) return 0;
  const x = p.whole - sum(angles(p));
  return Math.abs(x) < NEAR ? 0 : x;
}

// Sum of all lifts, in millimetres or degrees.
export function rise(p) {
  const x = sum(p.rows.map((row) => size(row.lift || "0")));
  return Math.abs(x) < NEAR ? 0 : x;
}

// Row that takes the rest: the chosen row, else the last dwell, else the last row; -1 if all other rows are locked.
export function rest(p, but = -1) {
  const free = p.rows.map((_, i) => i).filter((i) => i !== but && !p.locks[i]);
  if (free.includes(p.rest)) return p.rest;
  return free.findLast((i) => isDwell(p.rows[i])) ?? free.at(-1) ?? -1;
}

export const isDwell = (row) => row.motion === "" || row.motion === "dwell";

const put = (p, i, change) => ({ ...p, rows: p.rows.map((row, k) => (k === i ? { ...row, ...change } : row)) });

// Sets the row that takes the rest to the remaining angle, if this is positive.
function filled(p, but = -1) {
  const r = rest(p, but);
  if (r < 0 || p.whole === null) return p;
  const left = p.whole - sum(without(angles(p), r));
  return left > NEAR ? { ...put(p, r, { angle: text(left, p.unit) }), rest: p.rest === null ? null : r } : p;
}

export function setAngle(p, i, typed) {
  const own = unitOf(p.rows[i].angle) || p.unit;
  const next = put({ ...p, last: i }, i, { angle: written(typed, own) });
  if (p.whole === null || p.rows.length < 2) return next;
  return filled({ ...next, rest: rest(next, i) < 0 ? p.rest : rest(next, i) }, i);
}

// Maximum angle for a row; null if no angle fits.
export function largest(p, i) {
  const r = rest(p, i);
  const others = sum(without(angles(p), i)) - (r < 0 ? 0 : size(p.rows[r].angle));
  const x = p.whole - others - (r < 0 ? 0 : LEAST);
  return x > NEAR ? text(x, p.unit) : null;
}

// Sets a lift. The change is subtracted from the next moving segment, so that the sum of the lifts stays 0.
export function setLift(p, i, typed) {
  const own = unitOf(p.rows[i].lift) || p.lifts;
  const next = put(p, i, { lift: written(typed, own) });
  const other = returning(p, i);
  const grown = size(next.rows[i].lift) - size(p.rows[i].lift || "0");
  if (other < 0 || rise(p) !== 0 || !Number.isFinite(grown)) return next;
  return put(next, other, { lift: text(size(p.rows[other].lift || "0") - grown, unitOf(next.rows[i].lift) || own) });
}

// Next moving row after a row, around the turn; -1 if there is none.
export function returning(p, i) {
  const order = p.rows.map((_, k) => (i + 1 + k) % p.rows.length).slice(0, -1);
  return order.find((k) => !isDwell(p.rows[k])) ?? -1;
}

// Sets the motion of a row. A dwell has no lift. A dwell that becomes a motion gets the lift that closes the sum, or else a usual lift.
export function setMotion(p, i, motion) {
  if (isDwell({ motion })) return put(p, i, { motion, lift: "" });
  if (!isDwell(p.rows[i])) return put(p, i, { motion });
  const open = rise(p);
  return put(p, i, { motion, lift: text(open === 0 ? p.usual : -open, p.lifts) });
}

// Adds a dwell before row `at`, with half the angle of the row that takes the rest.
export function add(p, at, row = { motion: "dwell", lift: "" }) {
  const donor = rest(p);
  const half = p.rows.length === 0 ? p.whole ?? p.usualLength : size(p.rows[donor]?.angle ?? "") / 2;
  const angle = text(Number.isFinite(half) && half > 0 ? half : p.usualLength / 4, p.unit);
  const insert = (list, x) => [...list.slice(0, at), x, ...list.slice(at)];
  const next = { ...p, rows: insert(p.rows, { ...row, angle }), locks: insert(p.locks, false) };
  const moved = donor >= at ? donor + 1 : donor;
  const given = donor >= 0 && p.rows.length > 0 ? filled({ ...next, rest: moved }) : next;
  return { ...given, rest: p.rest === null ? null : moved, last: null };
}

// Adds a segment at the end that closes the sum of the lifts.
export const addReturn = (p) =>
  add(p, p.rows.length, { motion: p.rows.findLast((r) => !isDwell(r))?.motion ?? "cycloidal", lift: text(-rise(p), p.lifts) });

export function remove(p, i) {
  const kept = p.rest === i ? null : p.rest > i ? p.rest - 1 : p.rest;
  return filled({ ...p, rows: without(p.rows, i), locks: without(p.locks, i), rest: kept, last: null });
}

export function move(p, from, to) {
  const moved = (list) => {
    const next = without(list, from);
    next.splice(to, 0, list[from]);
    return next;
  };
  const at = moved(p.rows.map((_, k) => k));
  return { ...p, rows: moved(p.rows), locks: moved(p.locks), rest: p.rest === null ? null : at.indexOf(p.rest), last: null };
}

// Sets the row that takes the rest so that the turn is complete.
export const close = (p) => filled(p);

// Scales the angles that are not locked so that the turn is complete.
export function rebalance(p) {
  const free = sum(angles(p).filter((_, i) => !p.locks[i]));
  const left = p.whole - sum(angles(p).filter((_, i) => p.locks[i]));
  if (!(free > 0) || !(left > 0)) return p;
  const scaled = p.rows.map((row, i) => (p.locks[i] ? row : { ...row, angle: text(size(row.angle) * left / free, p.unit) }));
  return filled({ ...p, rows: scaled, last: null });
}

// Fractions of the whole for the picture: [{row, from, to}]. A gap has row -1. `whole` is below 1 if the angles are too large.
export function parts(p) {
  const known = angles(p).map((x) => (x > 0 ? x : 0));
  const whole = p.whole ?? sum(known);
  const scale = Math.max(whole, sum(known)) || 1;
  let at = 0;
  const list = known.map((x, row) => ({ row, from: at / scale, to: (at += x) / scale }));
  if (whole - at > NEAR) list.push({ row: -1, from: at / scale, to: whole / scale });
  return { list, whole: whole / scale };
}

const MOVES = { up: 1, down: -1, dwell: 0 };
// Templates of programmes: kind of motion and fraction of the turn.
export const TEMPLATES = {
  "double-dwell": [["up", 1 / 3], ["dwell", 1 / 6], ["down", 1 / 3], ["dwell", 1 / 6]],
  "rise-return": [["up", 1 / 2], ["down", 1 / 2]],
  "single-dwell": [["up", 1 / 3], ["down", 1 / 3], ["dwell", 1 / 3]],
  "four-strokes": Array.from({ length: 8 }, (_, i) => [i % 2 ? "down" : "up", 1 / 8]),
};

export function template(p, name) {
  const whole = p.whole ?? p.usualLength;
  const rows = TEMPLATES[name].map(([kind, part]) => ({
    motion: kind === "dwell" ? "dwell" : "cycloidal",
    lift: kind === "dwell" ? "" : text(MOVES[kind] * p.usual, p.lifts),
    angle: text(whole * part, p.unit),
  }));
  return { ...p, rows, locks: rows.map(() => false), rest: null, last: null };
}
