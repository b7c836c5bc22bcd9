// Contents of files by their hash, stored by the engine, and in the browser for a reload.

import { engine } from "./net.js";

// Hashes that were not found in the storage of the browser.
const absent = new Set();

// Stores contents and returns their hash.
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

// Passes the files of a version to the engine again after a reload; null if the engine has all of them.
export function ensure(files) {
  const missing = Object.values(files).filter((hash) => hash && !engine.bytes(hash) && !absent.has(hash));
  return missing.length === 0 ? null : Promise.all(missing.map(get));
}

// Whether the contents of all these files are available.
export async function hasAll(files) {
  const all = await Promise.all(Object.values(files).filter(Boolean).map(get));
  return all.every(Boolean);
}

// Files of a version as part of a request.
export const listed = (files) => Object.entries(files).filter(([, hash]) => hash).map(([name, hash]) => ({ name, hash }));

// --- storage of the browser ----------------------------------------------------------------------

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
  } catch { /* A private window stores nothing. */ }
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
