// The engine inside the page, in workers: one for what follows the hand, one for what takes longer, and one with the whole
// module for files, runs and recordings, loaded when the first of them is asked for.

// A search ends itself after 60 s; a worker that is silent longer has been ended by the browser, ms.
const PATIENCE = 75000;
const SILENT = "no answer";

const inline = (id) => document.getElementById(id)?.textContent;
const unpack = (stream) => stream.pipeThrough(new DecompressionStream("gzip"));

// The page in one file carries the whole module as text; a page in a folder has both beside it, and keeps them for visits
// without a network where the browser can.
async function packed(name) {
  const text = inline("engine-module");
  if (text) return new Blob([Uint8Array.from(atob(text.trim()), (c) => c.charCodeAt(0))]).stream();
  const response = await fetch(new URL(`engine/${name}.wasm.gz`, document.baseURI));
  if (name === "engine" && location.protocol.startsWith("http")) keepForNextVisit();
  return response.body;
}

function keepForNextVisit() {
  const workers = navigator.serviceWorker;
  workers?.register(new URL("service_worker.js", document.baseURI)).catch(() => {});
  workers?.ready.then(({ active }) => active.postMessage("later"));
}

const compiled = {};
const module = (name) => compiled[name] ??= packed(name).then((stream) =>
  WebAssembly.compileStreaming(new Response(unpack(stream), { headers: { "Content-Type": "application/wasm" } })));

function worker() {
  const text = inline("engine-worker");
  const url = text ? URL.createObjectURL(new Blob([text], { type: "text/javascript" })) : new URL("engine/worker.js", document.baseURI);
  return new Worker(url);
}

// Questions wait here, not in the worker: one that is given up while it waits ends no work. A worker that fails, or that
// is silent longer than any question may take, is ended; the next question begins another one.
export class Lane {
  waiting = [];
  busy = null;
  worker = null;
  clock = 0;

  // `begun` gives a worker that is ready for questions, `patience` is in milliseconds.
  constructor(begun, patience = PATIENCE) {
    this.begun = begun;
    this.patience = patience;
  }

  ask(message, signal) {
    return new Promise((resolve, reject) => {
      const job = { message, resolve, reject };
      signal?.addEventListener("abort", () => this.abort(job, signal.reason));
      if (signal?.aborted) return reject(signal.reason);
      this.waiting.push(job);
      this.next();
    });
  }

  async next() {
    if (this.busy || this.waiting.length === 0) return;
    const job = this.busy = this.waiting.shift();
    try {
      if (!this.worker) await this.begin();
      if (this.busy !== job) return;
      this.worker.postMessage(job.message);
      this.clock = setTimeout(() => this.answered({ broken: SILENT }), this.patience);
    } catch (error) {
      this.end(job, "reject", error);
    }
  }

  async begin() {
    const ready = await this.begun();
    if (this.worker) return ready.terminate();
    this.worker = ready;
    ready.onmessage = ({ data }) => this.answered(data);
    ready.onerror = (event) => {
      event.preventDefault?.();
      this.answered({ broken: event.message || SILENT });
    };
  }

  // A module that has failed in the middle of something is begun anew.
  answered(data) {
    if (data.broken) this.stop();
    if (this.busy) this.end(this.busy, "resolve", data);
  }

  end(job, how, value) {
    if (this.busy === job) {
      this.busy = null;
      clearTimeout(this.clock);
    }
    job[how](value);
    this.next();
  }

  stop() {
    clearTimeout(this.clock);
    this.worker?.terminate();
    this.worker = null;
  }

  abort(job, reason) {
    this.waiting = this.waiting.filter((other) => other !== job);
    if (this.busy === job) this.stop();
    this.end(job, "reject", reason);
  }
}

const begun = (name) => async () => {
  const ready = await module(name);
  const next = worker();
  next.postMessage({ module: ready });
  return next;
};

const hand = new Lane(begun("engine"));
const long = new Lane(begun("engine"));
const whole = new Lane(begun("whole"));
const LANES = {
  relax: long, sensitivity: long, front: long, "scene-picture": long, sweep: long, range: long,
  export: whole, simulate: whole, resonance: whole, identify: whole, recording: whole, contacts: whole,
};
const lane = (route) => LANES[route] ?? hand;

// A question at which the engine fails is not asked again: it would fail again.
const failed = (message) => ({ error: { code: message === SILENT ? "silent" : "broken", message } });

export async function ask(route, text, signal) {
  const { answer, broken } = await lane(route).ask({ route, text }, signal);
  if (broken) return failed(broken);
  const end = route === "export" ? answer.indexOf(10) : -1;
  if (end < 0) return JSON.parse(new TextDecoder().decode(answer));
  const { kind: type } = JSON.parse(new TextDecoder().decode(answer.subarray(0, end)));
  return new Blob([answer.subarray(end + 1)], { type });
}

export async function keep(bytes, route) {
  const { hash, broken } = await lane(route).ask({ bytes });
  return broken ? failed(broken) : { hash };
}

export const folder = null;

// Where the page in one file has room for a scene, or has one already.
const PACKED = /<!--packed-->|<script type="text\/plain" id="packed">[\w-]*<\/script>/;

// This page in one file, with a packed scene inside.
export async function page(scene) {
  const own = inline("engine-module") && window.gaitcamPage;
  const text = own || await (await fetch(new URL("gaitcam.html", document.baseURI))).text();
  return new Blob([text.replace(PACKED, () => `<script type="text/plain" id="packed">${scene}</script>`)], { type: "text/html" });
}
