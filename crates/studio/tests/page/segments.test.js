import { test } from "node:test";
import { deepEqual, equal, ok } from "node:assert/strict";
import * as segments from "../../page/core/segments.js";

const empty = { rows: [], locks: [], rest: null, last: null, whole: 360, unit: "deg", lifts: "mm", usual: 20, usualLength: 120 };
const anglesOf = (p) => p.rows.map((row) => segments.size(row.angle));
const doubleDwell = segments.template(empty, "double-dwell");

// All orders of a list.
function orders(list) {
  if (list.length < 2) return [list];
  return list.flatMap((x, i) => orders([...list.slice(0, i), ...list.slice(i + 1)]).map((rest) => [x, ...rest]));
}

test("four angles typed in any order are exactly those", () => {
  const wanted = [60, 120, 60, 120];
  for (const order of orders([0, 1, 2, 3])) {
    const typed = order.reduce((p, i) => segments.setAngle(p, i, String(wanted[i])), doubleDwell);
    deepEqual(anglesOf(typed), wanted, order.join());
    equal(segments.gap(typed), 0);
  }
});

test("an entry changes its row and the one that takes the rest", () => {
  for (const i of [0, 1, 2, 3]) {
    const before = anglesOf(doubleDwell);
    const after = anglesOf(segments.setAngle(doubleDwell, i, "70"));
    equal(after.filter((x, k) => x !== before[k]).length, 2);
  }
});

test("a locked angle stays", () => {
  const locked = { ...doubleDwell, locks: [false, true, false, true] };
  const after = segments.setAngle(locked, 0, "100");
  deepEqual(anglesOf(after), [100, 60, 140, 60]);
  deepEqual(anglesOf(segments.rebalance(segments.setAngle({ ...locked, locks: [true, true, true, true] }, 0, "100"))), [100, 60, 120, 60]);
});

test("an entry that does not fit changes nothing else, and the largest that fits is named", () => {
  const over = segments.setAngle(doubleDwell, 0, "200");
  deepEqual(anglesOf(over), [200, 60, 120, 60]);
  equal(segments.gap(over), -80);
  equal(segments.largest(over, 0), "179 deg");
  deepEqual(anglesOf(segments.setAngle(over, 0, segments.largest(over, 0))), [179, 60, 120, 1]);
});

test("a lift takes its return along, in the unit typed", () => {
  const [up, , down] = segments.setLift(doubleDwell, 0, "0.5 in").rows;
  deepEqual([up.lift, down.lift], ["0.5 in", "-0.5 in"]);
  const [bare, , back] = segments.setLift(doubleDwell, 0, "12,5").rows;
  deepEqual([bare.lift, back.lift], ["12.5 mm", "-12.5 mm"]);
});

test("rows that are added and removed keep the turn covered", () => {
  let p = empty;
  for (let k = 0; k < 5; k += 1) p = segments.add(p, k);
  equal(segments.gap(p), 0);
  equal(p.rows.length, 5);
  for (const i of [0, 3, 1]) p = segments.remove(p, i);
  equal(segments.gap(p), 0);
  equal(p.rows.length, 2);
});

test("a return closes the lifts", () => {
  const one = segments.setMotion(segments.add(empty, 0), 0, "cycloidal");
  equal(segments.rise(one), 20);
  const two = segments.addReturn(one);
  equal(segments.rise(two), 0);
  deepEqual(anglesOf(two), [180, 180]);
});

test("a moved row takes its lock and the rest along", () => {
  const p = { ...doubleDwell, locks: [true, false, false, false], rest: 1 };
  const after = segments.move(p, 1, 0);
  deepEqual([after.locks, after.rest], [[false, true, false, false], 0]);
});

test("texts are measured, and every template covers the turn", () => {
  equal(segments.size("3/8 in").toFixed(6), "9.525000");
  equal(segments.size("90 °"), 90);
  ok(Number.isNaN(segments.size("5 parsec")));
  for (const name of Object.keys(segments.TEMPLATES)) {
    const p = segments.template(empty, name);
    equal(segments.gap(p), 0, name);
    equal(segments.rise(p), 0, name);
  }
});

test("parts of the picture show a gap and an overlap", () => {
  const gap = segments.parts({ ...doubleDwell, rows: doubleDwell.rows.slice(0, 3) });
  deepEqual([gap.list.at(-1).row, gap.list.at(-1).to, gap.whole], [-1, 1, 1]);
  const over = segments.parts(segments.setAngle(doubleDwell, 0, "400"));
  ok(over.whole < 1);
});
