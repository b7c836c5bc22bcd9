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
    try {
      return await fetch(address(path), options);
    } catch (again) {
      throw again.name === "AbortError" ? again : new Fault({ code: "lost", message: "" });
    }
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

// The server knows a file by its name: here that name carries the hash of its contents.
async function aliased(path, body, files = [], signal) {
  const own = files.filter(({ name, hash }) => kept.has(hash) && [body.scene, JSON.stringify(body.changes)].join().includes(JSON.stringify(name))).map(({ name, hash }) => ({ name, hash, alias: `${hash.slice(0, 16)}_${name}` }));
  let text = JSON.stringify(body);
  for (const { name, hash, alias } of own) {
    sent.delete(alias);
    await drop(alias, hash);
    const quoted = (x) => JSON.stringify(x);
    text = text.replaceAll(quoted(quoted(name)).slice(1, -1), quoted(quoted(alias)).slice(1, -1)).replaceAll(quoted(name), quoted(alias));
  }
  const answer = await post(path, JSON.parse(text), signal);
  return own.length === 0 ? answer : JSON.parse(own.reduce((all, { name, alias }) => all.replaceAll(alias, name), JSON.stringify(answer)));
}

async function design(question, signal) {
  const { scene, changes, colour } = question;
  const answer = await aliased("design", { scene, changes, colour }, question.files, signal);
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
  sensitivity: ({ scene, files, quantity, share }, signal) => aliased("sensitivity", { scene, quantity, share }, files, signal),
  front: ({ scene, files, against }, signal) => aliased("front", { scene, against }, files, signal),
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
  async ask(route, question = {}, { signal } = {}) {
    if (!routes[route]) throw new Fault({ code: "http", status: 404, message: "" });
    return routes[route](question, signal);
  },
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
    async save({ scene, files = [], name }) {
      for (const { name: file, hash } of files) await drop(file, hash);
      return post("save", { scene, name });
    },
  },
};
