// Form, built from the key table: a text or a choice for every value, and a slider for values with a meaningful range.

import { $, html, nothing, render as put, repeat, live } from "../core/dom.js";
import { t, local, onLanguage, language } from "../core/words.js";
import { tab } from "../core/view.js";
import * as versions from "../core/versions.js";
import * as designs from "../core/designs.js";
import * as slider from "./slider.js";
import * as possible from "./possible.js";
import { label, choice, help } from "./names.js";
import { id, listeners, template } from "./row.js";

export { label } from "./names.js";

const SECTIONS = ["", "gait", "drive", "law", "cam", "limits", "accuracy", "machine"];
// Values that most scenes change first.
const MAIN = ["gait.model", "gait.file", "gait.step_frequency", "gait.body_weight", "drive.speed", "cam.follower",
  "limits.stroke", "limits.pressure_angle", "limits.curvature", "accuracy.rms"];
const FIRST = ["name", ...MAIN.filter((key) => key !== "gait.file" && key !== "gait.model")];
// Values that are set together by one button, if the first of them applies and all are empty.
const TOGETHER = {
  drive: [["spring", { "drive.spring_rate": "1000 N/m", "drive.preload": "50 N" }]],
  machine: [
    ["motor", { "machine.motor.slope": "10 N m s/rad", "machine.inertia": "2 kg m^2" }],
    ["floor", { "machine.floor.mass": "20000 kg", "machine.floor.frequency": "5 Hz", "machine.floor.damping": "0.02" }],
  ],
};
const FOLDED = "gaitcam-folded";

let keys = [];
/** @type {(edits: object[], gesture: string | null, more?: object) => void} */
let edit = () => {};
let everything = false;
let typed = "";
let folded = new Set();
const helped = new Set();
const texts = new Map();

export function load(table, onEdit) {
  keys = table.filter((k) => !k.key.includes(".N."));
  edit = onEdit;
  try { folded = new Set(JSON.parse(localStorage.getItem(FOLDED) ?? "[]")); } catch { /* A private window stores nothing. */ }
  slider.load(send);
  possible.load(draw);
  onLanguage(() => {
    texts.clear();
    draw();
  });
}

const sought = () => typed.trim().toLowerCase();
const send = (key, value, gesture) => edit([{ set: { key, value } }], gesture, { title: label(key) });
const draw = () => render(versions.now(), { fields: designs.known() });

export function reset() {
  slider.reset();
}

// Forgets the ends of the sliders, which belong to another scene.
export function anew() {
  slider.forgetEnds();
}

// Opens the field of a key.
export function focus(key) {
  tab("values");
  const section = keys.find((k) => k.key === key)?.section ?? "";
  if (folded.has(section)) fold(section, true);
  const field = document.getElementById(id(key));
  if (!field) return;
  field.closest("div").hidden = false;
  field.focus();
  field.scrollIntoView({ block: "center" });
}

// Draws the fields of the scene. Pending values of the version replace the values of the scene.
export function render(version, { fields }) {
  slider.follow(version);
  slider.seek(version, fields);
  const rows = keys.map((key) => row(key, version, fields));
  const isFound = rows.some((r) => r.isShown);
  put(html`
    <div class="find">
      <input type="search" id="find-value" aria-label=${t("studio-find")} placeholder=${t("studio-find")} .value=${live(typed)} @input=${find}>
      <button type="button" id="all-values" aria-pressed=${everything ? "true" : "false"} @click=${all}>${t("studio-all-values")}</button>
    </div>
    ${SECTIONS.map((name) => section(name, rows.filter((r) => (r.key.section ?? "") === name), fields))}
    ${isFound || sought() === "" ? nothing : html`<p class="lead" role="status">${t("studio-find-none", { text: typed.trim() })}</p>`}`, $("values"));
}

function row(key, version, fields) {
  const name = key.key;
  const field = fields[name];
  const change = version?.pending.findLast((p) => p.keys.includes(name));
  const sent = change?.edits.find((e) => e.set?.key === name)?.set.value;
  const fault = change?.fault ?? faultOf(name, version);
  const text = sent ?? field?.text ?? "";
  const isText = key.kind.startsWith("text") || key.kind === "choice" || key.kind === "flag";
  const isHidden = !fault && (!field || (!field.acts && text === "")) && sent === undefined;
  const isFirst = FIRST.includes(name) && field?.acts;
  const wanted = sought();
  const isAway = wanted === "" ? !everything && text === "" && !isFirst && !fault : !textOf(key).includes(wanted);
  return {
    key, field, fault, isHidden, isAway,
    isShown: !isHidden && !isAway,
    text: slider.held(name)?.text ?? (isText ? text : local(text)),
    isMain: MAIN.includes(name),
    isOpen: helped.has(name),
    isAimed: possible.aimed() === name,
    on: listeners(key, { of: (k) => designs.known()[k], send, draw, help: toggleHelp }),
  };
}

// Rejected change or fault of the scene with this key.
function faultOf(name, version) {
  const named = version?.pending.find((p) => p.fault?.key === name);
  return named?.fault ?? (version?.fault?.key === name ? version.fault : null);
}

function section(name, rows, fields) {
  if (rows.length === 0) return nothing;
  const isSearching = sought() !== "";
  const buttons = !isSearching ? (TOGETHER[name] ?? []).filter(([, values]) => isMissing(values, fields)) : [];
  const body = html`<div class="rows">${repeat(rows, (r) => r.key.key, template)}
    ${buttons.length === 0 ? nothing : html`<div class="buttons">${buttons.map(([what, values]) =>
      html`<button type="button" data-add=${what} @click=${() => together(what, values)}>${t(`studio-add-${what}`)}</button>`)}</div>`}</div>`;
  if (name === "") return body;
  const isBare = !rows.some((r) => r.isShown) && buttons.length === 0;
  const isOpen = isBare || isSearching || !folded.has(name);
  const toggle = (event) => {
    event.preventDefault();
    fold(name, !isOpen);
  };
  return html`<details class="section ${isBare ? "bare" : ""}" ?open=${isOpen}>
    <summary @click=${toggle}>${t(`studio-section-${name}`)}</summary>${body}</details>`;
}

function isMissing(values, fields) {
  const [first] = Object.keys(values);
  return Boolean(fields[first]?.acts) && Object.keys(values).every((key) => fields[key]?.text === "");
}

function together(what, values) {
  edit(Object.entries(values).map(([key, value]) => ({ set: { key, value } })), null, { title: t(`studio-add-${what}`) });
}

function fold(name, isOpen) {
  if (sought() !== "") return;
  if (isOpen) folded.delete(name);
  else folded.add(name);
  try { localStorage.setItem(FOLDED, JSON.stringify([...folded])); } catch { /* as above */ }
  draw();
}

function toggleHelp(name) {
  if (!helped.delete(name)) helped.add(name);
  draw();
}

function find({ target }) {
  typed = target.value;
  draw();
}

function all() {
  everything = !everything;
  draw();
}

// Text that is searched for a value.
function textOf(key) {
  if (!texts.has(key.key)) {
    const words = [key.key, label(key.key), help(key), key.doc[language()], ...key.choices.map(choice)];
    texts.set(key.key, words.join(" ").toLowerCase());
  }
  return texts.get(key.key);
}
