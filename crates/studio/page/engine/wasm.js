// Engine inside the page, in three workers. One is for short requests and one for long requests. The third contains the whole module for
// files, simulations and recordings; it is loaded at the first such request.

// A search ends after at most 60 s. A worker without a response after this time, in ms, is considered as ended by the browser.
const PATIENCE = 75000;
const SILENT = "no answer";

const inline = (id) => document.getElementById(id)?.textContent;
const unpack = (stream) => stream.pipeThrough(new DecompressionStream("gzip"));

// A page in a single file contains the whole module as text. A page in a folder loads the module from a file and, if possible, stores it
// for visits without a network.
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

// Requests wait here and not in the worker, so that a waiting request can be cancelled without ending the worker. A worker that fails, or
// that exceeds the time limit, is ended. The next request starts a new worker.
export class Lane {
  waiting = [];
  busy = null;
  worker = null;
  clock = 0;

  // `begun` returns a worker that is ready for requests. `patience` is in ms.
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

  // A module that has failed is started again.
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

// A request at which the engine fails is not repeated, because it would fail again.
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

// Place for a scene in a page in a single file, empty or filled.
const PACKED = /<!--packed-->|<script type="text\/plain" id="packed">[\w-]*<\/script>/;

// This page in a single file, with a packed scene inside.
export async function page(scene) {
  const own = inline("engine-module") && window.gaitcamPage;
  const text = own || await (await fetch(new URL("gaitcam.html", document.baseURI))).text();
  return new Blob([text.replace(PACKED, () => `<script type="text/plain" id="packed">${scene}</script>`)], { type: "text/html" });
}
