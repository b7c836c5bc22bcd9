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
  disconnect();
}

function address(path) {
  const url = new URL(path, document.baseURI);
  url.searchParams.set("language", language);
  return url;
}

async function read(response) {
  if (!response.ok && response.status !== 400) throw new Fault({ code: "http", status: response.status, message: "" });
  return checked(await response.json());
}

function checked(value) {
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
let connection = null;

function disconnect() {
  connection?.then((socket) => socket.close(), () => {});
  connection = null;
}

function connect(path) {
  return new Promise((resolve, reject) => {
    const url = address(path);
    url.protocol = "ws:";
    const socket = new WebSocket(url);
    socket.onopen = () => resolve(socket);
    socket.onclose = () => reject(new Error("no connection"));
  });
}

// What post does, over a WebSocket that stays open: an answer comes ten milliseconds sooner. Where it has ended the
// question is asked once more as a request, which also says what is wrong.
export async function askOverSocket(path, question, signal) {
  try {
    connection ??= connect(path);
    return checked(JSON.parse(await exchange(await connection, JSON.stringify(question), signal)));
  } catch (error) {
    if (error.name === "AbortError" || error instanceof Fault) throw error;
    disconnect();
    return post(path, question, signal);
  }
}

// Sends one message and waits for the next. Who no longer waits disconnects, so that a late answer is nobody's.
function exchange(socket, text, signal) {
  return new Promise((resolve, reject) => {
    signal.throwIfAborted();
    // Between two questions nobody waits for the end.
    if (socket.readyState !== WebSocket.OPEN) throw new Error("the connection has ended");
    signal.onabort = () => {
      disconnect();
      reject(signal.reason);
    };
    socket.onmessage = (message) => {
      signal.onabort = null;
      resolve(message.data);
    };
    socket.onclose = () => reject(new Error("the connection has ended"));
    socket.send(text);
  });
}

export async function send(path, body) {
  return read(await ask(path, { method: "POST", body }));
}

export function link(path) {
  return address(path).href;
}
