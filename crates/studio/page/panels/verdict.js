// Verdict with its reasons, suggested changes, figures, and checks.

import { $, hide, html, live, nothing, render as draw } from "../core/dom.js";
import { t, local, number } from "../core/words.js";
import { engine } from "../core/net.js";
import * as units from "../core/units.js";
import * as blobs from "../core/blobs.js";
import * as designs from "../core/designs.js";
import * as versions from "../core/versions.js";
import { criterion, label } from "./names.js";

const STATES = ["violated", "at-limit", "satisfied"];
/** @type {(changes: object[]) => void} */
let apply = () => {};
/** @type {(fault: object) => [string, () => void][]} */
let remedies = () => [];
let redraw = () => {};
// Whether reasons and changes are visible. On a small screen they are folded below the verdict.
let isOpen = false;
// Effect of the suggested changes on the whole design, by response.
const tried = new WeakMap();
let asking = 0;
let relaxing = null;

/**
 * @param {(changes: object[]) => void} onApply Changes values of the scene.
 * @param {(fault: object) => [string, () => void][]} more Buttons for messages about a recording.
 * @param {() => void} again Draws the page again.
 */
export function load(onApply, more, again) {
  [apply, remedies, redraw] = [onApply, more, again];
}

export function render(version, { answer }) {
  const pending = pendingOf(version, answer);
  standing(pending, answer);
  if (!answer) hide($("conflict"));
  if (!answer) return;
  draw(answer.figures.map(figure), $("figures"));
  changes(answer, pending);
  draw(checks(answer), $("limits"));
  if (answer.needs_relaxing && !answer.quick && !pending && !tried.has(answer)) relax(answer);
}

// Reason why the verdict does not belong to the displayed version; "" if it does.
function pendingOf(version, answer) {
  if (designs.isForeign() && version?.fault) return "studio-force-foreign";
  if (versions.refused(version)) return "studio-pending";
  return answer?.quick ? "studio-quick" : "";
}

function standing(pending, answer) {
  const box = $("verdict");
  const kind = pending || !answer ? "" : answer.infeasible ? "unacceptable" : answer.verdict;
  const name = kind ? t(`studio-verdict-${answer.infeasible ? "infeasible" : kind}`) : "–";
  const reasons = kind ? units.text(tried.get(answer)?.reasons ?? answer.reasons) : pending ? t(pending) : "";
  if (box.className !== `verdict ${kind}`) box.className = `verdict ${kind}`;
  box.dataset.verdict = designs.isCurrent() ? answer.verdict : "pending";
  $("standing").toggleAttribute("data-open", isOpen);
  draw(html`
    <button type="button" id="chip" class="chip" aria-expanded=${isOpen} aria-controls="standing" @click=${unfold}>
      <span class="light" aria-hidden="true"></span><strong id="verdict-name">${name}</strong></button>
    <p id="verdict-reasons">${reasons}</p>`, box);
}

function unfold() {
  isOpen = !isOpen;
  redraw();
  if (isOpen) $("standing").scrollIntoView({ block: "nearest" });
}

function figure({ name, value, more }) {
  const shown = units.text(value);
  const small = units.text(more);
  // Normally the speed is given in two units. If both are the same unit, it is shown once.
  const isTwice = shown.endsWith("rpm") && small.endsWith("rpm");
  return html`<div><dt>${name}</dt><dd><span>${shown}</span>${small && !isTwice ? html`<small>${small}</small>` : nothing}</dd></div>`;
}

// Requests a check of every suggested change with the full design, which takes longer than the design itself.
function relax(answer) {
  clearTimeout(asking);
  asking = setTimeout(async () => {
    relaxing?.abort();
    relaxing = new AbortController();
    const question = { scene: answer.scene, files: blobs.listed(designs.present().files) };
    try {
      tried.set(answer, await engine.ask("relax", question, { signal: relaxing.signal }));
      redraw();
    } catch { /* The changes from the conflict alone stay. */ }
  }, 120);
}

// Stops this check, which is useless for a new design.
export function stop() {
  clearTimeout(asking);
  relaxing?.abort();
}

// A changed goal differs from a changed limit: the result becomes worse.
const isGoal = ({ kind, key }) => kind === "goal" || (!kind && key.startsWith("accuracy."));

function changes(answer, pending) {
  const { relaxations, together = [] } = tried.get(answer) ?? answer;
  const useful = relaxations.filter((r) => r.value);
  const all = together.filter((r) => r.value);
  const asked = remedies({ remedies: answer.asks });
  const isShown = answer.needs_relaxing && !answer.quick && !pending && useful.length + all.length + asked.length > 0;
  hide($("conflict"), !isShown);
  if (!isShown) return;
  const limits = useful.filter((r) => !isGoal(r));
  const buttons = [
    ...asked.map(([text, action]) => html`<button type="button" class="choice" @click=${action}>${text}</button>`),
    ...limits.map((r) => change([r])),
    ...(all.length > 0 ? [change(all)] : []),
    ...useful.filter(isGoal).map(goal),
  ];
  draw(html`${useful.length + all.length > 0 ? html`<p>${t("studio-relax")}</p>` : nothing}<div class="buttons">${buttons}</div>`, $("conflict"));
}

// Suggested changes as text, for paper.
export function offered(answer) {
  const { relaxations, together = [] } = tried.get(answer) ?? answer;
  const one = ({ key, from, to }) => units.text(local(`${label(key)}: ${from} → ${to}`));
  const useful = relaxations.filter((r) => r.value).map(one);
  const all = together.filter((r) => r.value).map(one);
  return all.length > 0 ? [...useful, all.join(" + ")] : useful;
}

const settings = (list) => list.map(({ key, value }) => ({ set: { key, value } }));

// Button for one change, or for several changes together.
function change(list) {
  const one = ({ key, from, to, cost }, i) => html`${i > 0 ? " + " : ""}${label(key)}: ${units.text(local(from))} →
    <b>${units.text(local(to))}</b>${cost ? html` <small>${cost}</small>` : nothing}`;
  const [{ key, value }] = list;
  return html`<button type="button" class="relax" data-relax=${list.length > 1 ? "together" : key} data-value=${value}
    @click=${() => apply(settings(list))}>${list.map(one)}</button>`;
}

function goal(r) {
  return html`<button type="button" class="relax goal" data-relax=${r.key} data-value=${r.value} @click=${() => apply(settings([r]))}>${t(
    "studio-relax-goal", { to: local(r.to), from: local(r.from) })}</button>`;
}

function checks(answer) {
  const eased = new Map(answer.easing.map((e) => [e.name, e]));
  const list = answer.checks.toSorted((a, b) => STATES.indexOf(a.state) - STATES.indexOf(b.state));
  return html`<h2>${t("studio-checks")}</h2>
    ${list.length > 0 ? html`<ul class="checks">${list.map((c) => check(c, eased.get(c.name)))}</ul>` : html`<p>${t("studio-checks-none")}</p>`}
    ${camDas(answer)}
    ${answer.notes.length > 0 ? html`<details class="notes" ?open=${live(notesOpen)} @toggle=${fold}>
      <summary>${t("studio-notes", { count: answer.notes.length })}</summary>
      <ul>${answer.notes.map((n) => html`<li>${units.text(n)}</li>`)}</ul></details>` : nothing}`;
}

let notesOpen = false;

function fold({ currentTarget }) {
  notesOpen = currentTarget.open;
}

// Name, value, limit and position. Below them is the gain from relaxing the limit by 1 %.
function check({ key, state, value, limit, unit, place }, eased) {
  const [to, factor] = units.unit(unit);
  const shown = (x) => number(Math.abs(x) < 1e-9 ? 0 : factor * x);
  const close = to === "°" || to === "" ? to : `\u00a0${to}`;
  return html`<li class=${state}><span class="dot" role="img" aria-label=${t(`studio-check-${state}`)} title=${t(`studio-check-${state}`)}></span>
    <span>${criterion(key)}</span>
    <span class="n">${limit === null ? `${shown(value)}${close}` : `${shown(value)} / ${shown(limit)}${close}`}</span>
    <span class="quiet">${place}</span>
    ${eased ? html`<small>${t("studio-check-eased", { objective: eased.objective, before: units.text(eased.before), after: units.text(eased.after) })}</small>` : nothing}</li>`;
}

// Class of the law according to CAM-DAS, which checks fewer quantities than the verdict.
function camDas({ cam_das: found, fields }) {
  if (!found || !Object.keys(fields).some((key) => key.startsWith("law.segment."))) return nothing;
  return html`<p id="cam-das" class="quiet">CAM-DAS: ${t(`studio-verdict-${found}`)} ${t("studio-cam-das")}</p>`;
}
