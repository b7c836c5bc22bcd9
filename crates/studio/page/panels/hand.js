// Force drawn by hand: points of one cycle that the user drags, adds and deletes.

import { html, nothing, notice, svg, svgTemplate } from "../core/dom.js";
import { t, number } from "../core/words.js";
import { engine } from "../core/net.js";
import * as blobs from "../core/blobs.js";
import * as versions from "../core/versions.js";

const [WIDTH, HEIGHT, PAD] = [320, 190, 28];
/** @type {(...all: any[]) => any} */
let edit = () => {};
/** @type {(...all: any[]) => any} */
let redraw = () => {};
let answer = null;
let drawn = null;
let chosen = 0;
let scale = [0, 1];
let asking = 0;
let version = 0;
let gesture = 0;
// Drawn force of the version that the editor shows.
let seen = null;
const FILE = "force-by-hand.csv";

export function load(onEdit, draw) {
  edit = onEdit;
  redraw = draw;
}

// Displays the force of the present version. After undo, this restores its points.
export function follow(next) {
  answer = next;
  const { hand = null } = versions.now() ?? {};
  if (hand === seen || asking > 0) return;
  seen = hand;
  if (hand && drawn && JSON.stringify(hand) === JSON.stringify(plain())) return;
  drawn = hand ? { period_s: hand.period_s, points: hand.points.map((p) => [...p]) } : null;
  chosen = Math.min(chosen, (drawn?.points.length ?? 1) - 1);
  if (!drawn) return;
  fit();
  trace();
}

const plain = () => ({ period_s: drawn.period_s, points: drawn.points.map((p) => [...p]) });

// Requests the curve through the points.
async function trace() {
  const hash = versions.now().files[FILE];
  const mine = version;
  try {
    const { force_n } = await engine.ask("force", { file: FILE, ...plain() });
    if (mine === version && drawn && versions.now().files[FILE] === hash) drawn.curve = force_n;
  } catch { /* Only the points are shown. */ }
  redraw();
}

// Button that starts the drawing, or the editor.
export function section() {
  if (drawn) return editor();
  return html`<button type="button" id="draw-force" class="main" ?disabled=${!answer} @click=${begin}>${t("studio-force-draw")}</button>`;
}

// Starts with points on the present force.
function begin() {
  const { curves, motion } = answer;
  const target = curves.panels[0].lines.find((l) => l.role === "target") ?? curves.panels[0].lines[0];
  const { period } = motion;
  const count = 12;
  const points = Array.from({ length: count }, (_, k) => {
    const wanted = curves.start + curves.length * k / count;
    const i = curves.theta.findIndex((x) => x >= wanted - 1e-9);
    return [period * k / count, Math.round(10 * (target.y[Math.max(i, 0)] ?? 0)) / 10];
  });
  drawn = { period_s: period, points };
  gesture += 1;
  fit();
  keep();
}

// Stores the points as a file. The response contains the curve through them.
async function keep() {
  version += 1;
  const mine = version;
  const hand = plain();
  asking += 1;
  try {
    const kept = await engine.ask("force", { file: FILE, ...hand });
    const hash = await blobs.put(new TextEncoder().encode(kept.csv));
    if (mine !== version) return;
    drawn.curve = kept.force_n;
    seen = hand;
    edit([{ set: { key: "gait.file", value: FILE } }], `drawn ${gesture}`, { files: { [FILE]: hash }, hand, title: t("studio-force-hand") });
    redraw();
  } catch (error) {
    notice(error.message);
  } finally {
    asking -= 1;
  }
}

function fit() {
  const all = drawn.points.map((p) => p[1]).concat(drawn.curve ?? []);
  const [low, high] = [Math.min(0, ...all), Math.max(1, ...all)];
  scale = [low, high + 0.1 * (high - low)];
}

const x = (time) => PAD + time / drawn.period_s * (WIDTH - PAD - 8);
const y = (force) => HEIGHT - 18 - (force - scale[0]) / (scale[1] - scale[0]) * (HEIGHT - 26);

// Time (s) and force (N) under the pointer.
function under(event) {
  const across = event.currentTarget.getScreenCTM().inverse();
  const p = new DOMPoint(event.clientX, event.clientY).matrixTransform(across);
  const time = (p.x - PAD) / (WIDTH - PAD - 8) * drawn.period_s;
  const force = scale[0] + (HEIGHT - 18 - p.y) / (HEIGHT - 26) * (scale[1] - scale[0]);
  return [Math.max(0, Math.min(drawn.period_s * 0.999, time)), Math.round(force * 10) / 10];
}

// Moves a point, which stays between its neighbours.
/** @param {number} i @param {number[]} to */
function move(i, [time, force]) {
  const gap = drawn.period_s / 200;
  const low = i > 0 ? drawn.points[i - 1][0] + gap : 0;
  const high = i + 1 < drawn.points.length ? drawn.points[i + 1][0] - gap : drawn.period_s - gap;
  drawn.points[i] = [i === 0 ? 0 : Math.max(low, Math.min(high, time)), force];
}

function add(point) {
  gesture += 1;
  drawn.points.push(point);
  drawn.points.sort((a, b) => a[0] - b[0]);
  chosen = drawn.points.indexOf(point);
  redraw();
  keep();
}

function remove(i) {
  if (drawn.points.length <= 3) return;
  gesture += 1;
  drawn.points.splice(i, 1);
  chosen = Math.max(0, Math.min(i, drawn.points.length - 1));
  redraw();
  keep();
}

/** @type {(point: number[], i: number) => string} */
const named = ([time, force], i) => t("studio-point", { number: i + 1, time: number(time, 3), force: number(force, 4) });

// Curve through the points as a path.
function path() {
  const step = drawn.period_s / drawn.curve.length;
  return drawn.curve.map((f, i) => `${i ? "L" : "M"}${x(i * step).toFixed(1)} ${y(f).toFixed(1)}`).join("");
}

function grasp(event, i) {
  chosen = i;
  gesture += 1;
  fit();
  event.currentTarget.ownerSVGElement.setPointerCapture(event.pointerId);
  event.stopPropagation();
  redraw();
}

const knot = (point, i) => svgTemplate`<circle class=${i === chosen ? "knot chosen" : "knot"} r="6" tabindex="0" role="button"
  cx=${x(point[0])} cy=${y(point[1])} aria-label=${named(point, i)} @pointerdown=${(event) => grasp(event, i)}
  @dblclick=${() => remove(i)} @keydown=${(event) => key(event, i)}></circle>`;

function key(event, i) {
  const [up, along] = [(scale[1] - scale[0]) / 100, drawn.period_s / 100];
  const step = { ArrowUp: [0, up], ArrowDown: [0, -up], ArrowRight: [along, 0], ArrowLeft: [-along, 0] }[event.key];
  if (!step && event.key !== "Delete") return;
  event.preventDefault();
  if (step) {
    gesture += event.repeat ? 0 : 1;
    chosen = i;
    move(i, [drawn.points[i][0] + step[0], drawn.points[i][1] + step[1]]);
    redraw();
    keep();
  } else remove(i);
  /** @type {any} */ (document.querySelectorAll(".editor .knot")[chosen])?.focus();
}

// Points as elements of the force diagram.
export function overlay(chart) {
  if (!drawn) return [];
  const { start, length } = chart.curves;
  const at = (time) => start + length * time / drawn.period_s;
  const dot = (point, i) => svg("circle", { class: "knot", cx: chart.x(at(point[0])), cy: chart.y(point[1]), r: 5, "data-knot": i,
    role: "img", "aria-label": named(point, i) });
  const dots = drawn.points.map((point, i) => (chart.isSeen(at(point[0])) ? dot(point, i) : null));
  return dots.filter(Boolean);
}

// Moves a point of the force diagram to the pointer.
export function place(i, part, force, begins) {
  if (begins) gesture += 1;
  chosen = i;
  move(i, [part * drawn.period_s, Math.round(force * 10) / 10]);
  redraw();
  keep();
}

function drag(event) {
  if (!event.currentTarget.hasPointerCapture(event.pointerId)) return;
  move(chosen, under(event));
  redraw();
  keep();
}

// Adds a point halfway to the next one.
function between() {
  const [a, b] = [drawn.points[chosen], drawn.points[chosen + 1] ?? [drawn.period_s, drawn.points[0][1]]];
  add([(a[0] + b[0]) / 2, (a[1] + b[1]) / 2]);
}

function stretch({ target }) {
  const next = parseFloat(target.value.replace(",", "."));
  if (!(next > 0)) return;
  const factor = next / drawn.period_s;
  for (const p of drawn.points) p[0] *= factor;
  drawn.period_s = next;
  gesture += 1;
  keep();
}

function editor() {
  const double = (event) => { if (!event.target.classList.contains("knot")) add(under(event)); };
  return html`<div class="hand">
    <svg class="editor" viewBox="0 0 ${WIDTH} ${HEIGHT}" role="group" aria-label=${t("studio-force-hand")}
      @pointermove=${drag} @dblclick=${double}>
      <path class="axis" d="M${PAD} ${y(0)}H${WIDTH - 8}M${PAD} 8V${HEIGHT - 18}"></path>
      ${drawn.curve ? svgTemplate`<path class="line target" d=${path()}></path>` : nothing}
      ${drawn.points.map(knot)}
    </svg>
    <div class="buttons">
      <button type="button" @click=${between}>${t("studio-point-add")}</button>
      <button type="button" @click=${() => remove(chosen)}>${t("studio-point-remove")}</button>
      <label for="hand-period">${t("studio-force-period")}</label>
      <input type="text" id="hand-period" size="8" .value=${String(Number(drawn.period_s.toPrecision(5)))} @change=${stretch}>
    </div>
  </div>`;
}
