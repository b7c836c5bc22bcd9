// Interface to the engine: requests and responses as data, files by the hash of their bytes.

import * as http from "../engine/http.js";
import * as wasm from "../engine/wasm.js";

export class Fault extends Error {
  constructor(error) {
    super(error.message);
    Object.assign(this, error);
  }
}

const below = document.documentElement.dataset.engine === "wasm" ? wasm : http;

let language = "en";
export function speak(tag) {
  language = tag;
}

// Bytes by their hash, in case the engine loses them and they must be passed to it again.
const kept = new Map();

async function sha256(text) {
  const sum = new Uint8Array(await crypto.subtle.digest("SHA-256", new TextEncoder().encode(text)));
  return [...sum].map((b) => b.toString(16).padStart(2, "0")).join("");
}

// Converts exceptions of fetch and of workers without a response. Any other exception is an error of the page.
async function reached(promise) {
  let answer;
  try {
    answer = await promise;
  } catch (error) {
    if (error.name === "AbortError" || error instanceof Fault) throw error;
    throw new Fault({ code: "lost", message: error.message });
  }
  if (answer.refused) throw new Fault({ code: "http", status: answer.refused, message: "" });
  if (answer.error) throw new Fault(answer.error);
  return answer;
}

async function ask(route, question, signal) {
  const text = JSON.stringify({ language, ...question });
  for (;;) {
    const asked = below.ask(route, text, signal);
    // Outside a secure context, the browser computes no hash for this check.
    const sum = crypto.subtle && sha256(text);
    const answer = await reached(asked);
    if (answer.missing) {
      await again(answer.missing, route);
      continue;
    }
    // A response to another request is rejected.
    if (answer.of && sum && answer.of !== await sum) throw new Fault({ code: "lost", message: "" });
    return answer;
  }
}

async function again(hashes, route) {
  for (const hash of hashes) {
    const bytes = kept.get(hash);
    if (!bytes) throw new Fault({ code: "missing", hash, message: hash });
    await reached(below.keep(bytes, route));
  }
}

// Stores a file that the engine has made and stored.
function made(answer, hash) {
  if (answer.csv && hash && !kept.has(hash)) kept.set(hash, new TextEncoder().encode(answer.csv));
  return answer;
}

async function keep(data) {
  const bytes = data instanceof Uint8Array ? data : new Uint8Array(data instanceof Blob ? await data.arrayBuffer() : data);
  const { hash } = await reached(below.keep(bytes, "recording"));
  kept.set(hash, bytes);
  return hash;
}

export const engine = {
  keep,
  bytes: (hash) => kept.get(hash),
  async ask(route, question = {}, /** @type {{signal?: AbortSignal}} */ { signal } = {}) {
    const answer = await ask(route, question, signal);
    if (route === "force") made(answer, answer.hash);
    if (route === "contacts" && answer.use_hash !== answer.hash) made(answer, answer.use_hash);
    return answer;
  },
  download: (question, /** @type {{signal?: AbortSignal}} */ { signal } = {}) => ask("export", question, signal),
  // This page in a single file with a packed scene inside, if the page contains its engine.
  page: below.page,
  folder: below.folder && {
    list: () => reached(below.folder.list(language)),
    open: async (path) => ({ files: [], ...await reached(below.folder.open(path, language)) }),
    read: async (path) => ({ name: path, hash: await keep(await reached(below.folder.bytes(path, language))) }),
    save: (question) => ask("save", question),
  },
};
