import "./browser.js";
import assert from "node:assert/strict";
import { test } from "node:test";

const { differing, given, nameOf, nearest, valuesAbout } = await import("../../page/panels/fields.js");
const { ticks, tickText } = await import("../../page/charts/ticks.js");
const { isDark, shade } = await import("../../page/charts/shade.js");
const { load } = await import("../../page/core/words.js");
load({ en: { "studio-key-limits-stroke": "Stroke" }, es: {} });

const scene = (stroke) => ({ name: "footbridge", inputs: { name: "footbridge", "limits.stroke": stroke, "cam.bore": "12 mm" } });

test("a design is named by what differs from the last one pinned", () => {
  assert.equal(nameOf(scene("60 mm"), []), "footbridge");
  const first = { ...scene("60 mm"), name: "footbridge" };
  assert.equal(nameOf(scene("40 mm"), [first]), "footbridge, Stroke 40 mm");
  assert.equal(nameOf(scene("60 mm"), [first]), "footbridge (2)");
});

test("only values that are not the same everywhere differ", () => {
  assert.deepEqual(differing([scene("60 mm"), scene("40 mm")]), [["limits.stroke", ["60 mm", "40 mm"]]]);
});

test("entries of lists are given by their numbers", () => {
  const text = (t) => ({ text: t });
  const found = given({ name: text("a"), "law.family": text(""), "cam.bore": text("12 mm"), "law.segment.1.lift": text("5 mm"), "law.segment.1.angle": text("60 deg") });
  assert.deepEqual(found.single, [["cam.bore", "12 mm"]]);
  assert.deepEqual(found.entries, [["law.segment.1", [["lift", "5 mm"], ["angle", "60 deg"]]]]);
});

test("the axis of a map runs from half to one and a half within the slider", () => {
  const list = valuesAbout({ from: 20, to: 80, at: 60, unit: " mm" }, 3);
  assert.deepEqual(list, ["30 mm", "55 mm", "80 mm"]);
  assert.equal(nearest(list, 60), 1);
  assert.equal(nearest(list, 200), -1);
});

test("ticks are round, inside the axis, and two at least", () => {
  for (const [low, high] of [[0, 1], [-0.00031, 0.00027], [480, 1100], [-3, 3e5]]) {
    const all = ticks(low, high, 5);
    assert.ok(all.length >= 2 && all.every((x) => x >= low - 1e-12 && x <= high + 1e-9 * high), `${low} ${high} ${all}`);
  }
  assert.equal(tickText(0.00025, [0, 0.00025]), "0.00025");
});

test("a scale of colours has two ends", () => {
  assert.equal(shade(0), "rgb(68 1 84)");
  assert.match(shade(1), /^rgb\(253 231 37\)$/);
});

test("black or white text is read on every colour of the scale", () => {
  const light = (text) => text.match(/\d+/g).map((c) => (c <= 10 ? c / 3295 : ((c / 255 + 0.055) / 1.055) ** 2.4))
    .reduce((sum, c, k) => sum + c * [0.2126, 0.7152, 0.0722][k], 0);
  for (let u = 0; u <= 1; u += 0.01) {
    const ground = light(shade(u)) + 0.05;
    assert.ok((isDark(u) ? 1.05 / ground : ground / 0.05) >= 4.5, `${u}`);
  }
});
