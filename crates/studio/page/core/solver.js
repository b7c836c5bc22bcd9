// One question at a time; of those that wait only the latest is asked. Intermediate states may be skipped, the last
// never.

import { post, Fault } from "./net.js";
import { state, settle } from "./store.js";

export const page = Math.random().toString(36).slice(2);
let number = 0;
let running = null;
let waiting = null;
const handlers = { show: () => {}, fault: () => {}, working: () => {}, colour: () => "none" };

export function on(more) {
  Object.assign(handlers, more);
}

// Asks for the design of the present state. `since` is when the input came.
export function ask(since = performance.now()) {
  if (running) {
    waiting = since;
    return;
  }
  run(since);
}

async function run(since) {
  number += 1;
  const mine = number;
  const applied = state.changes.length;
  const control = new AbortController();
  running = control;
  handlers.working(true, since);
  try {
    const question = { scene: state.scene, changes: state.changes, page, number: mine, colour: handlers.colour() };
    const answer = await post("design", question, control.signal);
    if (mine === number && !answer.superseded) {
      const more = waiting !== null;
      // The next answer is on its way while this one is drawn.
      if (more) next();
      else settle(answer.scene, applied);
      await handlers.show(answer, since, more);
    }
  } catch (error) {
    if (error.name === "AbortError" || mine !== number) return;
    if (error instanceof Fault) handlers.fault(error);
    // What fetch throws where nobody answers; anything else is a mistake of the page.
    else if (error instanceof TypeError && /fetch|network|load/i.test(error.message)) handlers.fault(new Fault({ code: "lost", message: "" }));
    else throw error;
  } finally {
    if (running === control) {
      running = null;
      if (waiting !== null) next();
      else handlers.working(false, since);
    }
  }
}

// Asks what waits.
function next() {
  const since = waiting;
  waiting = null;
  run(since);
}

// Leaves the present question unanswered.
export function cancel() {
  const control = running;
  running = null;
  waiting = null;
  number += 1;
  control?.abort();
  // The server's search ends too.
  if (control) post("cancel", { page, number }).catch(() => {});
  handlers.working(false, 0);
}
