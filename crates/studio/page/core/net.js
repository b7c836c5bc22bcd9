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
