// Which question is asked: the design of the present version, one at a time. Intermediate states of a gesture may be
// skipped, the last never. A change that is refused stays with its version; the others go on.

import { engine, Fault } from "./net.js";
import * as blobs from "./blobs.js";
import * as versions from "./versions.js";

const AGAIN = 2000;
// Where a design takes longer, a first law that keeps the limits is asked for while a value is moved, and the best when the
// hand has rested, ms.
const LONG = 100;
const REST = 250;
let slow = false;
let whole = true;
let refining = false;
let running = null;
let waiting = null;
let shown = null;
// Prime radius and offset of the last whole design, m.
let size = null;
let retry = 0;
// Fields of the form: those of the last design or, where the scene has none, those that could be read of it.
let fields = {};
/** @type {Record<string, (...all: any[]) => any>} */
const handlers = { show: () => {}, state: () => {}, working: () => {}, lost: () => {}, colour: () => "none" };

export function on(more) {
  Object.assign(handlers, more);
}

// The answer on the screen, with the version that it belongs to; null where that is a version of another scene.
export const present = () => (isForeign() ? null : shown);

// Whether the picture on the screen is that of another scene.
export const isForeign = () => shown !== null && shown.line !== versions.now()?.line;

export const known = () => fields;

// Another scene: nothing is known of its fields.
export function forget() {
  fields = {};
}

// The design of the present version is shown, whole.
export function isCurrent() {
  const v = versions.now();
  if (shown?.answer.quick) return false;
  return Boolean(v) && v.pending.length === 0 && !v.fault && shown?.version === v.id;
}

// Asks for the design of the present version. `since` is when the input came.
export function ask(since = performance.now()) {
  clearTimeout(retry);
  // A whole design of a value that is moved on is of no use.
  if (running && refining) stop();
  whole = false;
  if (running) waiting = since;
  else run(since);
  handlers.state();
}

// Asks at once: what runs belongs to another version.
export function askAnew(since = performance.now()) {
  stop();
  ask(since);
}

function stop() {
  running?.abort();
  running = null;
  waiting = null;
}

// Leaves the present question unanswered: the version stays pending.
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
    // Where nothing is missing the question leaves at once.
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
      // A long answer is on its way while the last one is drawn; a short one is asked for with the value of the moment.
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

// A question about a version with some of its changes; faults of the scene are answers, a lost engine is not.
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

// The version with all its changes; where that is refused, with those that can be taken.
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

// Nothing can be taken: the picture is that of the scene before the changes.
async function base(v, left, signal) {
  const same = present()?.answer.scene === v.scene && JSON.stringify(shown.files) === JSON.stringify(v.files);
  if (same) return { scene: v.scene, name: v.name, pending: left, same };
  const { answer, fault } = await tried("design", v, [], signal);
  const read = answer ?? (await tried("read", v, [], signal)).answer;
  return { scene: v.scene, name: read?.name ?? v.name, fields: read?.fields, pending: left, answer, fault };
}

// The scene itself cannot be designed yet: what can be read of it is taken.
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
