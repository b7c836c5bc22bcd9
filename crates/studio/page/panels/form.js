// The form, built from the key table: a text input for every value, a slider where a range makes sense.

import { $, make, hide, clear } from "../core/dom.js";
import { t, has, language, local, onLanguage } from "../core/words.js";
import { tab } from "../core/view.js";
import * as typed from "../core/typed.js";

const SECTIONS = ["", "gait", "drive", "law", "cam", "limits", "accuracy", "machine"];
// Values that most scenes turn on first.
const BASIC = ["name", "gait.step_frequency", "gait.body_weight", "drive.speed", "cam.follower", "limits.stroke", "limits.pressure_angle", "limits.curvature", "accuracy.rms"];
let keys = [];
let edit = () => {};
const rows = new Map();
let dragged = null;
let gesture = 0;
let known = {};
let everything = false;
// Fields whose rows are as they are shown.
let drawn = null;

export function load(table, onEdit) {
  keys = table.filter((k) => !k.key.includes(".N."));
  edit = onEdit;
  build();
  onLanguage(build);
}

function id(key) {
  return "f-" + key.replaceAll(".", "-");
}

export function label(key) {
  const known = `studio-key-${key.replaceAll(".", "-")}`;
  if (has(known)) return t(known);
  // An entry of a list: its number tells it from the others.
  const [, number] = /\.(\d+)\./.exec(key) ?? [];
  const column = key.split(".").at(-1);
  const name = has(`studio-column-${column}`) ? t(`studio-column-${column}`) : column.replaceAll("_", " ");
  return number ? `${name} ${number}` : name;
}

function build() {
  const root = clear($("values"));
  const search = make("input", { type: "search", id: "find-value", "aria-label": t("studio-find"), placeholder: t("studio-find"), oninput: find });
  const all = make("button", { type: "button", id: "all-values", "aria-pressed": String(everything), onclick: () => {
    everything = !everything;
    all.setAttribute("aria-pressed", String(everything));
    spread();
  } }, t("studio-all-values"));
  root.append(make("div", { class: "find" }, search, all));
  const old = new Map(rows);
  rows.clear();
  for (const section of SECTIONS) {
    const mine = keys.filter((k) => (k.section ?? "") === section);
    if (mine.length === 0) continue;
    const body = make("div", { class: "rows" });
    for (const key of mine) body.append(row(key));
    const fold = section === "" ? body : make("details", { open: true, class: "section" },
      make("summary", {}, t(`studio-section-${section}`)), body);
    root.append(fold);
  }
  drawn = null;
  for (const [key, before] of old) if (before.field) show(rows.get(key), before.field);
  spread();
}

function row(key) {
  const name = key.key;
  const entry = { key, field: null, slid: null, border: null };
  const help = make("p", { class: "help", id: id(name) + "-help", hidden: true }, key.doc[language()]);
  entry.fault = make("p", { class: "row-fault", id: id(name) + "-fault", hidden: true });
  entry.input = input(key);
  const more = make("button", { type: "button", class: "ask", tabindex: "-1", "aria-expanded": "false", "aria-controls": help.id,
    "aria-label": t("studio-help", { name: label(name) }), onclick: () => {
      help.hidden = !help.hidden;
      more.setAttribute("aria-expanded", String(!help.hidden));
    } }, "?");
  entry.slider = make("input", { type: "range", "data-key": name, hidden: true, tabindex: "0", min: 0, max: 1, step: "any",
    "aria-label": t("studio-slider", { name: label(name) }) });
  slide(entry);
  entry.text = `${name} ${label(name)} ${key.doc[language()]}`.toLowerCase();
  entry.root = make("div", { class: BASIC.includes(name) ? "row basic" : "row", "data-row": name },
    make("label", { for: id(name), title: `${name}: ${key.doc[language()]}` }, label(name)), more, entry.input, entry.slider, help, entry.fault);
  rows.set(name, entry);
  return entry.root;
}

function input(key) {
  const shared = { id: id(key.key), name: key.key, "aria-describedby": `${id(key.key)}-help ${id(key.key)}-fault` };
  if (key.kind === "choice") {
    const select = make("select", shared, make("option", { value: "" }, ""));
    for (const word of key.choices) select.append(make("option", { value: word }, word));
    select.addEventListener("change", () => send(key.key, select.value, "choice"));
    return select;
  }
  if (key.kind === "flag") {
    const select = make("select", shared);
    for (const [value, text] of [["", "–"], ["true", t("studio-yes")], ["false", t("studio-no")]]) {
      select.append(make("option", { value }, text));
    }
    select.addEventListener("change", () => send(key.key, select.value, "choice"));
    return select;
  }
  const field = make("input", { ...shared, type: "text", autocomplete: "off", spellcheck: "false" });
  field.addEventListener("focus", () => { gesture += 1; });
  field.addEventListener("input", () => send(key.key, field.value, "typed"));
  field.addEventListener("keydown", (event) => {
    if (event.key === "Enter") gesture += 1;
    if (event.key === "ArrowUp" || event.key === "ArrowDown") nudge(key.key, event);
  });
  return field;
}

function send(key, text, how) {
  if (how === "choice") gesture += 1;
  const entry = rows.get(key);
  // What stands in the page is no longer what the last design said.
  forget(entry);
  const unit = entry.field?.slider?.unit.trim() || typed.unitOf(entry.field?.text) || typed.unitOf(entry.field?.placeholder);
  const value = how === "typed" ? typed.value(text, unit) : text;
  edit([{ set: { key, value } }], `${key} ${gesture}`, { title: label(key) });
}

// Up and down change the number by one step of its slider.
function nudge(key, event) {
  const { input, slider, field } = rows.get(key);
  if (!field?.slider || slider.hidden) return;
  event.preventDefault();
  const sign = event.key === "ArrowUp" ? 1 : -1;
  const step = field.slider.step * (event.shiftKey ? 10 : 1);
  input.value = written(Number(slider.value) + sign * step, field.slider);
  slider.value = parseFloat(input.value);
  send(key, input.value, "typed");
}

// A key on a slider goes to the next round number; keys in quick succession are one step of the history.
let pressed = 0;
function turn(entry, way, event) {
  event.preventDefault();
  const { slider, key } = entry;
  const range = entry.field.slider.to - entry.field.slider.from;
  const step = 10 ** Math.floor(Math.log10(range / 20)) * (event.shiftKey ? 10 : 1);
  const at = Number(slider.value) / step;
  const next = (way > 0 ? Math.floor(at + 1 + 1e-6) : Math.ceil(at - 1 - 1e-6)) * step;
  const inside = Math.max(entry.field.slider.from, Math.min(entry.field.slider.to, next));
  if (event.timeStamp - pressed > 1000) gesture += 1;
  pressed = event.timeStamp;
  entry.input.value = written(inside, entry.field.slider);
  slider.value = inside;
  send(key.key, entry.input.value, "slid");
}

function written(x, slider) {
  const decimals = Math.max(0, Math.min(8, -Math.floor(Math.log10(slider.step) + 1e-9)));
  return Number(x.toFixed(decimals)) + slider.unit;
}

function slide(entry) {
  const { slider, key } = entry;
  slider.addEventListener("pointerdown", () => { gesture += 1; });
  slider.addEventListener("input", () => {
    dragged = key.key;
    Object.assign(entry, { slid: Number(slider.value), border: null, of: `${key.key} ${gesture}` });
    entry.input.value = written(Number(slider.value), entry.field.slider);
    send(key.key, entry.input.value, "slid");
  });
  slider.addEventListener("change", () => {
    dragged = null;
    gesture += 1;
  });
  slider.addEventListener("keydown", (event) => {
    const way = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[event.key];
    if (way && entry.field?.slider) turn(entry, way, event);
  });
}

// The fields of the scene; over them the values of the version that no design has.
export function render(version, { fields }) {
  known = fields;
  if (drawn !== known) shown(known);
  drawn = known;
  overlay(version);
}

// The next update shows a row again.
function forget(entry) {
  entry.seen = null;
  drawn = null;
}

function overlay(version) {
  clearFault();
  for (const { edits, fault: refusal } of version?.pending ?? []) {
    for (const { set } of edits) {
      const entry = set && rows.get(set.key);
      if (!entry) continue;
      const typing = document.activeElement === entry.input && entry.input.tagName === "INPUT" && !entry.forced;
      if (!typing && dragged !== set.key) entry.input.value = set.value;
      forget(entry);
      entry.root.classList.add("set");
      if (refusal && entry.slid !== null) shorten(entry);
      else if (refusal) mark(entry, refusal);
    }
    const named = refusal?.key && rows.get(refusal.key);
    if (named && named.fault.hidden) mark(named, refusal);
  }
  if (version?.pending.length === 0) for (const entry of rows.values()) if (entry.slid !== null) taken(entry);
  if (version?.fault?.key && rows.has(version.fault.key)) mark(rows.get(version.fault.key), version.fault);
  for (const entry of rows.values()) entry.forced = false;
  spread();
}

// A slider ends where the scene ends: between the last value that was taken and one that was refused the border is
// sought, and the slider gets it as its end.
const HALVINGS = 7;
function shorten(entry) {
  const { slider, key, field } = entry;
  entry.border ??= { good: field.slider.at, bad: entry.slid, left: HALVINGS };
  const { border } = entry;
  border.bad = entry.slid;
  border.left -= 1;
  const done = border.left <= 0 || Math.abs(border.bad - border.good) <= 1.5 * field.slider.step;
  const value = done ? border.good : (border.good + border.bad) / 2;
  if (done) {
    const end = border.bad > border.good ? "to" : "from";
    entry.field = { ...field, slider: { ...field.slider, [end]: value } };
    slider[end === "to" ? "max" : "min"] = value;
    entry.border = null;
  }
  entry.slid = done ? null : value;
  entry.input.value = written(value, field.slider);
  slider.value = value;
  // Still the same step of the history, though the hand may have left the slider.
  const change = [{ set: { key: key.key, value: entry.input.value } }];
  setTimeout(() => edit(change, entry.of, { title: label(key.key) }));
}

// The value under the slider was taken; the border lies further out.
function taken(entry) {
  if (!entry.border) {
    entry.slid = null;
    return;
  }
  entry.border.good = entry.slid;
  entry.slid = entry.border.bad;
  shorten(entry);
}

// Few values first: what the scene uses; the others on demand.
function spread() {
  for (const entry of rows.values()) {
    const { root, input, slider } = entry;
    const away = !everything && !root.matches(".set, .basic:not(.idle), .faulty") && !root.hidden;
    if (entry.away === away) continue;
    entry.away = away;
    root.classList.toggle("unused", away);
    for (const stop of [input, slider]) stop.tabIndex = away ? -1 : 0;
  }
}

function shown(fields) {
  let moved = false;
  for (const [key, entry] of rows) {
    const field = fields[key];
    const hidden = !field || (!field.acts && field.text === "");
    moved = moved || hidden !== entry.root.hidden;
    hide(entry.root, hidden);
    // Most fields are as they were: only the others touch the page.
    if (field === entry.given && entry.seen !== null) continue;
    const seen = JSON.stringify(field);
    if (field && seen !== entry.seen) show(entry, field);
    Object.assign(entry, { seen, given: field });
  }
  if (!moved) return;
  for (const fold of document.querySelectorAll("#values .section")) {
    fold.hidden = ![...fold.querySelectorAll(".row")].some((row) => !row.hidden);
  }
}

function show(entry, field) {
  const { input, slider, key } = entry;
  const typing = document.activeElement === input && input.tagName === "INPUT" && !entry.forced;
  if (!typing && dragged !== key.key) input.value = field.text;
  if (input.tagName === "INPUT") input.placeholder = local(field.placeholder);
  else if (input.options[0]?.value === "" && key.kind === "choice") input.options[0].textContent = field.placeholder ? `(${field.placeholder})` : "–";
  entry.root.classList.toggle("idle", !field.acts);
  entry.root.classList.toggle("set", field.text !== "");
  // A range of rounding is none.
  const range = field.slider && field.slider.to - field.slider.from > 1e-9;
  hide(slider, !range);
  if (!range) {
    entry.field = field;
    return;
  }
  const before = entry.field?.slider;
  const at = field.slider.at;
  // Under the hand the ends of a slider stay where they are.
  const keeps = before && before.unit === field.slider.unit && (dragged === key.key || (at > before.from && at < before.to));
  entry.field = keeps ? { ...field, slider: { ...before, at } } : field;
  const { from, to } = entry.field.slider;
  if (!keeps) Object.assign(slider, { min: from, max: to });
  if (dragged !== key.key) slider.value = at;
  slider.setAttribute("aria-valuetext", input.value || field.placeholder);
}

function mark(entry, error) {
  entry.root.hidden = false;
  entry.root.classList.add("faulty");
  entry.input.setAttribute("aria-invalid", "true");
  entry.fault.hidden = false;
  const text = error.help ? `${error.message}; ${error.help}` : error.message;
  if (entry.fault.textContent !== text) entry.fault.textContent = text;
}

function clearFault() {
  for (const { root, input, fault } of rows.values()) {
    if (fault.hidden) continue;
    root.classList.remove("faulty");
    input.removeAttribute("aria-invalid");
    fault.hidden = true;
  }
}

// Goes to the field of a key.
export function focus(key) {
  tab("values");
  const entry = rows.get(key);
  if (!entry) return;
  entry.root.hidden = false;
  entry.input.focus();
  entry.root.scrollIntoView({ block: "center" });
}

function find() {
  const wanted = ($("find-value")?.value ?? "").trim().toLowerCase();
  $("values").classList.toggle("searching", wanted !== "");
  for (const { root, text } of rows.values()) root.classList.toggle("unfound", wanted !== "" && !text.includes(wanted));
}

export function reset() {
  dragged = null;
  drawn = null;
  for (const entry of rows.values()) Object.assign(entry, { field: null, seen: null, forced: true, slid: null, border: null });
}
