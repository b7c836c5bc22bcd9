// Scenes in links: packed text that any copy of the page can open, with small files inside.

import * as blobs from "./blobs.js";

const LONGEST_FILE = 60000;

async function pass(bytes, through) {
  const stream = new Blob([bytes]).stream().pipeThrough(through);
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

function base64(bytes) {
  let text = "";
  for (let i = 0; i < bytes.length; i += 4096) text += String.fromCharCode(...bytes.subarray(i, i + 4096));
  return btoa(text).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

function bytes(text) {
  const plain = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
  return Uint8Array.from(plain, (c) => c.charCodeAt(0));
}

// Binary contents and long ones do not go into a link.
function asText(contents) {
  if (!contents || contents.length > LONGEST_FILE) return null;
  try {
    return new TextDecoder("utf-8", { fatal: true }).decode(contents);
  } catch {
    return null;
  }
}

// A version as text of a link, and the file of which it holds the mean cycle only.
export async function pack({ scene, files, hand, recording, pending }) {
  const held = { scene, files: {}, hand: hand ?? undefined, recording: recording ?? undefined };
  // Values that no design has answered, refused ones too.
  if (pending.length > 0) held.changes = pending.map((p) => p.edits);
  let shortened = null;
  for (const [name, hash] of Object.entries(files)) {
    if (![scene, JSON.stringify(held.changes ?? [])].some((text) => text.includes(JSON.stringify(name)))) continue;
    const text = asText(await blobs.get(hash));
    if (text !== null) {
      held.files[name] = text;
      continue;
    }
    const cycle = blobs.cycleOf(hash);
    if (!cycle) continue;
    shortened = name;
    const short = `${name.replace(/\.[^.]*$/, "")}_cycle.csv`;
    held.scene = held.scene.replaceAll(JSON.stringify(name), JSON.stringify(short));
    held.files[short] = cycle;
  }
  const text = JSON.stringify(held);
  return { text: base64(await pass(new TextEncoder().encode(text), new CompressionStream("deflate-raw"))), shortened };
}

// The scene of a link or of any text that holds one; null where there is none.
export async function unpack(text) {
  const found = /(?:[#&?]|^)(?:s|scene)=([\w-]+)/.exec(text);
  if (!found) return null;
  try {
    const plain = new TextDecoder().decode(await pass(bytes(found[1]), new DecompressionStream("deflate-raw")));
    const { scene, files = {}, hand = null, recording = null, changes = [] } = JSON.parse(plain);
    if (typeof scene !== "string") return null;
    const hashes = {};
    for (const [name, contents] of Object.entries(files)) hashes[name] = await blobs.put(new TextEncoder().encode(contents));
    return { scene, files: hashes, hand, recording, changes };
  } catch {
    return null;
  }
}
