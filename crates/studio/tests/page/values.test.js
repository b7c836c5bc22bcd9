import "./browser.js";
import { test } from "node:test";
import { equal, deepEqual } from "node:assert/strict";

const { borders, stretches } = await import("../../page/panels/possible.js");
const { extent, forgetEnds, setEnd, written } = await import("../../page/panels/slider.js");
const { typeset } = await import("../../page/core/units.js");

const POINTS = [[1, "fault"], [2, "infeasible"], [3, "unacceptable"], [4, "acceptable"], [5, "acceptable"], [6, "not-for-high-speed"]];

test("values that cannot be had are one stretch, whatever the reason", () => {
  deepEqual(stretches(POINTS), [["none", 1, 3], ["acceptable", 4, 5], ["not-for-high-speed", 6, 6]]);
  deepEqual(borders(POINTS).map(([a, b]) => [a[0], b[0]]), [[3, 4], [5, 6]]);
});

test("the ends of a slider stay until its value leaves them", () => {
  forgetEnds();
  const slider = (at, from = 0, to = 100) => ({ at, from, to, step: 0.1, unit: " mm" });
  equal(extent("k", slider(60)).to, 100);
  equal(extent("k", slider(90, 0, 200)).to, 100);
  setEnd("k", slider(90), "to", "150,5");
  equal(extent("k", slider(90)).to, 150.5);
  setEnd("k", slider(90), "to", "5");
  equal(extent("k", slider(90)).to, 90);
  equal(extent("k", slider(300, 0, 500)).to, 500);
});

test("a value is written with the decimals of its step", () => {
  equal(written(61.2345, { step: 0.1, unit: " mm" }), "61.2 mm");
  equal(written(4.0001, { step: 1, unit: "" }), "4");
});

test("units are printed with raised powers", () => {
  equal(typeset("3 m/s^2"), "3 m/s²");
  equal(typeset("30 deg"), "30°");
  equal(typeset("2 kg m^2"), "2 kg m²");
});
