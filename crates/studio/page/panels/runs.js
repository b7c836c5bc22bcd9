// Simulation of the finished cam, identification from a log, and a map of designs over one or two values.

import { html, nothing, notice } from "../core/dom.js";
import { t, number, local } from "../core/words.js";
import { engine } from "../core/net.js";
import { enlarging } from "../core/view.js";
import * as designs from "../core/designs.js";
import * as units from "../core/units.js";
import { shade, isDark } from "../charts/shade.js";
import { nearest, valuesAbout } from "./fields.js";
import { ask, button, found, isRunning, isStale, place } from "./asked.js";
import { label } from "./names.js";

// Number of values for a single key, and for each of two keys.
const [ALONE, BOTH] = [13, 7];
let across = null;
let down = "";
let column = null;
const pictures = new WeakMap();

// Picture of a response, made once.
function picture(answer, title) {
  if (!pictures.has(answer)) pictures.set(answer, enlarging(answer.picture, title));
  return pictures.get(answer);
}

/**
 * Sections of the panel about the displayed design. `take` opens a scene with its files.
 * @param {{answer: any, start: any, edit: (changes: object[]) => void, take: (scene: string) => void}} seen
 */
export function sections(seen) {
  runAtOnce(seen.answer);
  return html`<h2>${t("studio-simulate")}</h2><p class="lead">${t("studio-simulate-lead")}</p>
    <div class="buttons">${button("simulate", t("studio-simulate-do"), run)}</div>${place("motion", motion(found("motion")))}
    ${walking(seen)}<h2>${t("studio-log")}</h2><p class="lead">${t("studio-log-lead")}</p>
    <label class="pick" for="log">${t("studio-log-pick")}</label><input type="file" id="log" accept=".csv,.txt" @change=${identify}>
    ${place("logged", machine(found("logged"), seen.take))}
    <h2>${t("studio-sweep")}</h2><p class="lead">${t("studio-sweep-lead")}</p>${choices(seen)}${place("grid", map(found("grid"), seen))}`;
}

// --- motion ---------------------------------------------------------------------------------------------

const run = () => ask("simulate", "motion");

// A scene with a machine is simulated without a button, because a simulation takes less time than a design.
function runAtOnce({ fields }) {
  const hasMachine = Object.entries(fields).some(([key, { text }]) => key.startsWith("machine.") && text !== "");
  if (!hasMachine || !designs.isCurrent() || isRunning("motion") || (found("motion") && !isStale("motion"))) return;
  queueMicrotask(run);
}

function motion(ran) {
  if (!ran) return nothing;
  if (ran.why) return html`<p>${ran.why}</p>`;
  return html`<table class="ran"><tbody>${ran.rows.map(([name, value]) => html`<tr><th scope="row">${name}</th><td>${units.text(value)}</td></tr>`)}
    </tbody></table>${picture(ran, "studio-simulate")}`;
}

// --- resonance ------------------------------------------------------------------------------------------

// The recorded walk beside the cam, for scenes with a recording.
function walking({ answer: { fields } }) {
  if (!fields["gait.file"]?.text) return nothing;
  return html`<h2>${t("studio-resonance")}</h2><p class="lead">${t("studio-resonance-lead")}</p>
    <div class="buttons">${button("resonance", t("studio-resonance-do"), () => ask("resonance", "walking"))}</div>${place("walking", severity(found("walking")))}`;
}

function severity(answer) {
  if (!answer) return nothing;
  if (!answer.sentence) return html`<p>${t("studio-resonance-none")}</p>`;
  const { sentence, columns, rows } = answer;
  return html`<p>${sentence}</p><table class="ran"><thead><tr>${columns.map((name) => html`<th scope="col">${name}</th>`)}</tr></thead>
    <tbody>${rows.map(([damping, ...cells]) => html`<tr><th scope="row">${damping}</th>${cells.map((cell) => html`<td class="n">${cell}</td>`)}</tr>`)}</tbody></table>
    ${picture(answer, "studio-resonance")}`;
}

// --- log of a machine -----------------------------------------------------------------------------------

async function identify({ target }) {
  const file = target.files[0];
  if (!file) return;
  try {
    await ask("identify", "logged", { log: file.name, hash: await engine.keep(file) });
  } catch (error) {
    notice(error.message);
  }
}

// Results of the identification, and the button that opens the scene of the next cam.
function machine(logged, take) {
  if (!logged) return nothing;
  if (logged.why) return html`<p>${logged.why}</p>`;
  const { lines, next } = logged;
  return html`<ul>${lines.map((line) => html`<li>${line.replace(/ +/g, " ")}</li>`)}</ul>${picture(logged, "studio-log")}
    ${next.why ? html`<p>${next.why}</p>` : html`<p>${t("studio-log-next", { before: next.before, after: next.after })}</p>
      <div class="buttons"><button type="button" id="take-next" @click=${() => take(next.scene)}>${t("studio-log-take")}</button></div>`}`;
}

// --- map of designs ---------------------------------------------------------------------------------------

function choices({ answer: { fields }, start: { figures } }) {
  const keys = Object.keys(fields).filter((key) => fields[key].slider && fields[key].text);
  if (!keys.includes(across)) across = keys.find((key) => key === "limits.stroke") ?? keys[0];
  if (!keys.includes(down)) down = "";
  column ??= figures[0][0];
  const option = (value, text, chosen) => html`<option value=${value} ?selected=${value === chosen}>${text}</option>`;
  const of = (chosen) => keys.map((key) => option(key, label(key), chosen));
  const select = (id, content, set) => html`<select id=${id} aria-label=${t(`studio-${id}`)} @change=${(e) => set(e.target.value)}>${content}</select>`;
  return html`<div class="buttons">${select("sweep-across", of(across), (v) => { across = v; })}
    ${select("sweep-down", [option("", "–", down), ...of(down)], (v) => { down = v; })}
    ${select("sweep-figure", figures.map(([name]) => option(name, t(`figure-${name}`), column)), (v) => { column = v; })}
    ${button("sweep", t("studio-sweep-do"), () => sweep(fields, figures))}</div>`;
}

function sweep(fields, figures) {
  const size = down && down !== across ? BOTH : ALONE;
  const axes = [across, size === BOTH ? down : ""].filter(Boolean).map((key) => ({ key, values: valuesAbout(fields[key].slider, size) }));
  const vary = axes.map(({ key, values: list }) => `${key}=${list[0]}:${list.at(-1)}:${size}`);
  ask("sweep", "grid", { vary, column }, { axes, figure: figures.find(([name]) => name === column) });
}

// Map coloured by a figure, with the first key over the rows and the second over the columns. A click sets the values.
function map(grid, { answer: { fields }, edit }) {
  if (!grid) return nothing;
  if (!grid.values) return html`<p>${t("studio-sweep-none")}</p>`;
  const { axes: [rows, columns], figure: [name, [of, plain]] } = grid;
  const [unit, factor] = units.unit(of);
  const width = columns?.values.length ?? 1;
  const known = grid.values.filter((x) => x !== null);
  const [low, high] = [Math.min(...known), Math.max(...known)];
  const hereOf = (axis) => (axis && fields[axis.key]?.slider ? nearest(axis.values, fields[axis.key].slider.at) : -1);
  const here = [hereOf(rows), hereOf(columns)];
  const shown = (x) => number(x * plain * factor, 3);
  const cell = (i, j) => {
    const at = i * width + j;
    const [x, verdict, why] = [grid.values[at], grid.verdicts[at], grid.why[at]];
    const part = x === null ? null : high > low ? (x - low) / (high - low) : 0;
    const valueOf = (axis, k) => ({ set: { key: axis.key, value: axis.values[k === 0 ? i : j] } });
    const take = () => edit([rows, columns].filter(Boolean).map(valueOf));
    const said = [verdict ? t(`studio-verdict-${verdict}`) : "", why].filter(Boolean).join(" ");
    const isHere = i === here[0] && (!columns || j === here[1]);
    return html`<td class="n ${verdict ?? ""} ${isHere ? "here" : ""} ${part !== null && isDark(part) ? "dark" : ""}"
      style=${part === null ? "" : `background-color:${shade(part)}`}><button type="button" class="plain" title=${said}
      aria-label="${x === null ? "–" : shown(x)}. ${said}${isHere ? ` ${t("studio-sweep-here")}` : ""}" @click=${take}>${x === null ? "–" : shown(x)}</button></td>`;
  };
  const values = (axis) => axis.values.map((v) => units.text(local(v)));
  const bare = (text) => text.replace(/\s.*/, "");
  const head = columns ? html`<thead><tr><td></td>${values(columns).map((v) => html`<th scope="col" title=${v}>${bare(v)}</th>`)}</tr></thead>` : nothing;
  const unitOf = (axis) => values(axis)[0].replace(/^\S+\s?/, "");
  const title = (axis) => [label(axis.key), unitOf(axis)].filter(Boolean).join(", ");
  return html`<p><b>${t(`figure-${name}`)}, ${unit}</b></p>
    <p class="quiet">↓ ${title(rows)}${columns ? html` &nbsp; → ${title(columns)}` : nothing}</p>
    <table class="grid ${columns ? "" : "alone"}">${head}<tbody>${values(rows).map((v, i) => html`<tr><th scope="row" title=${v}>${bare(v)}</th>
      ${Array.from({ length: width }, (_, j) => cell(i, j))}</tr>`)}</tbody></table>
    <p class="legend">${shown(low)}<span class="ramp" style="background:linear-gradient(to right,${[0, 0.25, 0.5, 0.75, 1].map(shade).join(",")})"></span>${shown(high)} ${unit}</p>
    <p class="key"><span class="here"></span> ${t("studio-sweep-here")} <span class="crossed"></span> ${t("studio-sweep-crossed")}</p>`;
}
