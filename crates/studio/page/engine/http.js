// Engine of `gaitcam studio`: sends requests to its server. The path contains the token.

function address(path, language) {
  const url = new URL(path, document.baseURI);
  if (language) url.searchParams.set("language", language);
  return url;
}

// The server may close an idle connection while a request is sent, so a failed request is sent once more.
async function reach(path, options) {
  try {
    return await fetch(path, options);
  } catch (error) {
    if (error.name === "AbortError") throw error;
    return fetch(path, options);
  }
}

// Data of a response, its file, or the status of a rejection.
async function read(response) {
  if (!response.ok && response.status !== 400) return { refused: response.status };
  if (response.headers.has("content-disposition")) return response.blob();
  return response.json();
}

export async function ask(route, text, signal) {
  return read(await reach(address(route), { method: "POST", body: text, signal }));
}

export async function keep(bytes) {
  return read(await reach(address("keep"), { method: "POST", body: bytes }));
}

const inside = (path) => path.split("/").map(encodeURIComponent).join("/");

export const folder = {
  list: async (language) => read(await reach(address("folder.json", language))),
  open: async (path, language) => read(await reach(address(`folder/${inside(path)}`, language))),
  async bytes(path, language) {
    const response = await reach(address(`bytes/${inside(path)}`, language));
    const found = response.ok && response.headers.get("content-type") === "application/octet-stream";
    return found ? new Uint8Array(await response.arrayBuffer()) : read(response);
  },
};

export const page = null;
