// All diagrams with one cursor: which are shown, which is large, what is dragged on them.

import { $, make, clear, say } from "../core/dom.js";
import { Chart } from "./chart.js";
import * as clock from "../core/clock.js";
import { dialog, embedded } from "../core/view.js";
import { t, number, onLanguage } from "../core/words.js";
import { label } from "../panels/form.js";
import * as hand from "../panels/hand.js";
import * as units from "../core/units.js";
import * as handles from "./handles.js";

const GHOST = 1500;
const charts = new Map();
let shown = null;
let fields = {};
let pinned = [];
let ghost = null;
let fading = 0;
let large = null;
let hidden = new Set();
let edit = () => {};

export function load(onEdit) {
  edit = onEdit;
  try { hidden = new Set(JSON.parse(localStorage.getItem("gaitcam-hidden") ?? "[]")); } catch { /* private windows keep nothing */ }
  clock.onAngle(() => { for (const chart of charts.values()) chart.follow(); });
  onLanguage(again);
  units.watch(again);
}

export function show(raw, next = fields) {
  shown = raw;
  fields = next;
  const curves = { ...raw, panels: raw.panels.map(units.panel) };
  const ids = curves.panels.map((p) => p.id);
  for (const [id, chart] of charts) {
    if (ids.includes(id)) continue;
    chart.root.remove();
    charts.delete(id);
  }
  const first = ids.includes(large) ? large : usual(curves);
  const seen = curves.panels.filter((p) => (embedded ? embedded.includes(p.id) : p.id === first || !hidden.has(p.id))).sort((a, b) => (b.id === first) - (a.id === first));
  for (const [id, chart] of charts) if (!seen.some((p) => p.id === id)) chart.root.remove();
  $("charts").style.setProperty("--rows", Math.ceil((seen.length - 1) / 2));
  seen.forEach((panel, i) => {
    const chart = charts.get(panel.id) ?? made(panel.id);
    const at = $("charts").children[i];
    if (at !== chart.root) $("charts").insertBefore(chart.root, at ?? null);
    chart.root.classList.toggle("large", i === 0);
    chart.root.classList.toggle("labelled", i === 0 || i >= seen.length - 2);
    chart.fields = fields;
    chart.show(curves, panel, [...under(panel, ghost ? [{ curves: ghost }] : []), ...under(panel, pinned)]);
  });
}

// Of a programme the lift is large, of a wanted force the force.
const usual = ({ panels }) => (panels[0].lines.some((l) => l.role === "target") ? "force" : "s");

const under = (panel, list) => list.flatMap(({ curves, colour }) => {
  const same = curves.panels.map((p) => (p.id === panel.id ? units.panel(p) : null)).find((p) => p?.unit === panel.unit);
  return same ? [{ curves, panel: same, colour }] : [];
});

function made(id) {
  const chart = new Chart(id);
  charts.set(id, chart);
  chart.labelOf = label;
  chart.onEnlarge = enlarge;
  chart.onSay = (text) => say($("spoken"), text);
  if (embedded) return chart;
  chart.onLimit = (key, value, gesture) => edit([{ set: { key, value } }], gesture, { title: label(key) });
  chart.onSegment = (edits, gesture) => edit(edits, gesture, { title: t("studio-programme") });
  if (id === "force") Object.assign(chart, { overlay: hand.overlay, onKnot: hand.place });
  return chart;
}

export function enlarge(id) {
  large = id;
  again();
}

// The next one becomes the large diagram.
export function step(by) {
  const ids = shown.panels.map((p) => p.id);
  const at = ids.indexOf($("charts").firstElementChild.dataset.chart);
  enlarge(ids[(at + by + ids.length) % ids.length]);
}

// The design before a gesture stays behind it as a faint line, and goes when the hand has rested.
export function leave(curves) {
  ghost = curves;
  clearTimeout(fading);
  fading = setTimeout(() => { ghost = null; again(); }, GHOST);
}

export function linger() {
  if (!ghost) return;
  clearTimeout(fading);
  fading = setTimeout(() => { ghost = null; again(); }, GHOST);
}

// Designs to lie under the present one.
export function compare(list) {
  pinned = list;
  again();
}

function again() {
  if (!shown) return;
  show(shown);
  clock.set(clock.angle());
}

// Which diagrams are shown.
export function choose() {
  dialog("studio-diagrams-choose", (body) => {
    body.className = "choices";
    for (const { id } of shown.panels) {
      const tick = make("input", { type: "checkbox", id: `diagram-${id}`, checked: !hidden.has(id), onchange: () => {
        if (tick.checked) hidden.delete(id);
        else hidden.add(id);
        try { localStorage.setItem("gaitcam-hidden", JSON.stringify([...hidden])); } catch { /* as above */ }
        again();
      } });
      body.append(make("p", {}, tick, " ", make("label", { for: tick.id }, charts.get(id)?.name() ?? t(`studio-chart-${id}`))));
    }
  });
}

// The large diagram as a table by degree; a row sets the cursor.
export function table() {
  dialog("studio-table", (body) => {
    body.className = "data";
    const chart = charts.get($("charts").firstElementChild.dataset.chart);
    const { lines, rows } = handles.table(chart, body);
    const head = make("tr", {}, make("th", { scope: "col" }, `θ, ${chart.curves.unit}`), ...lines.map((l) => make("th", { scope: "col" }, `${t(`studio-line-${l.role}`)}, ${chart.panel.unit}`)));
    const row = ([theta, ...values]) => make("tr", { "data-theta": theta }, make("th", { scope: "row" }, String(Number(theta.toFixed(2)))), ...values.map((y) => make("td", { class: "n" }, number(y))));
    const there = make("input", { type: "text", id: "go-to", size: 6, inputmode: "decimal", oninput: () => {
      const theta = parseFloat(there.value.replace(",", "."));
      const found = [...body.querySelectorAll("[data-theta]")].find((e) => Number(e.dataset.theta) >= theta - 1e-9);
      for (const e of body.querySelectorAll(".here")) e.classList.remove("here");
      found?.classList.add("here");
      found?.scrollIntoView({ block: "center" });
      if (found) clock.set(theta);
    } });
    body.append(make("p", { class: "go" }, make("strong", {}, chart.name()), " ", make("label", { for: "go-to" }, t("studio-go-to")), there),
      make("div", { class: "scroll", tabindex: "0" }, make("table", {}, make("thead", {}, head), make("tbody", {}, ...rows.map(row)))));
  });
}
