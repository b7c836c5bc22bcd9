// Scenes in links and in exported pages, as packed text with their files. Every copy of the page can open them.
//
// The text is the base64 form of compressed JSON with a checksum before it. A file that is binary or too long for a link is replaced by the
// mean cycle of the recording. If the file itself is available, the page opens the scene with the file.

import { engine } from "./net.js";
import * as blobs from "./blobs.js";

// Maximum size of a file in a link, and of all files in an exported page together, bytes.
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

// FNV-1a checksum, 32 bits, which detects a truncated or changed link.
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

// Value of a packed text; null if the text is damaged. Links of earlier versions have no checksum.
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

// Files that a version uses: files named in its scene or in a pending change, and its recording.
export function used({ scene, pending, files, recording }) {
  const texts = [scene, JSON.stringify(pending.map((p) => p.edits))];
  const isUsed = ([name, hash]) => hash && (name === recording?.file || texts.some((text) => text.includes(JSON.stringify(name))));
  return Object.fromEntries(Object.entries(files).filter(isUsed));
}

// Contents of a file as JSON; null if there is not enough space.
function inJson(contents, isPage, room) {
  const text = contents.length <= (isPage ? room : IN_LINK) ? asText(contents) : null;
  if (text !== null) return text;
  return isPage && contents.length <= room ? { base64: base64(contents) } : null;
}

// Scene with the mean cycle of its recording; null if the engine cannot make one.
async function cycle(v) {
  try {
    return await engine.ask("cycle", { scene: v.scene, files: blobs.listed(v.files) });
  } catch {
    return null;
  }
}

// Version as packed text, and how each of its files is included: `whole`, as `cycle`, or `not`.
export async function pack(v, isPage = false) {
  const files = used(v);
  const held = { scene: v.scene, files: {}, hand: v.hand ?? undefined, recording: v.recording ?? undefined };
  // Values without a design, including rejected ones.
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

// Replaces a recording without space by its mean cycle. `origin` is the scene with the complete file.
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

// Whether a text contains a packed scene, damaged or not.
export const hasScene = (text) => SCENE.test(text);

// Scene in a link or in another text; null if there is none, or if it is damaged.
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
