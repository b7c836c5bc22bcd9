import "./browser.js";
import { test } from "node:test";
import { deepEqual, equal, notEqual } from "node:assert/strict";

const { asText, base64, bytesOf, checksum, compress, decompress, hasScene, used } = await import("../../page/core/packing.js");

test("bytes survive base64 of an address", () => {
  const bytes = Uint8Array.from({ length: 10_000 }, (_, i) => (i * 7919) % 256);
  deepEqual(bytesOf(base64(bytes)), bytes);
  equal(/^[\w-]*$/.test(base64(bytes)), true);
});

test("a packed value is unpacked as it was", async () => {
  const value = { scene: 'name = "día"', files: { "a.csv": "1,2\n3,4\n" } };
  deepEqual(await decompress(await compress(value)), value);
});

test("a link that was cut or changed anywhere is recognised", async () => {
  const packed = await compress({ scene: "x = 1\n".repeat(40), files: { "force.csv": "0,1.25\n0.5,700\n".repeat(20) } });
  for (let cut = 1; cut < packed.length; cut += 3) equal(await decompress(packed.slice(0, cut)), null, `cut at ${cut}`);
  for (let at = 0; at < packed.length; at += 2) {
    const other = packed[at] === "A" ? "B" : "A";
    const changed = await decompress(packed.slice(0, at) + other + packed.slice(at + 1));
    // The last character may have bits that mean nothing.
    if (at < packed.length - 1) equal(changed, null, `changed at ${at}`);
  }
});

test("a link without a checksum, of an earlier version, is read", async () => {
  const stream = new Blob([JSON.stringify({ scene: "a" })]).stream().pipeThrough(new CompressionStream("deflate-raw"));
  const packed = base64(new Uint8Array(await new Response(stream).arrayBuffer()));
  deepEqual(await decompress(packed), { scene: "a" });
});

test("the checksum depends on order and content", () => {
  notEqual(checksum("ab"), checksum("ba"));
  equal(checksum("").length, 8);
});

test("binary contents are no text", () => {
  equal(asText(Uint8Array.of(0xff, 0xfe, 0x00)), null);
  equal(asText(new TextEncoder().encode("µ")), "µ");
});

test("the part of a link that holds a scene is found, damaged or not", () => {
  equal(hasScene("#s=abc"), true);
  equal(hasScene("https://example.org/?x=1#s="), true);
  equal(hasScene("#settings"), false);
});

test("the files of a version are those that its scene, a waiting change or its recording names", () => {
  const files = { "a.csv": "1", "b.csv": "2", "c.c3d": "3", "d.csv": "4", "e.csv": null };
  const version = { scene: 'file = "a.csv"', pending: [{ edits: [{ set: { key: "gait.file", value: "b.csv" } }] }], files, recording: { file: "c.c3d" } };
  deepEqual(used(version), { "a.csv": "1", "b.csv": "2", "c.c3d": "3" });
});
