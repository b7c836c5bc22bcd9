// Stores this build of the page, so that it opens without a network after the first visit. A new build replaces it as a whole.

const CACHE = "gaitcam-{version}";
const FILES = [{files}];
// File that is stored later, after a message of the page.
const LATER = "{later}";

addEventListener("install", (event) => {
  event.waitUntil(caches.open(CACHE).then((cache) => cache.addAll(FILES)).then(() => skipWaiting()));
});

addEventListener("activate", (event) => {
  const old = (names) => Promise.all(names.filter((name) => name.startsWith("gaitcam-") && name !== CACHE).map((name) => caches.delete(name)));
  event.waitUntil(caches.keys().then(old).then(() => clients.claim()));
});

addEventListener("message", (event) => {
  event.waitUntil(caches.match(LATER).then((found) => found ?? caches.open(CACHE).then((cache) => cache.add(LATER))));
});

addEventListener("fetch", (event) => {
  const own = () => caches.match(event.request, { ignoreSearch: true });
  event.respondWith(own().then((found) => found ?? fetch(event.request)));
});
