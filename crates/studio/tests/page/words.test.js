import "./browser.js";
import { test } from "node:test";
import { equal } from "node:assert/strict";

const { number, quantity } = await import("../../page/core/words.js");

test("numbers have at most four digits and no trailing zeros", () => {
  equal(number(48.19177), "48.19");
  equal(number(20), "20");
  equal(number(0), "0");
  equal(number(-0.5), "−0.5");
  equal(number(0.00001234), "1.234e−5");
  equal(number(2.5e9), "2.5e9");
  equal(number(NaN), "–");
});

test("degrees stand close to their number, other units after a blank", () => {
  equal(quantity(30, "°"), "30°");
  equal(quantity(30, "mm"), "30\u00a0mm");
  equal(quantity(null, "mm"), "–");
});
