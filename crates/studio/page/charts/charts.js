// All diagrams with one cursor: selection, large diagram, and actions by dragging.

import { $, html, render, say } from "../core/dom.js";
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
// Pinned design whose curves are subtracted from those of the present design.
let less = null;
// Displayed part of the turn, as fractions.
let part = [0, 1];
let ghost = null;
let fading = 0;
let large = null;
let margin = 0;
// Diagrams that the user has selected or deselected.
let chosen = {};
// Without a load on the cam, forces, torque and power are those of one kilogram.
let isIdle = false;
const PRESSED = ["force", "torque", "power"];
/** @type {Function} */
let edit = () => {};

export function load(onEdit) {
  edit = onEdit;
  try { chosen = JSON.parse(localStorage.getItem("gaitcam-diagrams") ?? "{}"); } catch { /* A private window stores nothing. */ }
  clock.onAngle(() => { for (const chart of charts.values()) chart.follow(); });
  onLanguage(again);
  units.watch(again);
}

const isChosen = (id) => chosen[id] ?? !(isIdle && PRESSED.includes(id));

export function show(raw, next = fields, idle = isIdle) {
  isIdle = idle;
  if (shown && shown.length !== raw.length) part = [0, 1];
  shown = raw;
  fields = next;
  const panels = less ? raw.panels.flatMap((p) => difference(raw, p)) : raw.panels;
  const curves = zoomed({ ...raw, panels: panels.map(units.panel) });
  const ids = curves.panels.map((p) => p.id);
  for (const [id, chart] of charts) {
    if (ids.includes(id)) continue;
    chart.root.remove();
    charts.delete(id);
  }
  const first = ids.includes(large) ? large : usual(raw);
  const isSeen = ({ id }) => (embedded ? embedded.includes(id) : id === first || isChosen(id));
  const seen = curves.panels.filter(isSeen).sort((a, b) => Number(b.id === first) - Number(a.id === first));
  for (const [id, chart] of charts) if (!seen.some((p) => p.id === id)) chart.root.remove();
  $("charts").style.setProperty("--rows", Math.ceil((seen.length - 1) / 2));
  const drawn = seen.map((panel, i) => {
    const chart = charts.get(panel.id) ?? made(panel.id);
    const at = $("charts").children[i];
    if (at !== chart.root) $("charts").insertBefore(chart.root, at ?? null);
    chart.root.classList.toggle("large", i === 0);
    chart.root.classList.toggle("labelled", i === 0 || i >= seen.length - 2);
    chart.fields = less ? {} : fields;
    chart.isMoving = Boolean(ghost);
    chart.take(curves, panel, less ? [] : [...under(panel, ghost ? [{ curves: ghost }] : []), ...under(panel, pinned)]);
    return chart;
  });
  align(drawn);
  for (const chart of drawn) chart.draw();
}

// Aligns the left ends of all diagrams by the widest number. The margin does not shrink during a gesture.
function align(list) {
  const before = margin;
  margin = Math.max(ghost ? margin : 0, ...list.map((chart) => chart.room()));
  for (const chart of list) chart.left = margin;
  return margin !== before;
}

// Diagrams of another size have other numbers on their axes.
function resized() {
  const list = [...charts.values()].filter((chart) => chart.root.isConnected);
  if (align(list)) for (const chart of list) chart.draw();
}

// Default large diagram: the force if there is a target force, otherwise the lift.
const usual = ({ panels }) => (panels[0].lines.some((l) => l.role === "target") ? "force" : "s");

const under = (panel, list) => list.flatMap(({ curves, colour, name }) => {
  const same = curves.panels.map((p) => (p.id === panel.id ? units.panel(p) : null)).find((p) => p?.unit === panel.unit);
  return same ? [{ curves: zoomed(curves), panel: same, colour, name }] : [];
});

const zoomed = (curves) => ({ ...curves, from: curves.start + part[0] * curves.length, span: (part[1] - part[0]) * curves.length });

// Zooms about an angle by a factor. Without a factor, the whole turn is displayed.
function zoom(factor, theta) {
  const at = (theta - shown.start) / shown.length;
  const [low, before] = [part[0], part[1] - part[0]];
  const size = factor ? Math.max(0.01, Math.min(1, before * factor)) : 1;
  const from = Math.max(0, Math.min(1 - size, at - (at - low) * size / before));
  part = [from, from + size];
  again();
}

// Main curve of a diagram minus that of the pinned design at the same fraction of the turn; empty if the pinned design has no such diagram.
function difference(raw, panel) {
  const other = less.curves.panels.find((p) => p.id === panel.id && p.unit === panel.unit);
  if (!other) return [];
  const [mine, theirs] = [panel, other].map((p) => p.lines.find((l) => l.role === "main").y);
  const there = less.curves.theta.map((theta) => (theta - less.curves.start) / less.curves.length);
  const same = there.length === mine.length;
  let k = 0;
  const y = mine.map((value, i) => {
    const u = (raw.theta[i] - raw.start) / raw.length;
    if (same && Math.abs(there[i] - u) < 1e-5) return value === null || theirs[i] === null ? null : value - theirs[i];
    while (k + 2 < there.length && there[k + 1] < u) k += 1;
    const [a, b] = [theirs[k], theirs[k + 1]];
    if (value === null || a === null || b === null) return null;
    const step = there[k + 1] - there[k];
    return value - a - (step > 0 ? Math.max(0, Math.min(1, (u - there[k]) / step)) : 0) * (b - a);
  });
  return [{ ...panel, isDifference: true, lines: [{ role: "main", y }], levels: [] }];
}

function made(id) {
  const chart = new Chart(id);
  charts.set(id, chart);
  chart.labelOf = label;
  chart.onEnlarge = enlarge;
  chart.onSay = (text) => say($("spoken"), text);
  chart.onZoom = zoom;
  chart.onResize = resized;
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

// Makes the next diagram the large one.
export function step(by) {
  const ids = shown.panels.map((p) => p.id);
  const at = ids.indexOf($("charts").firstElementChild.dataset.chart);
  enlarge(ids[(at + by + ids.length) % ids.length]);
}

// Shows the design before a gesture as a faint line. The line disappears after a pause.
export function leave(curves) {
  ghost = curves;
  clearTimeout(fading);
  fading = setTimeout(() => { ghost = null; again(); }, GHOST);
}

// Removes the line of the earlier design when another scene is opened.
export function forget() {
  clearTimeout(fading);
  ghost = null;
}

export function linger() {
  if (!ghost) return;
  clearTimeout(fading);
  fading = setTimeout(() => { ghost = null; again(); }, GHOST);
}

// Sets the designs that are drawn behind the present one, and the design that is subtracted from it.
export function compare(list, taken = null) {
  pinned = list;
  less = taken;
  again();
}

function again() {
  if (!shown) return;
  show(shown);
  clock.set(clock.angle());
}

// Opens the selection of the displayed diagrams.
export function choose() {
  const tick = (id) => ({ target }) => {
    chosen = { ...chosen, [id]: target.checked };
    try { localStorage.setItem("gaitcam-diagrams", JSON.stringify(chosen)); } catch { /* as above */ }
    again();
  };
  dialog("studio-diagrams-choose", (body) => {
    body.className = "choices";
    render(shown.panels.map(({ id }) => html`<p><input type="checkbox" id="diagram-${id}" ?checked=${isChosen(id)} @change=${tick(id)}>
      <label for="diagram-${id}">${charts.get(id)?.name() ?? t(`studio-chart-${id}`)}</label></p>`), body);
  });
}

// Diagrams as pictures with labelled axes for paper: [class, name, picture].
export function pictures(ids = [...$("charts").children].map((e) => e.dataset.chart)) {
  const seen = ids.filter((id) => charts.get(id)?.root.isConnected).map((id) => charts.get(id));
  const out = seen.map((chart) => [chart.id, chart.title.textContent, chart.copy()]);
  again();
  return out;
}

// Opens a table of the large diagram with one row per degree. A row sets the cursor.
export function table() {
  dialog("studio-table", (body) => {
    body.className = "data";
    const chart = charts.get($("charts").firstElementChild.dataset.chart);
    const { lines, rows } = handles.table(chart);
    const head = [`θ, ${chart.curves.unit}`, ...lines.map((l) => `${t(`studio-line-${l.role}`)}, ${chart.panel.unit}`)];
    const row = ([theta, ...values]) => html`<tr data-theta=${theta}><th scope="row">${String(Number(theta.toFixed(2)))}</th>
      ${values.map((y) => html`<td class="n">${number(y)}</td>`)}</tr>`;
    render(html`<p class="go"><strong>${chart.name()}</strong> <label for="go-to">${t("studio-go-to")}</label>
        <input type="text" id="go-to" size="6" inputmode="decimal" @input=${({ target }) => goTo(body, target.value)}></p>
      <div class="scroll" tabindex="0"><table><thead><tr>${head.map((h) => html`<th scope="col">${h}</th>`)}</tr></thead>
        <tbody>${rows.map(row)}</tbody></table></div>`, body);
  });
}

// Marks the first row at or after this angle.
function goTo(body, typed) {
  const theta = parseFloat(typed.replace(",", "."));
  const found = [...body.querySelectorAll("[data-theta]")].find((e) => Number(e.dataset.theta) >= theta - 1e-9);
  for (const e of body.querySelectorAll(".here")) e.classList.remove("here");
  found?.classList.add("here");
  found?.scrollIntoView({ block: "center" });
  if (found) clock.set(theta);
}
