import { test } from "node:test";
import { equal } from "node:assert/strict";
import { number, unitOf, value } from "../../page/core/typed.js";

test("a bare number gets the unit of its field", () => {
  equal(value("80", "mm"), "80 mm");
  equal(value("80", ""), "80");
  equal(value("-3e-2", "rad"), "-3e-2 rad");
});

test("a decimal comma is a decimal point", () => {
  equal(value("1,85 Hz", "Hz"), "1.85 Hz");
  equal(value("1,85", "Hz"), "1.85 Hz");
});

test("a product is calculated, a single fraction and a product of nothing are not", () => {
  equal(value("2*40 mm", "mm"), "80 mm");
  equal(value("(1+2)*4 mm", "mm"), "12 mm");
  equal(value("3/8 in", "mm"), "3/8 in");
  equal(value("2*", "mm"), "2*");
});

test("a range of two values has no unit", () => {
  equal(unitOf("40 mm"), "mm");
  equal(unitOf("1.4 Hz:2.4 Hz:4"), "");
  equal(unitOf("x"), "");
});

test("every decimal comma of a range is taken, a list keeps its commas", () => {
  equal(value("1,4 Hz:2,4 Hz:4", ""), "1.4 Hz:2.4 Hz:4");
  equal(value("1,2,3", ""), "1,2,3");
});

test("the number of a text with one number", () => {
  equal(number("40 mm"), 40);
  equal(number("0,5 %"), 0.5);
  equal(number("-3e-2 rad"), -0.03);
  for (const text of ["", "auto", "3/8 in", "1.4 Hz:2.4 Hz:4"]) equal(Number.isNaN(number(text)), true, text);
});
