// The state of the page: the scene, what is being changed in it, its past and future, the address that holds it.

const past = [];
const future = [];
let scene = "";
let changes = [];
let files = {};
const cycles = {};
let writing = 0;

const LONGEST_FILE = 60000;

export const state = {
  get scene() { return scene; },
  get changes() { return changes; },
  get files() { return files; },
  get canUndo() { return past.length > 0 || changes.length > 0; },
  get canRedo() { return future.length > 0; },
};

// What a change is about: a later one on the same value takes its place.
function about(change) {
  return change.set ? "set " + change.set.key : null;
}

export function change(list) {
  for (const next of list) {
    const same = about(next) && changes.findIndex((c) => about(c) === about(next));
    // Only the last change may be replaced: one before another may be what that one builds on.
    if (typeof same === "number" && same >= 0 && same === changes.length - 1) changes[same] = next;
    else changes.push(next);
  }
}

// A design came back for these changes: its scene is the present one.
export function settle(text, applied) {
  scene = text;
  changes = changes.slice(applied);
  write();
}

// The state before this step can be returned to.
export function step(before) {
  if (past.at(-1) === before) return;
  past.push(before);
  future.length = 0;
}

export function undo() {
  if (changes.length > 0) {
    changes = [];
    if (past.at(-1) === scene) past.pop();
    return scene;
  }
  const before = past.pop();
  if (before === undefined) return null;
  future.push(scene);
  scene = before;
  return scene;
}

export function redo() {
  const next = future.pop();
  if (next === undefined) return null;
  past.push(scene);
  changes = [];
  scene = next;
  return scene;
}

// Another scene altogether; the old one can be returned to.
export function replace(text, keep = true) {
  if (keep && scene && scene !== text) step(scene);
  scene = text;
  changes = [];
}

export function addFile(name, text) {
  if (text.length <= LONGEST_FILE) files[name] = text;
}

// The mean cycle of a recording that is too large for a link or binary.
export function addCycle(name, csv) {
  cycles[name] = { name: `${name.replace(/\.[^.]*$/, "")}_cycle.csv`, csv };
}

// --- the address ---------------------------------------------------------------------------------

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

const named = (name) => scene.includes(JSON.stringify(name));

// The scene with the files that it names, small enough for a link: of a large or binary recording the mean cycle.
function portable() {
  const held = { scene, files: Object.fromEntries(Object.entries(files).filter(([name]) => named(name))) };
  for (const [name, cycle] of Object.entries(cycles)) {
    if (!named(name) || held.files[name]) continue;
    held.scene = held.scene.replaceAll(JSON.stringify(name), JSON.stringify(cycle.name));
    held.files[cycle.name] = cycle.csv;
  }
  return held;
}

// Whether a link would hold a recording's mean cycle in its place.
export function shortened() {
  return Object.keys(cycles).find((name) => named(name) && !files[name]);
}

export async function packed() {
  const text = JSON.stringify(portable());
  return base64(await pass(new TextEncoder().encode(text), new CompressionStream("deflate-raw")));
}

// The scene of the page's address, if it has one.
export async function fromAddress() {
  const found = /[#&]scene=([\w-]+)/.exec(location.hash);
  if (!found) return null;
  try {
    const text = new TextDecoder().decode(await pass(bytes(found[1]), new DecompressionStream("deflate-raw")));
    const held = JSON.parse(text);
    files = held.files ?? {};
    return held.scene;
  } catch {
    return null;
  }
}

function write() {
  clearTimeout(writing);
  writing = setTimeout(async () => {
    const place = new URL(location.href);
    place.hash = "scene=" + await packed();
    history.replaceState(null, "", place);
  }, 250);
}
