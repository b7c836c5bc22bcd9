// The address and the browser's memory follow the versions: for a reload, for a link, for the next visit.

import { pack } from "./packing.js";
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

// The last scene of an earlier visit, packed; null where there is none.
export function last() {
  try { return JSON.parse(localStorage.getItem(LAST)); } catch { return null; }
}

// What is copied: a page that others can reach has an address, one on this machine has none.
export async function link() {
  const { text, shortened } = await pack(versions.now());
  const own = /^(localhost|127\.|\[::1\]|$)/.test(location.hostname) || location.protocol === "file:";
  return { text: own ? `#s=${text}` : `${location.origin}${location.pathname}#s=${text}`, shortened, own };
}
