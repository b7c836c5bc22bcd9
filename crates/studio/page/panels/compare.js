// The slate of pinned designs, sensitivity bars, the trade-off front; below them runs and sweeps.

import { $, make, clear, svg, notice } from "../core/dom.js";
import { t, number, local, onLanguage } from "../core/words.js";
import { engine } from "../core/net.js";
import { onTab, openTab } from "../core/view.js";
import * as blobs from "../core/blobs.js";
import * as designs from "../core/designs.js";
import * as versions from "../core/versions.js";
import { label } from "./form.js";
import * as units from "../core/units.js";
import * as runs from "./runs.js";
import * as stage from "./stage.js";
import * as charts from "../charts/charts.js";

const COLOURS = ["#e69f00", "#cc79a7", "#009e73", "#d55e00", "#56b4e9", "#8a7a00"];
const slate = () => versions.history().pins.filter((p) => p.curves);
let answer = null;
let start = {};
let edit = () => {};
let openScene = () => {};
let bars = null;
let front = null;
// Colour of the pinned design whose difference to the present one is shown.
let against = null;

export function load(page) {
  ({ start, edit, openScene } = page);
  onTab("compare", build);
  onLanguage(() => { if (openTab() === "compare") build(); });
}

export function render(version, { answer: next, moving }) {
  if (answer === next) return;
  answer = next;
  if (!moving && openTab() === "compare") {
    table();
    age();
  }
}

export function pin() {
  if (!designs.isCurrent()) return;
  const { pins } = versions.history();
  const { files, hand, recording } = versions.now();
  const colour = COLOURS.find((c) => !pins.some((p) => p.colour === c)) ?? COLOURS[pins.length % COLOURS.length];
  versions.pin({ ...pictured(designs.present().answer), files, hand, recording, colour });
  overlay();
}

const pictured = ({ name, scene, curves, numbers, verdict, fields }) => ({ name, scene, curves, numbers, verdict, inputs: inputsOf(fields) });

// After a reload the pinned scenes are designed again.
export async function restore() {
  for (const pin of versions.history().pins) {
    if (pin.curves) continue;
    try {
      await blobs.ensure(pin.files);
      const design = await engine.ask("design", { scene: pin.scene, changes: [], files: blobs.listed(pin.files), colour: "none" });
      versions.setPins(versions.history().pins.map((p) => (p === pin ? { ...pin, ...pictured(design), name: pin.name } : p)));
    } catch { /* its file is gone: the pin stays without a picture */ }
  }
  overlay();
}

function overlay() {
  charts.compare(slate(), slate().find((p) => p.colour === against));
  stage.compare(slate());
  if (openTab() === "compare") table();
}

function build() {
  const root = clear($("compare"));
  root.append(make("h2", {}, t("studio-slate")), make("p", { class: "lead" }, t("studio-slate-lead")),
    make("button", { type: "button", class: "main", onclick: pin }, t("studio-pin")), make("div", { id: "slate" }),
    make("h2", {}, t("studio-sensitivity")), make("p", { class: "lead" }, t("studio-sensitivity-lead")));
  const quantity = make("select", { id: "watched", "aria-label": t("studio-sensitivity-of") }, ...start.figures.map(([q]) => make("option", { value: q }, t(`figure-${q}`))));
  if (answer && !answer.curves.panels[0].lines.some((l) => l.role === "target")) quantity.value = "acceleration_max_m_per_s2";
  if (bars) quantity.value = bars.quantity;
  root.append(make("div", { class: "buttons" }, quantity, make("button", { type: "button", id: "vary", onclick: () => vary(quantity.value) }, t("studio-compute"))), make("div", { id: "tornado" }),
    make("h2", {}, t("studio-front")), make("p", { class: "lead" }, t("studio-front-lead")));
  const against = make("select", { id: "against", "aria-label": t("studio-front-against") }, ...start.trades.map((q) => make("option", { value: q }, t(`figure-${q}`))));
  root.append(make("div", { class: "buttons" }, against, make("button", { type: "button", id: "trade", onclick: () => trade(against.value) }, t("studio-compute"))), make("div", { id: "front" }));
  if (answer) root.append(...runs.sections({ ask, fields: answer.fields, figures: start.figures, edit, take: next }));
  table();
  if (bars) tornado();
  if (front) points();
  age();
}

const replace = (pin, change) => versions.setPins(versions.history().pins.map((p) => (p.colour === pin.colour ? { ...p, ...change } : p)));

// Name, return, difference and removal of a pinned design.
function variant(p, i) {
  const name = make("input", { type: "text", class: "variant", value: p.name, size: 12, "aria-label": `${t("studio-slate-name")} ${i}`, onchange: () => replace(p, { name: name.value }) });
  const button = (label, text, onclick, more = {}) => make("button", { type: "button", class: "tiny", "aria-label": `${t(label)} ${i}`, title: t(label), onclick, ...more }, text);
  return [name, make("span", { class: "acts" },
    button("studio-slate-take", "↩", () => openScene(p.scene, { files: p.files, hand: p.hand, recording: p.recording })),
    button("studio-slate-difference", "Δ", () => { against = against === p.colour ? null : p.colour; overlay(); }, { "aria-pressed": String(against === p.colour) }),
    button("studio-slate-drop", "×", () => { versions.setPins(versions.history().pins.filter((q) => q.colour !== p.colour)); overlay(); }))];
}

function table() {
  const box = $("slate");
  if (!box || box.contains(document.activeElement?.closest("input"))) return;
  clear(box);
  if (slate().length === 0) return;
  const all = [{ ...answer, inputs: inputsOf(answer.fields), colour: "var(--blue)", name: t("studio-slate-present"), present: true }, ...slate()];
  const head = all.map((p, i) => make("th", { scope: "col" }, make("span", { class: "swatch", style: `background:${p.colour}` }), ...(p.present ? [p.name] : variant(p, i))));
  const body = start.figures.map(([name, [of, plain]]) => [name, units.unit(of)[0], plain * units.unit(of)[1]]).map(([name, unit, factor]) => make("tr", {}, make("th", { scope: "row" }, t(`figure-${name}`), make("small", {}, ` ${unit}`)),
    ...all.map((p) => make("td", { class: "n" }, number(p.numbers[name] === null || p.numbers[name] === undefined ? null : factor * p.numbers[name])))));
  const verdicts = make("tr", {}, make("th", { scope: "row" }, t("studio-verdict")), ...all.map((p) => make("td", { class: `n ${p.verdict}` }, t(`studio-verdict-${p.verdict}`))));
  const inputs = differing(all).map(([key, values]) => make("tr", { class: "input" }, make("th", { scope: "row" }, label(key)), ...values.map((v) => make("td", { class: "n" }, units.text(local(v))))));
  box.append(make("div", { class: "scroll", tabindex: "0" }, make("table", { class: "slate" }, make("thead", {}, make("tr", {}, make("td", {}), ...head)), make("tbody", {}, ...inputs, verdicts, ...body))));
}

// The values of the scenes that are not the same in all of them.
function differing(all) {
  const keys = new Set(all.flatMap((p) => Object.keys(p.inputs ?? {})));
  const rows = [...keys].map((key) => [key, all.map((p) => p.inputs?.[key] ?? "")]);
  return rows.filter(([key, values]) => key !== "name" && new Set(values).size > 1);
}

// The values that a scene has, by their keys.
const inputsOf = (fields) => Object.fromEntries(Object.entries(fields).filter(([, f]) => f.text !== "").map(([key, f]) => [key, f.text]));

// The scene on the screen with its files.
const present = () => ({ scene: designs.present().answer.scene, files: blobs.listed(designs.present().files) });

// Boxes with what each was computed from: those of a design that is no longer on the screen are dimmed.
const computed = new Map();

async function ask(route, box, question = {}) {
  const of = present();
  const found = await engine.ask(route, { ...of, ...question });
  computed.set(box, JSON.stringify(of));
  age();
  return found;
}

// A scene with the files of the present version.
function next(scene) {
  const { files, hand, recording } = versions.now();
  openScene(scene, { files, hand, recording });
}

function age() {
  for (const [box, of] of computed) $(box)?.classList.toggle("stale", of !== JSON.stringify(present()));
}

async function vary(quantity) {
  try {
    bars = await ask("sensitivity", "tornado", { quantity, share: 0.05 });
    tornado();
  } catch (error) {
    notice(error.message);
  }
}

function tornado() {
  const box = clear($("tornado"));
  if (bars.bars.length === 0) {
    box.append(make("p", {}, t("studio-sensitivity-none")));
    return;
  }
  const most = Math.max(...bars.bars.flatMap((b) => [b.low, b.high]).filter((x) => x !== null).map((x) => Math.abs(x - bars.middle))) || 1;
  box.append(make("p", {}, units.text(`${t(`figure-${bars.quantity}`)}: ${bars.shown}`)));
  const rows = bars.bars.map((bar) => {
    const part = (x) => (x === null ? 0 : (x - bars.middle) / most * 50);
    const side = (x, kind) => {
      const p = part(x);
      return make("i", { class: kind, style: `left:${50 + Math.min(0, p)}%;width:${Math.abs(p)}%` });
    };
    return make("tr", {}, make("th", { scope: "row", title: bar.key }, label(bar.key)),
      make("td", { class: "bar" }, side(bar.low, "less"), side(bar.high, "more")),
      make("td", { class: "n" }, units.text(`${bar.shown[0] ?? "–"} … ${bar.shown[1] ?? "–"}`)));
  });
  box.append(make("table", { class: "tornado" }, make("tbody", {}, ...rows)),
    make("p", { class: "key" }, make("i", { class: "less" }), t("studio-minus"), " ", make("i", { class: "more" }), t("studio-plus")));
}

async function trade(against) {
  try {
    front = await ask("front", "front", { against });
    points();
  } catch (error) {
    notice([error.place, error.message, error.help].filter(Boolean).join(" – "));
  }
}

function points() {
  const box = clear($("front"));
  const list = front.points;
  if (list.length === 0) {
    box.append(make("p", {}, t("studio-front-none")));
    return;
  }
  const [width, height] = [360, 230];
  const [xs, ys] = [list.map((p) => p.x), list.map((p) => p.y)];
  const scale = (values, a, b) => {
    const [low, high] = [Math.min(...values), Math.max(...values)];
    return (v) => a + (high > low ? (v - low) / (high - low) : 0.5) * (b - a);
  };
  const [x, y] = [scale(xs, 54, width - 20), scale([0, ...ys], height - 34, 30)];
  const picture = svg("svg", { class: "front", viewBox: `0 0 ${width} ${height}`, role: "group", "aria-label": t("studio-front") });
  picture.append(svg("path", { class: "axis", d: `M54 8V${height - 34}H${width - 8}` }),
    svg("path", { class: "line main", d: list.map((p, i) => `${i ? "L" : "M"}${x(p.x)} ${y(p.y)}`).join("") }));
  const text = (at, content, anchor) => {
    const e = svg("text", { class: "tick", x: at[0], y: at[1], "text-anchor": anchor });
    e.textContent = content;
    picture.append(e);
  };
  text([54, height - 20], number(Math.min(...xs), 3), "middle");
  text([width - 20, height - 20], number(Math.max(...xs), 3), "middle");
  text([width / 2, height - 5], `${t(`figure-${front.against}`)}, ${front.unit}`, "middle");
  text([50, 34], number(Math.max(...ys), 3), "end");
  text([50, height - 34], "0", "end");
  text([60, 14], `${t("figure-force_rms_error_n")}, N`, "start");
  for (const p of list) {
    const name = units.text(`${p.shown[0]}, ${p.shown[1]}`);
    const take = () => edit([{ set: { key: p.key, value: p.value } }]);
    const dot = svg("circle", { class: `knot ${p.verdict}`, cx: x(p.x), cy: y(p.y), r: 6, tabindex: 0, role: "button", "aria-label": name });
    const title = svg("title");
    title.textContent = name;
    dot.append(title);
    dot.addEventListener("click", take);
    dot.addEventListener("keydown", (event) => { if (event.key === "Enter" || event.key === " ") { event.preventDefault(); take(); } });
    picture.append(dot);
  }
  box.append(picture);
}
