import "./browser.js";
import { test } from "node:test";
import { deepEqual, equal } from "node:assert/strict";

const { changesFor, chosen, load, nameFor, options, remember, stem } = await import("../../page/core/answers.js");

const field = (text) => ({ text, acts: true });
const version = (file, hash) => ({ files: { [file]: hash }, recording: { file, without: [] }, pending: [], name: "walk" });
const keys = (changes) => Object.fromEntries(changes.map(({ set }) => [set.key, set.value]));

test("another recording loses the answers of the former one and gets its own", () => {
  const first = version("a.c3d", "ha");
  remember(first, { "gait.accept": field("mass"), "gait.kind": field("running"), "gait.feet": field("both") });
  deepEqual(keys(changesFor("hb", first, { "gait.accept": field("mass"), "gait.kind": field("running") })), { "gait.accept": "", "gait.kind": "" });
  const second = version("b.mot", "hb");
  deepEqual(keys(changesFor("ha", second, {})), { "gait.kind": "running", "gait.accept": "mass" });
});

test("a waiting answer goes too", () => {
  const before = { ...version("c.csv", "hc"), pending: [{ keys: ["gait.force"] }] };
  deepEqual(keys(changesFor("hd", before, {})), { "gait.force": "" });
});

test("feet are an answer only where they were chosen as one", () => {
  const before = version("d.csv", "hf");
  deepEqual(changesFor("hg", before, { "gait.feet": field("left") }), []);
  chosen(before, "gait.feet", "one");
  deepEqual(keys(changesFor("hg", before, { "gait.feet": field("one") })), { "gait.feet": "" });
});

test("how a recording is read is what the scene writes", () => {
  deepEqual(options({ "gait.rate": field("100 Hz"), "gait.accept": field("mass"), "gait.mass": field("") }), { rate: "100 Hz" });
});

test("a scene is named after its recording unless the user has named it", () => {
  load(["footbridge"]);
  equal(stem("My walk (1).c3d"), "My_walk_1");
  equal(nameFor("b.mot", { name: "footbridge" }), "b");
  equal(nameFor("b.mot", { name: "a", recording: { file: "a.c3d" } }), "b");
  equal(nameFor("b.mot", { name: "mine", recording: { file: "a.c3d" } }), null);
});
