// The state of the page: an immutable list of versions, which of them is shown, and the designs that are pinned.
// Undo, redo, links, reload and autosave only read it.
//
// A version is
//   scene      text of the scene without the values below
//   name       name of the scene
//   pending    changes that no design has answered yet, or that were refused: {edits, keys, gesture, fault}
//   fault      why the scene itself cannot be designed; null where it can or where that is not known yet
//   files      hash of the contents by the name that the scene gives to the file
//   line       number of the version at which this scene was opened: versions of one line are one scene that was changed
//   recording  {file, without, cycle}: the recording, the contacts that do not count, and the file of the mean cycle where
//              only that is at hand
//   hand       {period_s, points}: the force drawn by hand
//   programme  {locks, rest, last, former}: angles that are locked, the segment that takes the rest, the one typed last,
//              and the values that the programme took the place of
//   gesture    what made it: a later change of the same gesture takes its place
//   title      what changed, and `made` the values, for the list of versions

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

// Adds a version after the present one; of the same gesture it takes the present one's place.
function push(next) {
  const same = next.gesture !== null && now()?.gesture === next.gesture;
  const list = present.list.slice(0, same ? present.at : present.at + 1).slice(-LONGEST);
  become({ ...present, list: [...list, next], at: list.length });
}

const SEGMENTS = "law.segment";
const keyOf = (e) => (e.programme ? SEGMENTS : e.set ? e.set.key : JSON.stringify(e));
const keysOf = (edits) => edits.map(keyOf);
// A whole programme replaces values of its segments too.
const replaced = (keys) => (key) => keys.includes(key) || (keys.includes(SEGMENTS) && key.startsWith(`${SEGMENTS}.`));

// Changes values; `more` are the files, the recording and the drawn force that come with them.
/** @param {any[]} edits @param {string | null} gesture @param {any} more */
export function edit(edits, gesture, { title = "", ...more } = {}) {
  const before = now();
  const keys = keysOf(edits);
  // A new value takes the place of one that waits or was refused under the same key.
  const others = before.pending.filter((p) => !p.keys.every(replaced(keys)));
  const next = Object.freeze({ edits, keys, gesture, fault: null });
  const made = edits.filter((e) => e.set).map((e) => e.set);
  // A force chosen by its name is neither a recording with ticks nor a drawn one.
  if (keys.includes("gait.file") && !more.files) more = { recording: null, hand: null, ...more };
  const files = { ...before.files, ...more.files };
  push(version({ ...before, ...more, pending: [...others, next], gesture, title, made, files }));
}

// A step that changes no value of the scene.
export function note(more) {
  push(version({ ...now(), ...more, gesture: null, made: [] }));
}

// Another scene; the present one can be returned to.
export function open(scene, { files = {}, name = "", title = "", recording = null, hand = null, changes = [] } = {}) {
  const pending = changes.map((edits) => Object.freeze({ edits, keys: keysOf(edits), gesture: null, fault: null }));
  push(version({ scene, name, title, files, recording, hand, pending }));
}

// What the engine answered about a version: its scene, the changes that were refused, the fault of the scene itself.
export function settle(id, { scene, name, pending, fault = null }) {
  const i = present.list.findIndex((v) => v.id === id);
  if (i < 0) return;
  const list = [...present.list];
  list[i] = Object.freeze({ ...list[i], scene, name, pending, fault });
  // Later versions that were built on the same unanswered changes keep them: they are asked in turn.
  become({ ...present, list });
}

// Takes one refused change back; a step of its own.
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

// Whether the version shows a value that is not in its design.
export const refused = (v) => Boolean(v?.fault) || Boolean(v?.pending.some((p) => p.fault));

// --- kept over a reload ---------------------------------------------------------------------------

const KEPT = "gaitcam-versions";
// Addresses that this page has written: a reload may have begun before the latest one.
let addresses = [];

export function written(address) {
  addresses = [...addresses.filter((a) => a !== address), address].slice(-8);
}

export function keep() {
  try {
    // Of the pins only what a design is made from: their pictures are asked again.
    const plain = ({ scene, files, name, colour, hand, recording }) => ({ scene, files, name, colour, hand, recording });
    const pins = present.pins.map(plain);
    sessionStorage.setItem(KEPT, JSON.stringify({ ...present, pins, addresses }));
  } catch { /* no room, or a private window: the address still holds the scene */ }
}

// Restores what a reload left behind, unless the address names another scene; returns whether it did.
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
