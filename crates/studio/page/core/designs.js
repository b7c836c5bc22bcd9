// Requests for the design of the present version, one at a time. Intermediate states of a gesture may be skipped, but not the last one. A
// rejected change stays with its version, and the other changes are applied.

import { engine, Fault } from "./net.js";
import * as blobs from "./blobs.js";
import * as versions from "./versions.js";

const AGAIN = 2000;
// If a design takes longer than LONG, a quick design within the limits is requested while a value is being changed. The optimum is
// requested after a pause of REST. Both in ms.
const LONG = 100;
const REST = 250;
let slow = false;
let whole = true;
let refining = false;
let running = null;
let waiting = null;
let shown = null;
// Prime radius and offset of the last complete design, m.
let size = null;
let retry = 0;
// Fields of the form: from the last design, or, if the scene has no design, from the reading of the scene.
let fields = {};
/** @type {Record<string, (...all: any[]) => any>} */
const handlers = { show: () => {}, state: () => {}, working: () => {}, lost: () => {}, colour: () => "none" };

export function on(more) {
  Object.assign(handlers, more);
}

// Displayed response with its version; null if the version belongs to another scene.
export const present = () => (isForeign() ? null : shown);

// Whether the displayed picture belongs to another scene.
export const isForeign = () => shown !== null && shown.line !== versions.now()?.line;

export const known = () => fields;

// Forgets the fields, which belong to another scene.
export function forget() {
  fields = {};
}

// Whether the complete design of the present version is displayed.
export function isCurrent() {
  const v = versions.now();
  if (shown?.answer.quick) return false;
  return Boolean(v) && v.pending.length === 0 && !v.fault && shown?.version === v.id;
}

// Requests the design of the present version. `since` is the time of the input, ms.
export function ask(since = performance.now()) {
  clearTimeout(retry);
  // A complete design is useless while its value is still being changed.
  if (running && refining) stop();
  whole = false;
  if (running) waiting = since;
  else run(since);
  handlers.state();
}

// Requests the design at once. A running request is stopped, because it belongs to another version.
export function askAnew(since = performance.now()) {
  stop();
  ask(since);
}

function stop() {
  running?.abort();
  running = null;
  waiting = null;
}

// Stops the present request. Its version stays without a response.
export function cancel() {
  stop();
  handlers.working(false, 0);
  handlers.state();
}

async function run(since) {
  const quick = slow && !whole && versions.now().gesture !== null && size !== null;
  refining = whole && slow;
  let rests = false;
  const control = new AbortController();
  running = control;
  const v = versions.now();
  handlers.working(true, since);
  try {
    // If no file is missing, the request is sent without delay.
    const missing = blobs.ensure(v.files);
    if (missing) await missing;
    const outcome = await settle(v, control.signal, quick);
    if (running !== control) return;
    versions.settle(v.id, outcome);
    const known_ = outcome.answer?.fields ?? outcome.fields;
    fields = known_ ?? (outcome.same ? shown.answer.fields : outcome.fault ? {} : fields);
    const more = waiting !== null;
    if (outcome.answer) {
      const { quick: held, numbers } = outcome.answer;
      if (!held) size = numbers.prime_radius_m ? [numbers.prime_radius_m, numbers.offset_m ?? 0] : null;
      slow = held || outcome.answer.server_ms > LONG;
      rests = held && !more;
      if (rests) retry = setTimeout(refine, REST);
      shown = { version: v.id, line: v.line, answer: outcome.answer, files: v.files };
      // If designs are slow, the next one is requested before the last one is drawn. If they are fast, the next request is sent afterwards
      // with the latest value.
      if (more && slow) next();
      await handlers.show(outcome.answer, since, more);
    } else if (outcome.same) shown = { ...shown, version: v.id };
    handlers.state();
  } catch (error) {
    if (error.name === "AbortError" || running !== control) return;
    if (!(error instanceof Fault)) throw error;
    handlers.lost(error);
    retry = setTimeout(() => ask(since), AGAIN);
  } finally {
    if (running === control) {
      running = null;
      if (waiting !== null) next();
      else if (!rests) handlers.working(false, since);
    }
  }
}

function refine() {
  whole = true;
  run(performance.now());
}

function next() {
  const since = waiting;
  waiting = null;
  run(since);
}

// Requests a version with some of its changes. A fault of the scene is a result. A failure of the engine is an exception.
async function tried(route, v, groups, signal, quick = false) {
  const changes = groups.flatMap((p) => p.edits);
  try {
    const question = { scene: v.scene, changes, files: blobs.listed(v.files) };
    if (route === "design") question.colour = handlers.colour();
    if (quick) question.quick = size;
    return { answer: await engine.ask(route, question, { signal }) };
  } catch (error) {
    if (route === "read" && /** @type {any} */ (error).code === "http") return {};
    const { code } = /** @type {any} */ (error);
    if (!(error instanceof Fault) || code === "lost" || code === "http") throw error;
    return { fault: plain(/** @type {any} */ (error)) };
  }
}

const plain = ({ code, key, place, message, help, remedies }) => ({ code, key, place, message, help, remedies });

// Requests the version with all its changes. If this is rejected, only the valid changes are applied.
async function settle(v, signal, quick) {
  const all = await tried("design", v, v.pending, signal, quick);
  if (all.answer) return { scene: all.answer.scene, name: all.answer.name, pending: [], answer: all.answer };
  if (v.fault || v.pending.length === 0) return unfinished(v, all.fault, signal);
  const taken = [];
  const left = [];
  let best = null;
  for (const change of v.pending) {
    const alone = v.pending.length === 1;
    const known = change.fault && taken.length === 0;
    const result = alone ? all : known ? { fault: change.fault } : await tried("design", v, [...taken, change], signal);
    if (result.answer) {
      taken.push(change);
      best = result.answer;
    } else left.push(Object.freeze({ ...change, fault: result.fault }));
  }
  if (best) return { scene: best.scene, name: best.name, pending: left, answer: best };
  return base(v, left, signal);
}

// No change is valid: the displayed design is that of the scene without the changes.
async function base(v, left, signal) {
  const same = present()?.answer.scene === v.scene && JSON.stringify(shown.files) === JSON.stringify(v.files);
  if (same) return { scene: v.scene, name: v.name, pending: left, same };
  const { answer, fault } = await tried("design", v, [], signal);
  const read = answer ?? (await tried("read", v, [], signal)).answer;
  return { scene: v.scene, name: read?.name ?? v.name, fields: read?.fields, pending: left, answer, fault };
}

// The scene cannot be designed yet: its fields are read without a design.
async function unfinished(v, fault, signal) {
  const left = [];
  const taken = [];
  let read = null;
  for (const change of v.pending) {
    const result = await tried("read", v, [...taken, change], signal);
    if (result.answer) {
      taken.push(change);
      read = result.answer;
    } else if (!result.fault) left.push(change);
    else left.push(Object.freeze({ ...change, fault: result.fault }));
  }
  read ??= (await tried("read", v, [], signal)).answer;
  return { scene: read?.scene ?? v.scene, name: read?.name ?? v.name, fields: read?.fields, pending: left, fault };
}
