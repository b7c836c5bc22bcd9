// Questions to the server, under the token that is the page's folder.

export class Fault extends Error {
  constructor(error) {
    super(error.message);
    Object.assign(this, error);
  }
}

let language = "en";
export function speak(tag) {
  language = tag;
  hangUp();
}

function address(path) {
  const url = new URL(path, document.baseURI);
  url.searchParams.set("language", language);
  return url;
}

async function read(response) {
  if (!response.ok && response.status !== 400) throw new Fault({ code: "http", status: response.status, message: "" });
  return heard(await response.json());
}

function heard(value) {
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

// The open WebSocket, or its promise. It carries one question at a time.
let line = null;

function hangUp() {
  line?.then((socket) => socket.close(), () => {});
  line = null;
}

function dial(path) {
  return new Promise((resolve, reject) => {
    const url = address(path);
    url.protocol = "ws:";
    const socket = new WebSocket(url);
    socket.onopen = () => resolve(socket);
    socket.onclose = () => reject(new Error("no line"));
  });
}

// What post does, over a WebSocket that stays open: an answer comes ten milliseconds sooner. Where the line is cut the
// question is asked once more as a request, which also says what is wrong.
export async function talk(path, question, signal) {
  try {
    line ??= dial(path);
    return heard(JSON.parse(await said(await line, JSON.stringify(question), signal)));
  } catch (error) {
    if (error.name === "AbortError" || error instanceof Fault) throw error;
    hangUp();
    return post(path, question, signal);
  }
}

// Says one thing and hears one. Who no longer listens hangs up, so that a late answer meets nobody.
function said(socket, text, signal) {
  return new Promise((resolve, reject) => {
    signal.throwIfAborted();
    // Between two questions nobody listens for the end.
    if (socket.readyState !== WebSocket.OPEN) throw new Error("the line is cut");
    signal.onabort = () => {
      hangUp();
      reject(signal.reason);
    };
    socket.onmessage = (message) => {
      signal.onabort = null;
      resolve(message.data);
    };
    socket.onclose = () => reject(new Error("the line is cut"));
    socket.send(text);
  });
}

export async function send(path, body) {
  return read(await ask(path, { method: "POST", body }));
}

export function link(path) {
  return address(path).href;
}
