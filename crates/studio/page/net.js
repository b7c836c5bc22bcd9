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

export async function get(path) {
  return read(await fetch(address(path)));
}

export async function post(path, question, signal) {
  return read(await fetch(address(path), { method: "POST", body: JSON.stringify(question), signal }));
}

export async function send(path, body) {
  return read(await fetch(address(path), { method: "POST", body }));
}

export function link(path) {
  return address(path).href;
}
