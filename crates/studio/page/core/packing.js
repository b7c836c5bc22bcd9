// Scenes in links and in exported pages: packed text that any copy of the page can open, with the files inside.
//
// The text is base64 of deflated JSON with a checksum before it. A file that is too long for a link, or binary, is replaced
// by the mean cycle of the recording; where the file itself is at hand, the page opens the scene with it again.

import { engine } from "./net.js";
import * as blobs from "./blobs.js";

// Longest file in a link, and all files of an exported page together, bytes.
const IN_LINK = 60_000;
const IN_PAGE = 8 * 2 ** 20;

async function pass(bytes, through) {
  const stream = new Blob([bytes]).stream().pipeThrough(through);
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

export function base64(bytes) {
  let text = "";
  for (let i = 0; i < bytes.length; i += 4096) text += String.fromCharCode(...bytes.subarray(i, i + 4096));
  return btoa(text).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

export function bytesOf(text) {
  const plain = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
  return Uint8Array.from(plain, (c) => c.charCodeAt(0));
}

// FNV-1a, 32 bits: a link that was cut or changed on its way is recognised.
export function checksum(text) {
  let sum = 0x811c9dc5;
  for (let i = 0; i < text.length; i += 1) sum = Math.imul(sum ^ text.charCodeAt(i), 0x01000193);
  return (sum >>> 0).toString(16).padStart(8, "0");
}

export async function compress(value) {
  const text = JSON.stringify(value);
  const packed = await pass(new TextEncoder().encode(checksum(text) + text), new CompressionStream("deflate-raw"));
  return base64(packed);
}

// The value of a packed text; null where it is damaged. Links of earlier versions have no checksum.
export async function decompress(packed) {
  try {
    const plain = new TextDecoder().decode(await pass(bytesOf(packed), new DecompressionStream("deflate-raw")));
    if (plain.startsWith("{")) return JSON.parse(plain);
    const [sum, text] = [plain.slice(0, 8), plain.slice(8)];
    return sum === checksum(text) ? JSON.parse(text) : null;
  } catch {
    return null;
  }
}

// Contents as text; null for binary ones.
export function asText(contents) {
  try {
    return new TextDecoder("utf-8", { fatal: true }).decode(contents);
  } catch {
    return null;
  }
}

// The files that a version uses: those that its scene or a waiting change names, and its recording.
export function used({ scene, pending, files, recording }) {
  const texts = [scene, JSON.stringify(pending.map((p) => p.edits))];
  const isUsed = ([name, hash]) => hash && (name === recording?.file || texts.some((text) => text.includes(JSON.stringify(name))));
  return Object.fromEntries(Object.entries(files).filter(isUsed));
}

// The contents of a file as JSON; null where there is no room for them.
function inJson(contents, isPage, room) {
  const text = contents.length <= (isPage ? room : IN_LINK) ? asText(contents) : null;
  if (text !== null) return text;
  return isPage && contents.length <= room ? { base64: base64(contents) } : null;
}

// The scene with the mean cycle of its recording; null where the engine cannot make one.
async function cycle(v) {
  try {
    return await engine.ask("cycle", { scene: v.scene, files: blobs.listed(v.files) });
  } catch {
    return null;
  }
}

// A version as packed text, and how each of its files is inside: `whole`, as `cycle` or `not`.
export async function pack(v, isPage = false) {
  const files = used(v);
  const held = { scene: v.scene, files: {}, hand: v.hand ?? undefined, recording: v.recording ?? undefined };
  // Values that no design has answered, refused ones too.
  if (v.pending.length > 0) held.changes = v.pending.map((p) => p.edits);
  const inside = [];
  let room = IN_PAGE;
  for (const [name, hash] of Object.entries(files)) {
    const contents = await blobs.get(hash);
    const whole = contents && inJson(contents, isPage, room);
    if (whole !== null) {
      held.files[name] = whole;
      room -= contents.length;
    }
    inside.push({ name, how: whole === null ? "not" : "whole" });
  }
  if (inside.some((file) => file.how === "not")) await shorten(held, inside, v, files);
  return { text: await compress(held), inside };
}

// Puts the mean cycle in the place of a recording that has no room. `origin` is the scene with the whole file.
async function shorten(held, inside, v, files) {
  const missing = inside.filter((file) => file.how === "not");
  const made = await cycle(v);
  if (!made) return;
  const { recording = null } = held;
  const isInScene = missing.some((file) => file.name === made.file);
  held.origin = { scene: v.scene, files, recording };
  if (isInScene) {
    Object.assign(held, { scene: made.scene });
    held.files[made.use] = made.csv;
  }
  if (recording) held.recording = { ...recording, cycle: isInScene ? made.use : made.file };
  for (const file of missing) if (file.name === made.file || file.name === recording?.file) file.how = "cycle";
}

const SCENE = /(?:[#&?]|^)(?:s|scene)=([\w-]*)/;

// Whether a text has the part of a link that holds a scene, damaged or not.
export const hasScene = (text) => SCENE.test(text);

// The scene of a link or of any text that holds one; null where there is none or where it is damaged.
export async function unpack(text) {
  const found = SCENE.exec(text);
  const held = found && await decompress(found[1]);
  if (typeof held?.scene !== "string") return null;
  const { files = {}, hand = null, recording = null, changes = [], origin = null } = held;
  if (origin && await blobs.hasAll(origin.files)) return { ...origin, hand, changes };
  const hashes = {};
  for (const [name, contents] of Object.entries(files)) {
    const bytes = contents.base64 === undefined ? new TextEncoder().encode(contents) : bytesOf(contents.base64);
    hashes[name] = await blobs.put(bytes);
  }
  return { scene: held.scene, files: hashes, hand, recording, changes };
}
