// Table of pinned designs. Below it: sensitivity, trade-off, simulations and sweeps of the present design.

import { $, html, live, nothing, render as draw, repeat } from "../core/dom.js";
import { t, number, local, onLanguage } from "../core/words.js";
import { engine } from "../core/net.js";
import { onTab, openTab } from "../core/view.js";
import * as blobs from "../core/blobs.js";
import * as designs from "../core/designs.js";
import * as versions from "../core/versions.js";
import { choice, label } from "./names.js";
import * as units from "../core/units.js";
import * as asked from "./asked.js";
import { differing, inputsOf, nameOf } from "./fields.js";
import * as variation from "./variation.js";
import * as runs from "./runs.js";
import * as stage from "./stage.js";
import * as charts from "../charts/charts.js";

const COLOURS = ["#e69f00", "#cc79a7", "#009e73", "#d55e00", "#56b4e9", "#8a7a00"];
let start = { figures: [], trades: [] };
/** @type {(changes: object[]) => void} */
let edit = () => {};
/** @type {(scene: string, more?: object) => void} */
let openScene = () => {};
// Colour of the pinned design that is subtracted from the present one.
let against = null;

const pins = () => versions.history().pins.filter((p) => p.curves);

export function load(page) {
  ({ start, edit, openScene } = page);
  asked.load(show);
  onTab("compare", show);
  onLanguage(show);
}

export function render(version, { moving }) {
  if (!moving) show();
}

function show() {
  const answer = designs.present()?.answer;
  if (!answer || openTab() !== "compare") return;
  const seen = { answer, start, edit, take };
  draw(html`<h2>${t("studio-slate")}</h2><p class="lead">${t("studio-slate-lead")}</p>
    <button type="button" class="main" @click=${pin}>${t("studio-pin")}</button>
    <div id="slate" class="slate">${pins().length > 0 ? slate(answer) : nothing}</div>
    ${variation.sensitivity(start)}
    ${answer.numbers.force_rms_error_n === null ? nothing : variation.front(start, seen)}
    ${runs.sections(seen)}`, $("compare"));
}

// Opens a scene with the files of the present version.
function take(scene) {
  const { files, hand, recording } = versions.now();
  openScene(scene, { files, hand, recording });
}

// --- pinned designs ---------------------------------------------------------------------------------

export function pin() {
  if (!designs.isCurrent()) return;
  const all = versions.history().pins;
  const { files, hand, recording } = versions.now();
  const colour = COLOURS.find((c) => !all.some((p) => p.colour === c)) ?? COLOURS[all.length % COLOURS.length];
  const made = pictured(designs.present().answer);
  versions.pin({ ...made, name: nameOf(made, pins()), files, hand, recording, colour });
  overlay();
}

const pictured = ({ name, scene, curves, numbers, verdict, fields }) =>
  ({ name, scene, curves, numbers, verdict, inputs: inputsOf(fields) });

// Designs the pinned scenes again after a reload.
export async function restore() {
  for (const pin of versions.history().pins) {
    if (pin.curves) continue;
    try {
      await blobs.ensure(pin.files);
      const question = { scene: pin.scene, changes: [], files: blobs.listed(pin.files), colour: "none" };
      const whole = { ...pin, ...pictured(await engine.ask("design", question)), name: pin.name };
      versions.setPins(versions.history().pins.map((p) => (p === pin ? whole : p)));
    } catch { /* Its file is missing: the pinned design stays without a picture. */ }
  }
  overlay();
}

function overlay() {
  const list = pins();
  charts.compare(list, list.find((p) => p.colour === against));
  stage.compare(list);
  show();
}

function change(colour, edited) {
  versions.setPins(versions.history().pins.map((p) => (p.colour === colour ? { ...p, ...edited } : p)));
  overlay();
}

function drop(colour) {
  versions.setPins(versions.history().pins.filter((p) => p.colour !== colour));
  overlay();
}

function compareWith(colour) {
  against = against === colour ? null : colour;
  overlay();
}

// --- table of designs ----------------------------------------------------------------------------------

function slate(answer) {
  const present = { ...answer, inputs: inputsOf(answer.fields), colour: "var(--blue)", name: t("studio-slate-present") };
  const all = [present, ...pins()];
  const swatch = (p) => html`<span class="swatch" style="background:${p.colour}"></span>`;
  const head = (p, i) => html`<th scope="col" title=${p.name}>${swatch(p)}${i === 0 ? p.name : i}<span class="hidden"> ${p.name}</span></th>`;
  const row = (name, cells, kind = "") => html`<tr class=${kind}><th scope="row">${name}</th>${cells}</tr>`;
  const cells = (values) => values.map((v) => html`<td class="n">${v}</td>`);
  return html`<ul class="pins">${repeat(pins(), (p) => p.colour, (p, i) => variant(p, i + 1, swatch))}</ul>
    <div class="scroll" tabindex="0"><table><thead><tr><td></td>${all.map(head)}</tr></thead><tbody>
    ${differing(all).map(([key, values]) => row(label(key), cells(values.map(shownValue)), "input"))}
    ${row(t("studio-verdict"), all.map((p) => html`<td class="n ${p.verdict}">${t(`studio-verdict-${p.verdict}`).replace(/\.$/, "")}</td>`), "judged")}
    ${start.figures.filter(([name]) => all.some((p) => p.numbers[name] !== null)).map(([name, [of, plain]]) => {
      const [unit, factor] = units.unit(of);
      const shown = (x) => number(x === null || x === undefined ? null : plain * factor * x);
      return row(html`${t(`figure-${name}`)}<small> ${unit}</small>`, cells(all.map((p) => shown(p.numbers[name]))));
    })}</tbody></table></div>`;
}

const shownValue = (v) => units.text(local(choice(v)));

// Row of a pinned design: name, and buttons to return to it, to show the difference and to remove it.
function variant(p, i, swatch) {
  const act = (key, text, action, pressed) => html`<button type="button" class="tiny" aria-label="${t(key)} ${i}" title=${t(key)}
    aria-pressed=${pressed ?? nothing} @click=${action}>${text}</button>`;
  const back = () => openScene(p.scene, { files: p.files, hand: p.hand, recording: p.recording });
  return html`<li>${swatch(p)}<b>${i}</b>
    <input type="text" class="variant" .value=${live(p.name)} aria-label="${t("studio-slate-name")} ${i}"
      @change=${({ target }) => change(p.colour, { name: target.value })}>
    <span class="acts">${act("studio-slate-take", "↩", back)}
      ${act("studio-slate-difference", "Δ", () => compareWith(p.colour), String(against === p.colour))}
      ${act("studio-slate-drop", "×", () => drop(p.colour))}</span></li>`;
}
