// The door to the engine: questions and answers as data, files by the hash of their bytes.

export class Fault extends Error {
  constructor(error) {
    super(error.message);
    Object.assign(this, error);
  }
}

let language = "en";
export function speak(tag) {
  language = tag;
}

function address(path) {
  const url = new URL(path, document.baseURI);
  url.searchParams.set("language", language);
  return url;
}

async function read(response) {
  if (!response.ok && response.status !== 400) throw new Fault({ code: "http", status: response.status, message: "" });
  const value = await response.json();
  if (value && value.error) throw new Fault(value.error);
  return value;
}

// An idle connection may be closed at the moment of asking: every question may be asked again.
async function ask(path, options) {
  try {
    return await fetch(address(path), options);
  } catch (error) {
    if (error.name === "AbortError") throw error;
    return fetch(address(path), options);
  }
}

export async function get(path) {
  return read(await ask(path));
}

export async function post(path, question, signal) {
  return read(await ask(path, { method: "POST", body: JSON.stringify(question), signal }));
}

export async function send(path, body) {
  return read(await ask(path, { method: "POST", body }));
}

export function link(path) {
  return address(path).href;
}

// --- the engine, over the server as it is --------------------------------------------------------

const kept = new Map();
const sent = new Map();
const ids = new Map();

async function sha256(bytes) {
  const sum = new Uint8Array(await crypto.subtle.digest("SHA-256", bytes));
  return [...sum].map((b) => b.toString(16).padStart(2, "0")).join("");
}

async function keep(data) {
  const bytes = new Uint8Array(data instanceof Blob ? await data.arrayBuffer() : data);
  const hash = await sha256(bytes);
  kept.set(hash, bytes);
  return hash;
}

// The server knows a dropped file by its name: it is sent where the bytes of the name have changed.
async function drop(name, hash) {
  if (sent.get(name) === hash || !kept.has(hash)) return null;
  const answer = await send(`recording?name=${encodeURIComponent(name)}`, kept.get(hash));
  sent.set(name, hash);
  return answer;
}

async function used(answer) {
  const hash = await keep(new TextEncoder().encode(answer.csv ?? ""));
  if (answer.csv) sent.set(answer.use, hash);
  return hash;
}

async function design(question, signal) {
  for (const { name, hash } of question.files ?? []) await drop(name, hash);
  const { scene, changes, colour } = question;
  const answer = await post("design", { scene, changes, colour }, signal);
  answer.design_hash = await sha256(new TextEncoder().encode(answer.scene + JSON.stringify(question.files ?? [])));
  answer.force_hash = question.files?.find((f) => answer.scene.includes(JSON.stringify(f.name)))?.hash ?? null;
  ids.set(answer.scene, answer.id);
  return answer;
}

const routes = {
  start: () => get("start.json"),
  laws: async () => ({ laws: await get("laws.json") }),
  design,
  relax: async (question, signal) => post("relax", { id: ids.get(question.scene) ?? (await design(question, signal)).id }, signal),
  sensitivity: ({ scene, quantity, share }, signal) => post("sensitivity", { scene, quantity, share }, signal),
  front: ({ scene, against }, signal) => post("front", { scene, against }, signal),
  force: async (question, signal) => {
    const answer = await post("force", question, signal);
    return { ...answer, hash: await used(answer) };
  },
  recording: async ({ file, hash }) => {
    sent.delete(file);
    return { ...await drop(file, hash) ?? await post("contacts", { file }), hash, use_hash: hash };
  },
  contacts: async ({ file, hash, without, feet }, signal) => {
    await drop(file, hash);
    const answer = await post("contacts", { file, without, feet }, signal);
    return { ...answer, hash, use_hash: answer.use === file ? hash : await used(answer) };
  },
  "scene-picture": async ({ name }) => ({ svg: await (await ask(`scene/${name}.svg`)).text() }),
};

export const engine = {
  kind: "native",
  speak,
  keep,
  bytes: (hash) => kept.get(hash),
  forget: (hash) => kept.delete(hash),
  ask: (route, question = {}, { signal } = {}) => routes[route](question, signal),
  page: async () => null,
  async download({ scene, files, name, tool }) {
    const id = ids.get(scene) ?? (await design({ scene, files })).id;
    const response = await ask(`export/${id}/${name}${tool ? `?tool=${encodeURIComponent(tool)}` : ""}`);
    if (!response.ok) await read(response);
    return response.blob();
  },
  folder: {
    list: () => get("folder.json"),
    open: async (path) => ({ ...await get(`folder/${path.split("/").map(encodeURIComponent).join("/")}`), files: [] }),
    read: async (path) => ({ name: path, hash: await sha256(new TextEncoder().encode(path)) }),
    save: ({ scene, name }) => post("save", { scene, name }),
  },
};
