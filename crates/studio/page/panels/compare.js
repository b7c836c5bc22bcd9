// The slate of pinned designs; below it sensitivity, trade-off, runs and sweeps of the present design.

import { $, html, live, nothing, render as draw, repeat } from "../core/dom.js";
import { t, number, local, onLanguage } from "../core/words.js";
import { engine } from "../core/net.js";
import { onTab, openTab } from "../core/view.js";
import * as blobs from "../core/blobs.js";
import * as designs from "../core/designs.js";
import * as versions from "../core/versions.js";
import { label } from "./form.js";
import * as units from "../core/units.js";
import * as asked from "./asked.js";
import * as variation from "./variation.js";
import * as runs from "./runs.js";
import * as stage from "./stage.js";
import * as charts from "../charts/charts.js";

const COLOURS = ["#e69f00", "#cc79a7", "#009e73", "#d55e00", "#56b4e9", "#8a7a00"];
let start = { figures: [], trades: [] };
let edit = () => {};
let openScene = () => {};
// Colour of the pinned design whose difference to the present one is shown.
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
    ${start.trades.length > 0 && "force_rms_error_n" in answer.numbers && answer.numbers.force_rms_error_n !== null ? variation.front(start, seen) : nothing}
    ${runs.sections(seen)}`, $("compare"));
}

// A scene with the files of the present version.
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

const pictured = ({ name, scene, curves, numbers, verdict, fields }) => ({ name, scene, curves, numbers, verdict, inputs: inputsOf(fields) });

// The values that a scene has, by their keys.
const inputsOf = (fields) => Object.fromEntries(Object.entries(fields).filter(([, f]) => f.text !== "").map(([key, f]) => [key, f.text]));

/**
 * The scene's name, and the values that differ from those of the designs pinned before.
 * @param {{name: string, inputs: Record<string, string>}} made
 * @param {{name: string, inputs?: Record<string, string>}[]} others
 */
export function nameOf(made, others) {
  const last = others.at(-1);
  const changed = last ? differing([last, made]).slice(0, 2).map(([key, [, value]]) => `${label(key)} ${local(value || "–")}`) : [];
  const name = [made.name, ...changed].join(", ");
  const taken = others.filter((p) => p.name === name || p.name.startsWith(`${name} (`)).length;
  return taken > 0 ? `${name} (${taken + 1})` : name;
}

// The values of the scenes that are not the same in all of them.
function differing(all) {
  const keys = new Set(all.flatMap((p) => Object.keys(p.inputs ?? {})));
  const rows = [...keys].map((key) => [key, all.map((p) => p.inputs?.[key] ?? "")]);
  return rows.filter(([key, values]) => key !== "name" && new Set(values).size > 1);
}

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

// --- the slate -----------------------------------------------------------------------------------------

function slate(answer) {
  const present = { ...answer, inputs: inputsOf(answer.fields), colour: "var(--blue)", name: t("studio-slate-present") };
  const all = [present, ...pins()];
  const swatch = (p) => html`<span class="swatch" style="background:${p.colour}"></span>`;
  const head = (p, i) => html`<th scope="col" title=${p.name}>${swatch(p)}${i === 0 ? p.name : i}<span class="hidden"> ${p.name}</span></th>`;
  const row = (name, cells, kind = "") => html`<tr class=${kind}><th scope="row">${name}</th>${cells}</tr>`;
  const cells = (values) => values.map((v) => html`<td class="n">${v}</td>`);
  return html`<ul class="pins">${repeat(pins(), (p) => p.colour, (p, i) => variant(p, i + 1, swatch))}</ul>
    <div class="scroll" tabindex="0"><table><thead><tr><td></td>${all.map(head)}</tr></thead><tbody>
    ${differing(all).map(([key, values]) => row(label(key), cells(values.map((v) => units.text(local(v)))), "input"))}
    ${row(t("studio-verdict"), all.map((p) => html`<td class="n ${p.verdict}">${t(`studio-verdict-${p.verdict}`)}</td>`))}
    ${start.figures.filter(([name]) => all.some((p) => p.numbers[name] !== null)).map(([name, [of, plain]]) => {
      const [unit, factor] = units.unit(of);
      const shown = (x) => number(x === null || x === undefined ? null : plain * factor * x);
      return row(html`${t(`figure-${name}`)}<small> ${unit}</small>`, cells(all.map((p) => shown(p.numbers[name]))));
    })}</tbody></table></div>`;
}

// Name, return, difference and removal of a pinned design.
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
