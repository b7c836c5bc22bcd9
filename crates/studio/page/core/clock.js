// Cam angle, which all parts of the page display.

let motion = null;
let theta = 0;
let playing = false;
let backwards = false;
let pace = 0.1;
let held = false;
let last = 0;
const listeners = [];
const watchers = [];

export function onAngle(listener) {
  listeners.push(listener);
}

export function onPlay(watcher) {
  watchers.push(watcher);
}

export function load(next) {
  const same = motion && motion.start === next.start && motion.length === next.length;
  motion = next;
  if (!same) theta = next.start;
}

export function angle() {
  return theta;
}

export function isPlaying() {
  return playing;
}

export function isBackwards() {
  return backwards;
}

export function setPace(next) {
  pace = next;
}

function wrapped(next) {
  const turn = (next - motion.start) / motion.length;
  const within = turn >= 0 && turn <= 1 ? turn : turn - Math.floor(turn);
  return motion.start + within * motion.length;
}

// Sets the angle. An angle outside the turn is wrapped to it.
export function set(next) {
  if (!motion) return;
  theta = wrapped(next);
  for (const listener of listeners) listener(theta);
}

export function play(on) {
  if (on === playing) return;
  playing = on;
  last = performance.now();
  if (on) requestAnimationFrame(frame);
  for (const watcher of watchers) watcher();
}

// While a design is computed, the angle advances without drawing, so that the picture of the response is not delayed.
export function hold(on) {
  held = on;
}

export function reverse() {
  backwards = !backwards;
  for (const watcher of watchers) watcher();
}

function frame(now) {
  if (!playing) return;
  const passed = Math.min(now - last, 100) / 1000;
  last = now;
  if (motion) {
    const way = motion.back !== backwards ? -1 : 1;
    const next = theta + way * passed * pace / motion.period * motion.length;
    if (held) theta = wrapped(next);
    else set(next);
  }
  requestAnimationFrame(frame);
}
