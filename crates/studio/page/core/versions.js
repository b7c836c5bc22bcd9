// State of the page: an immutable list of versions, the index of the displayed version, and the pinned designs. Undo, redo, links, reload
// and autosave use only this state.
//
// A version consists of
//   scene      text of the scene without the pending changes
//   name       name of the scene
//   pending    changes without a design, or rejected changes: {edits, keys, gesture, fault}
//   fault      reason why the scene itself cannot be designed; null if it can, or if this is not known yet
//   files      hash of the contents of each file, by the name of the file in the scene
//   line       number of the version in which this scene was opened; versions with the same line are states of one scene
//   recording  {file, without, cycle}: the recording, its excluded contacts, and the file of the mean cycle if only this file is available
//   hand       {period_s, points}: the force drawn by hand
//   programme  {locks, rest, last, former}: locked angles, the segment that takes the rest, the segment changed last, and the values that
// the
//              programme replaced
//   gesture    name of the gesture that made the version; a later change of the same gesture replaces the version
//   title      text for the list of versions, with the changed values in `made`

const LONGEST = 300;
let number = 0;
let present = { list: [], at: -1, pins: [] };
const watchers = [];

export const now = () => present.list[present.at] ?? null;
export const history = () => present;
export const canUndo = () => present.at > 0;
export const canRedo = () => present.at + 1 < present.list.length;

export function watch(watcher) {
  watchers.push(watcher);
}

function become(next) {
  present = Object.freeze(next);
  for (const watcher of watchers) watcher(present);
}

function version(content) {
  number += 1;
  const empty = { name: "", pending: [], fault: null, files: {}, recording: null, hand: null, gesture: null, title: "", made: [] };
  return Object.freeze({ ...empty, line: number, ...content, id: number });
}

// Adds a version after the present one. If both belong to one gesture, the new version replaces the present one.
function push(next) {
  const same = next.gesture !== null && now()?.gesture === next.gesture;
  const list = present.list.slice(0, same ? present.at : present.at + 1).slice(-LONGEST);
  become({ ...present, list: [...list, next], at: list.length });
}

const SEGMENTS = "law.segment";
const keyOf = (e) => (e.programme ? SEGMENTS : e.set ? e.set.key : JSON.stringify(e));
const keysOf = (edits) => edits.map(keyOf);
// A whole programme also replaces the values of its segments.
const replaced = (keys) => (key) => keys.includes(key) || (keys.includes(SEGMENTS) && key.startsWith(`${SEGMENTS}.`));

// Changes values. `more` contains the files, the recording and the drawn force that belong to them.
/** @param {any[]} edits @param {string | null} gesture @param {any} more */
export function edit(edits, gesture, { title = "", ...more } = {}) {
  const before = now();
  const keys = keysOf(edits);
  // A new value replaces a pending or rejected value of the same key.
  const others = before.pending.filter((p) => !p.keys.every(replaced(keys)));
  const next = Object.freeze({ edits, keys, gesture, fault: null });
  const made = edits.filter((e) => e.set).map((e) => e.set);
  // A force file selected by its name is neither a recording with excluded contacts nor a drawn force.
  if (keys.includes("gait.file") && !more.files) more = { recording: null, hand: null, ...more };
  const files = { ...before.files, ...more.files };
  push(version({ ...before, ...more, pending: [...others, next], gesture, title, made, files }));
}

// Adds a version without a changed value of the scene.
export function note(more) {
  push(version({ ...now(), ...more, gesture: null, made: [] }));
}

// Opens another scene. Undo returns to the present one.
export function open(scene, { files = {}, name = "", title = "", recording = null, hand = null, changes = [] } = {}) {
  const pending = changes.map((edits) => Object.freeze({ edits, keys: keysOf(edits), gesture: null, fault: null }));
  push(version({ scene, name, title, files, recording, hand, pending }));
}

// Stores the response of the engine to a version: its scene, the rejected changes, and the fault of the scene itself.
export function settle(id, { scene, name, pending, fault = null }) {
  const i = present.list.findIndex((v) => v.id === id);
  if (i < 0) return;
  const list = [...present.list];
  list[i] = Object.freeze({ ...list[i], scene, name, pending, fault });
  // Later versions with the same pending changes keep them, because each version is requested separately.
  become({ ...present, list });
}

// Withdraws a rejected change, as a new version.
export function withdraw(change) {
  const before = now();
  push(version({ ...before, pending: before.pending.filter((p) => p !== change), gesture: null, made: [] }));
}

export function goTo(at) {
  if (at < 0 || at >= present.list.length || at === present.at) return false;
  become({ ...present, at });
  return true;
}

export const undo = () => goTo(present.at - 1);
export const redo = () => goTo(present.at + 1);

export function pin(entry) {
  become({ ...present, pins: [...present.pins, Object.freeze(entry)] });
}

export function setPins(pins) {
  become({ ...present, pins });
}

// Whether the version contains a value that its design does not have.
export const refused = (v) => Boolean(v?.fault) || Boolean(v?.pending.some((p) => p.fault));

// --- storage for a reload -------------------------------------------------------------------------

const KEPT = "gaitcam-versions";
// Latest addresses that this page has written. A reload may start before the last one is written.
let addresses = [];

export function written(address) {
  addresses = [...addresses.filter((a) => a !== address), address].slice(-8);
}

export function keep() {
  try {
    // Only the inputs of pinned designs are stored. Their designs are requested again.
    const plain = ({ scene, files, name, colour, hand, recording }) => ({ scene, files, name, colour, hand, recording });
    const pins = present.pins.map(plain);
    sessionStorage.setItem(KEPT, JSON.stringify({ ...present, pins, addresses }));
  } catch { /* The storage is full or private. The address still contains the scene. */ }
}

// Restores the versions after a reload, unless the address contains another scene. Returns whether it did.
export function restore() {
  try {
    const kept = JSON.parse(sessionStorage.getItem(KEPT));
    const [entry] = /** @type {any[]} */ (performance.getEntriesByType("navigation"));
    if (!kept?.list?.length || entry.type === "navigate" || !kept.addresses.includes(location.hash)) return false;
    number = Math.max(...kept.list.map((v) => v.id));
    const { list, at, pins } = kept;
    addresses = kept.addresses;
    become({ list: list.map(Object.freeze), at, pins });
    return true;
  } catch {
    return false;
  }
}
