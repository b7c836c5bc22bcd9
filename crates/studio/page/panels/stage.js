// The cam with its follower: rotation, dragging, circles, normal, osculating circle and coloured contour.

import { $, svg, hide, html, clear, nothing, picture as pictureOf, render as draw } from "../core/dom.js";
import { t, quantity, onLanguage } from "../core/words.js";
import * as clock from "../core/clock.js";
import { move, partsOf, value } from "../core/motion.js";
import { shade } from "../charts/shade.js";

const COLOURS = ["none", "pressure_angle", "curvature", "curvature_use", "force", "hertz"];
const UNITS = { pressure_angle: "°", curvature: "1/m", curvature_use: "%", force: "N", hertz: "MPa" };
const PIECES = 240;
let answer = null;
let parts = {};
let frame = null;
let renewed = true;
let pinned = [];
// Lines of the drawing, with their widths in pixels.
let strokes = [];
let size = [0, 0];

// `ask` requests the design again, because the values of a colour are part of the response.
export function load(ask) {
  new ResizeObserver(([{ contentRect }]) => {
    size = [contentRect.width, contentRect.height];
    scale($("stage").querySelector("svg"));
  }).observe($("stage"));
  for (const id of ["circles", "pitch", "normal", "osculating", "places"]) {
    $(`show-${id}`).addEventListener("change", () => { decorate(); follow(); });
  }
  $("colour").addEventListener("change", ask);
  clock.onAngle(follow);
  onLanguage(choices);
  choices();
  hand();
}

function choices() {
  const before = $("colour").value || "none";
  draw(COLOURS.map((c) => html`<option value=${c}>${t(`studio-colour-${c}`)}</option>`), $("colour"));
  $("colour").value = before;
}

export function show(next) {
  answer = next;
  const stage = $("stage");
  const picture = pictureOf(next.drawing.replace("<svg ", '<svg xmlns="http://www.w3.org/2000/svg" '));
  stage.replaceChildren(picture);
  picture.setAttribute("aria-hidden", "true");
  picture.removeAttribute("role");
  strokes = [...picture.querySelectorAll("[stroke-width], [stroke-dasharray]")].map((/** @type {SVGElement} */ e) => ({
    style: e.style, width: Number(e.getAttribute("stroke-width") ?? 1), dashes: e.getAttribute("stroke-dasharray")?.split(/[ ,]+/).map(Number),
  }));
  keepFrame(picture);
  parts = partsOf(picture);
  const body = parts["cam-turning"];
  parts.circles = [...body.querySelectorAll("[data-part=base], [data-part=prime], [data-part=bore]")];
  parts.pitch = [...body.querySelectorAll("[data-part=pitch]")];
  parts.colours = svg("g");
  parts.places = svg("g");
  parts.osculating = svg("circle", { class: "osculating" });
  parts.normal = svg("path", { class: "normal" });
  body.append(...pinned.map(other), parts.colours, parts.normal, parts.osculating, parts.places);
  const { motion } = next;
  stage.setAttribute("aria-valuemin", motion.start);
  stage.setAttribute("aria-valuemax", motion.start + motion.length);
  Object.assign($("angle"), { min: motion.start, max: motion.start + motion.length });
  decorate();
}

// A drawing that changes little keeps its frame, so that the change of the size of the cam is visible.
function keepFrame(picture) {
  const next = picture.getAttribute("viewBox").split(" ").map(Number);
  const inside = frame && next[0] >= frame[0] && next[1] >= frame[1]
    && next[0] + next[2] <= frame[0] + frame[2] && next[1] + next[3] <= frame[1] + frame[3];
  const large = frame && next[2] * next[3] > 0.55 * frame[2] * frame[3];
  if (renewed || !inside || !large) {
    // The engine leaves a margin of 4 % around the parts. A line needs less.
    const room = renewed ? -0.03 : 0.02;
    renewed = false;
    frame = [next[0] - room * next[2], next[1] - room * next[3], next[2] * (1 + 2 * room), next[3] * (1 + 2 * room)];
  }
  picture.setAttribute("viewBox", frame.join(" "));
  scale(picture);
}

// Sets the line widths in pixels, independent of the scale. With `vector-effect`, the browser would measure every line again in each frame.
function scale(picture) {
  if (!picture || !frame || size[0] * size[1] === 0) return;
  const pixel = Math.max(frame[2] / size[0], frame[3] / size[1]);
  picture.style.setProperty("--pixel", pixel);
  for (const { style, width, dashes } of strokes) {
    style.strokeWidth = width * pixel;
    if (dashes) style.strokeDasharray = dashes.map((d) => d * pixel).join(" ");
  }
}

// Quantity that colours the contour.
export function chosen() {
  return $("colour").value;
}

// The cam in its present position, without marks and other designs.
export function picture() {
  const copy = $("stage").querySelector("svg").cloneNode(true);
  for (const e of copy.querySelectorAll("[class]")) e.remove();
  for (const e of copy.querySelectorAll("#cam-push *")) e.setAttribute("vector-effect", "non-scaling-stroke");
  return copy;
}

// Selects a new frame for the next drawing.
export function anew() {
  renewed = true;
}

export function compare(list) {
  pinned = list;
  if (!answer) return;
  show(answer);
  follow();
}

function other({ curves, colour }) {
  return svg("path", { class: "pinned", style: `stroke:${colour}`, d: outline(curves.contour, 0, curves.contour.x.length - 1) });
}

function outline({ x, y }, from, to) {
  let d = "";
  for (let i = from; i <= to; i += 1) {
    if (x[i] !== null && y[i] !== null) d += `${d ? "L" : "M"}${x[i]} ${y[i]}`;
  }
  return d;
}

function decorate() {
  if (!answer) return;
  const shows = (id) => $(`show-${id}`).checked;
  draw(named(shows), $("parts"));
  for (const e of parts.circles) e.style.display = shows("circles") ? "" : "none";
  for (const e of parts.pitch) e.style.display = shows("pitch") ? "" : "none";
  for (const id of ["normal", "osculating", "places"]) parts[id].style.display = shows(id) ? "" : "none";
  parts["cam-push"].style.display = shows("normal") ? "" : "none";
  clear(parts.places);
  const size = 0.008 * Math.max(frame[2], frame[3]);
  for (const place of answer.curves.places) {
    const mark = svg("circle", { class: place.broken ? "place broken" : "place", cx: place.x, cy: place.y, r: size });
    const title = svg("title");
    title.textContent = `${answer.names[place.limit] ?? place.limit}: ${quantity(place.theta, answer.curves.unit)}`;
    mark.append(title);
    mark.addEventListener("click", () => { clock.play(false); clock.set(place.theta); });
    parts.places.append(mark);
  }
  colour();
}

// Legend of the displayed picture.
export const legend = () => named((id) => $(`show-${id}`).checked && id !== "places");

// Names of the lines and dots on the cam.
function named(shows) {
  const { places } = answer.curves;
  const drawn = (part) => parts["cam-turning"].querySelector(`[data-part=${part}]`);
  const list = [
    ...["base", "prime", "bore"].filter((part) => shows("circles") && drawn(part)),
    ...["pitch"].filter((part) => shows("pitch") && drawn(part)),
    ...(shows("places") && places.some((p) => !p.broken) ? ["reached"] : []),
    ...(shows("places") && places.some((p) => p.broken) ? ["broken"] : []),
  ];
  return [...list.map((part) => html`<li class=${part}><i></i>${t(`studio-part-${part}`)}</li>`),
    ...pinned.map(({ name, colour }) => html`<li class="pinned"><i style="border-color:${colour}"></i><span>${name}</span></li>`)];
}

function colour() {
  clear(parts.colours);
  const name = $("colour").value;
  const { contour } = answer.curves;
  hide($("legend"), name === "none");
  // The values of a newly selected colour have not arrived yet.
  if (name === "none" || contour.colour !== name) {
    draw(nothing, $("legend"));
    return;
  }
  const known = contour.values.filter((v) => v !== null);
  if (known.length === 0) {
    draw(t("studio-colour-undefined"), $("legend"));
    return;
  }
  const [low, high] = [known.reduce((m, v) => Math.min(m, v)), known.reduce((m, v) => Math.max(m, v))];
  paint(contour, low, high);
  const ramp = [0, 0.25, 0.5, 0.75, 1].map(shade).join(",");
  draw(html`${quantity(low, UNITS[name], 3)}<span class="ramp" style="background:linear-gradient(to right,${ramp})"></span>${quantity(high, UNITS[name], 3)}`,
    $("legend"));
}

function paint(contour, low, high) {
  const { values } = contour;
  const step = Math.max(1, Math.floor(values.length / PIECES));
  for (let i = 0; i + 1 < values.length; i += step) {
    if (values[i] === null) continue;
    const d = outline(contour, i, Math.min(i + step, values.length - 1));
    const stroke = shade(high > low ? (values[i] - low) / (high - low) : 0.5);
    parts.colours.append(svg("path", { class: "coloured", d, style: `stroke:${stroke}` }));
  }
}

function follow() {
  if (!answer) return;
  const { motion } = answer;
  const theta = clock.angle();
  const u = Math.max(0, Math.min(1, (theta - motion.start) / motion.length));
  move(parts, motion, u, theta);
  bend(theta);
  $("angle").value = theta;
  const text = quantity(theta, motion.angle_unit.trim(), 4);
  $("stage").setAttribute("aria-valuenow", theta.toFixed(2));
  $("stage").setAttribute("aria-valuetext", `${text}, ${t("studio-chart-s")} ${quantity(value(motion, motion.s, u), motion.unit)}`);
}

// Draws the contact normal and the osculating circle, in the frame of the cam.
function bend(theta) {
  const { curves } = answer;
  const list = curves.theta;
  let [low, high] = [0, list.length - 1];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (list[middle] <= theta) low = middle;
    else high = middle;
  }
  const c = curves.contour;
  const [cx, cy, radius] = [c.centre_x[low], c.centre_y[low], c.radius[low]];
  const known = cx !== null && radius !== null && Math.abs(radius) < 4 * Math.max(frame[2], frame[3]);
  parts.osculating.setAttribute("visibility", known ? "visible" : "hidden");
  parts.normal.setAttribute("visibility", known ? "visible" : "hidden");
  if (!known) return;
  parts.osculating.setAttribute("cx", cx);
  parts.osculating.setAttribute("cy", cy);
  parts.osculating.setAttribute("r", Math.abs(radius));
  parts.normal.setAttribute("d", `M${cx} ${cy}L${c.x[low]} ${c.y[low]}`);
}

// Dragging rotates the cam, or moves a translating cam.
function hand() {
  const stage = $("stage");
  let last = null;
  const where = (event) => {
    const picture = stage.querySelector("svg");
    const p = new DOMPoint(event.clientX, event.clientY).matrixTransform(picture.getScreenCTM().inverse());
    return [p.x, -p.y];
  };
  stage.addEventListener("pointerdown", (event) => {
    if (!answer || event.target.classList?.contains("place")) return;
    clock.play(false);
    stage.setPointerCapture(event.pointerId);
    last = where(event);
  });
  stage.addEventListener("pointermove", (event) => {
    if (!last || !stage.hasPointerCapture(event.pointerId)) return;
    const here = where(event);
    const { slide } = answer.motion;
    if (slide) {
      clock.set(clock.angle() - (here[0] - last[0]) / slide);
    } else {
      const way = (Math.atan2(here[1], here[0]) - Math.atan2(last[1], last[0])) * 180 / Math.PI;
      clock.set(clock.angle() + ((way + 540) % 360) - 180);
    }
    last = here;
  });
  stage.addEventListener("pointerup", () => { last = null; });
  stage.addEventListener("keydown", (event) => {
    const step = (event.shiftKey ? 10 : 1) * (answer ? answer.motion.length / 360 : 1);
    const steps = { ArrowRight: step, ArrowUp: step, ArrowLeft: -step, ArrowDown: -step };
    if (event.key in steps) {
      clock.play(false);
      clock.set(clock.angle() + steps[event.key]);
    } else if (event.key === "Home") {
      clock.play(false);
      clock.set(answer.motion.start);
    }
    else if (event.key === " ") clock.play(!clock.isPlaying());
    else return;
    event.preventDefault();
  });
}

