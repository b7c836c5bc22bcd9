// Writes each version to the address of the page and to the storage of the browser: for a reload, for links, and for the next visit.

import * as blobs from "./blobs.js";
import { pack, used } from "./packing.js";
import * as versions from "./versions.js";

const LAST = "gaitcam-last";
let writing = 0;

export function load() {
  versions.written(location.hash);
  versions.watch(() => {
    clearTimeout(writing);
    writing = setTimeout(write, 250);
  });
  window.addEventListener("pagehide", () => versions.keep());
}

async function write() {
  const v = versions.now();
  if (!v?.scene) return;
  const { text } = await pack(v);
  if (v !== versions.now()) return;
  const place = new URL(location.href);
  place.hash = "s=" + text;
  history.replaceState(null, "", place);
  versions.written(place.hash);
  versions.keep();
  try { localStorage.setItem(LAST, JSON.stringify({ name: v.name, packed: text })); } catch { /* A private window stores nothing. */ }
}

// Restores the versions from before a reload. The result is false if files of the displayed version are missing.
export async function restore() {
  return versions.restore() && blobs.hasAll(used(versions.now()));
}

// Last scene of an earlier visit, packed; null if there is none.
export function last() {
  try { return JSON.parse(localStorage.getItem(LAST)); } catch { return null; }
}

// Link of a version. If the page is on a server that others can reach, it contains the address of the page. `inside` as in `pack`.
export async function link(v = versions.now()) {
  const { text, inside } = await pack(v);
  const isOwn = /^(localhost|127\.|\[::1\]|$)/.test(location.hostname) || location.protocol === "file:";
  return { text: isOwn ? `#s=${text}` : `${location.origin}${location.pathname}#s=${text}`, inside, isOwn };
}
