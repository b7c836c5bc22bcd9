// Contents of files by their hash: with the engine, and in the browser's own store for a reload.

import { engine } from "./net.js";

// Those that were looked for in the browser's store without success.
const absent = new Set();

// Takes contents in and returns their hash.
export async function put(bytes) {
  const hash = await engine.keep(bytes);
  absent.delete(hash);
  store(hash, engine.bytes(hash));
  return hash;
}

export async function get(hash) {
  if (!engine.bytes(hash)) {
    const bytes = await load(hash);
    if (bytes) await engine.keep(bytes);
    else absent.add(hash);
  }
  return engine.bytes(hash) ?? null;
}

// After a reload the engine is given the files of a version again; nothing where it has them.
export function ensure(files) {
  const missing = Object.values(files).filter((hash) => hash && !engine.bytes(hash) && !absent.has(hash));
  return missing.length === 0 ? null : Promise.all(missing.map(get));
}

// Whether the contents of all these files are at hand.
export async function hasAll(files) {
  const all = await Promise.all(Object.values(files).filter(Boolean).map(get));
  return all.every(Boolean);
}

// The files of a version as a question carries them.
export const listed = (files) => Object.entries(files).filter(([, hash]) => hash).map(([name, hash]) => ({ name, hash }));

// --- the browser's store -------------------------------------------------------------------------

let opened = null;
function database() {
  opened ??= new Promise((resolve, reject) => {
    const request = indexedDB.open("gaitcam", 1);
    request.onupgradeneeded = () => request.result.createObjectStore("files");
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
  });
  return opened;
}

async function store(hash, bytes) {
  try {
    (await database()).transaction("files", "readwrite").objectStore("files").put(bytes, hash);
  } catch { /* private windows keep nothing */ }
}

async function load(hash) {
  try {
    const request = (await database()).transaction("files").objectStore("files").get(hash);
    return await new Promise((resolve) => {
      request.onsuccess = () => resolve(request.result ?? null);
      request.onerror = () => resolve(null);
    });
  } catch {
    return null;
  }
}
