// The segments of a programme and what an entry changes: of the angles, that of its own row and of the one that takes the
// rest. No angle is scaled but by `rebalance`.
//
// A programme is {rows: [{motion, lift, angle}], locks: [boolean], rest: number or null, last: number or null, whole, unit}:
// texts as in the scene, the angles that are locked, the row chosen to take the rest, the row typed last, and what the
// angles add to (null where the travel follows from them) in `unit`, degrees or millimetres.

import { unitOf, value } from "./typed.js";

const SIZES = {
  "": 1, deg: 1, "°": 1, rad: 180 / Math.PI, rev: 360, turn: 360,
  mm: 1, um: 1e-3, "µm": 1e-3, cm: 10, m: 1000, in: 25.4, ft: 304.8,
};
const NEAR = 1e-6;
// What is left to the segment that takes the rest.
const LEAST = 1;

const SIZE = /^\s*([-+]?[\d.]+(?:e[-+]?\d+)?)(?:\s*\/\s*([\d.]+))?\s*([^\d\s].*)?$/i;

// A text as a number of degrees or millimetres; NaN where it is none.
export function size(typed) {
  const [, number, below = "1", unit = ""] = SIZE.exec(typed.replace(",", ".")) ?? [];
  return Number(number) / Number(below) * (SIZES[unit.trim()] ?? NaN);
}

// A typed text as the scene takes it, in a field that shows `unit`.
const written = (typed, unit) => value(typed.replace("−", "-"), unit).replace(/\s*°/, " deg");

const digits = (x) => String(Number(x.toPrecision(12)));

// A number of degrees or millimetres as a text in a unit.
export const text = (x, unit) => `${digits(x / SIZES[unit])} ${unit}`;

export const count = (p) => p.rows.length;
const angles = (p) => p.rows.map((row) => size(row.angle));
const sum = (list) => list.reduce((a, b) => a + b, 0);
const without = (list, i) => list.filter((_, k) => k !== i);

// What the angles lack to the whole; negative where they are too large.
export function gap(p) {
  if (p.whole === null || p.rows.length === 0) return 0;
  const x = p.whole - sum(angles(p));
  return Math.abs(x) < NEAR ? 0 : x;
}

// The sum of all lifts, in millimetres or degrees.
export function rise(p) {
  const x = sum(p.rows.map((row) => size(row.lift || "0")));
  return Math.abs(x) < NEAR ? 0 : x;
}

// The row that takes the rest: the chosen one, else the last dwell, else the last; -1 where all others are locked.
export function rest(p, but = -1) {
  const free = p.rows.map((_, i) => i).filter((i) => i !== but && !p.locks[i]);
  if (free.includes(p.rest)) return p.rest;
  return free.findLast((i) => isDwell(p.rows[i])) ?? free.at(-1) ?? -1;
}

export const isDwell = (row) => row.motion === "" || row.motion === "dwell";

const put = (p, i, change) => ({ ...p, rows: p.rows.map((row, k) => (k === i ? { ...row, ...change } : row)) });

// The row that takes the rest gets what the others leave, where they leave something.
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

// The largest angle that fits into a row; null where none does.
export function largest(p, i) {
  const r = rest(p, i);
  const others = sum(without(angles(p), i)) - (r < 0 ? 0 : size(p.rows[r].angle));
  const x = p.whole - others - (r < 0 ? 0 : LEAST);
  return x > NEAR ? text(x, p.unit) : null;
}

// A lift; the next segment that moves returns by what this one has grown, so that the lifts still add to 0.
export function setLift(p, i, typed) {
  const own = unitOf(p.rows[i].lift) || p.lifts;
  const next = put(p, i, { lift: written(typed, own) });
  const other = returning(p, i);
  const grown = size(next.rows[i].lift) - size(p.rows[i].lift || "0");
  if (other < 0 || rise(p) !== 0 || !Number.isFinite(grown)) return next;
  return put(next, other, { lift: text(size(p.rows[other].lift || "0") - grown, unitOf(next.rows[i].lift) || own) });
}

// The next row that moves after a row, around the turn; -1 where there is none.
export function returning(p, i) {
  const order = p.rows.map((_, k) => (i + 1 + k) % p.rows.length).slice(0, -1);
  return order.find((k) => !isDwell(p.rows[k])) ?? -1;
}

// A law: a dwell has no lift, and a motion from a dwell closes the lifts, or begins with one.
export function setMotion(p, i, motion) {
  if (isDwell({ motion })) return put(p, i, { motion, lift: "" });
  if (!isDwell(p.rows[i])) return put(p, i, { motion });
  const open = rise(p);
  return put(p, i, { motion, lift: text(open === 0 ? p.usual : -open, p.lifts) });
}

// A dwell before row `at`, with half the angle of the row that takes the rest.
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

// The segment that closes the lifts, at the end.
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

// The row that takes the rest closes the turn.
export const close = (p) => filled(p);

// Scales the angles that are not locked so that the turn is covered.
export function rebalance(p) {
  const free = sum(angles(p).filter((_, i) => !p.locks[i]));
  const left = p.whole - sum(angles(p).filter((_, i) => p.locks[i]));
  if (!(free > 0) || !(left > 0)) return p;
  const scaled = p.rows.map((row, i) => (p.locks[i] ? row : { ...row, angle: text(size(row.angle) * left / free, p.unit) }));
  return filled({ ...p, rows: scaled, last: null });
}

// Parts of the whole for the picture: [{row, from, to}], the gap with row -1. `whole` is 1 or more where they overlap.
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
// What a click makes: parts of the turn.
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
