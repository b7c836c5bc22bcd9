// The address and the browser's memory follow the versions: for a reload, for a link, for the next visit.

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
  try { localStorage.setItem(LAST, JSON.stringify({ name: v.name, packed: text })); } catch { /* private windows keep nothing */ }
}

// Restores the versions of before a reload, where the files of the one shown are still at hand.
export async function restore() {
  return versions.restore() && blobs.hasAll(used(versions.now()));
}

// The last scene of an earlier visit, packed; null where there is none.
export function last() {
  try { return JSON.parse(localStorage.getItem(LAST)); } catch { return null; }
}

// The link of a version: a page that others can reach has an address, one on this machine has none. `inside` as in `pack`.
export async function link(v = versions.now()) {
  const { text, inside } = await pack(v);
  const isOwn = /^(localhost|127\.|\[::1\]|$)/.test(location.hostname) || location.protocol === "file:";
  return { text: isOwn ? `#s=${text}` : `${location.origin}${location.pathname}#s=${text}`, inside, isOwn };
}
