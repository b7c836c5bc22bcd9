// Printed page: name, date and link of the scene, its values, verdict, figures, cam, diagrams, checks and notes.

import { $, html, nothing, render as draw, svgTemplate } from "../core/dom.js";
import { t, language, local, number } from "../core/words.js";
import { qrCode } from "../core/vendor.js";
import * as charts from "../charts/charts.js";
import * as designs from "../core/designs.js";
import * as units from "../core/units.js";
import { given } from "./fields.js";
import { choice, label } from "./names.js";
import * as stage from "./stage.js";
import { offered } from "./verdict.js";

// Maximum length of an address in a code that can be read from paper, characters.
const LONGEST_CODE = 900;
const LONGEST_ADDRESS = 160;

export function load() {
  addEventListener("beforeprint", fill);
  matchMedia("print").addEventListener("change", ({ matches }) => { if (matches) fill(); });
}

function fill() {
  const answer = designs.present()?.answer;
  if (!answer) return;
  draw(html`<header><div><h1>${answer.name}</h1><p>gaitcam studio · ${date()}</p>${judged(answer)}
      <dl class="figures">${answer.figures.map(figure)}</dl></div>${link()}</header>
    <div class="sheets"><figure class="cam-copy">${stage.picture()}<ul class="parts">${stage.legend()}</ul></figure>${charts.pictures().map(diagram)}</div>
    <section><h2>${t("studio-tab-values")}</h2>${values(answer.fields)}</section>
    <section><h2>${t("studio-checks")}</h2><ul class="columns">${answer.checks.map(check)}</ul></section>
    ${answer.notes.length > 0 ? html`<section><h2>${t("studio-notes", { count: answer.notes.length })}</h2>
      <ul>${answer.notes.map((n) => html`<li>${units.text(n)}</li>`)}</ul></section>` : nothing}`, $("paper"));
}

const date = () => new Date().toLocaleDateString(language(), { year: "numeric", month: "long", day: "numeric" });

const diagram = ([id, name, picture]) => html`<figure class="copy ${id}"><figcaption>${name}</figcaption>${picture}</figure>`;

const figure = ({ name, value, more }) =>
  html`<div><dt>${name}</dt><dd>${units.text(value)} ${more ? html`<small>${units.text(more)}</small>` : nothing}</dd></div>`;

// Verdict with its reasons and the suggested changes.
function judged(answer) {
  const changes = offered(answer);
  return html`<p class="verdict-line"><b>${t(`studio-verdict-${answer.infeasible ? "infeasible" : answer.verdict}`)}</b> ${units.text(answer.reasons)}
    ${changes.length > 0 ? html`${t("studio-relax")} ${changes.join("; ")}.` : nothing}</p>`;
}

// Address of the scene: as text if it is short, otherwise as a code.
function link() {
  const { hash, href, protocol, hostname } = location;
  const isOwn = protocol === "file:" || /^(localhost|127\.|\[::1\])/.test(hostname);
  const address = isOwn ? hash : href;
  if (!hash || address.length > LONGEST_CODE) return nothing;
  const { data, size } = qrCode(address, { ecc: "L", border: 2 });
  const path = data.flatMap((row, y) => row.map((on, x) => (on ? `M${x} ${y}h1v1h-1z` : ""))).join("");
  return html`<figure class="code"><svg viewBox="0 0 ${size} ${size}" shape-rendering="crispEdges">${svgTemplate`<path d=${path}/>`}</svg>
    <figcaption>${address.length <= LONGEST_ADDRESS ? address : t(isOwn ? "studio-paper-part" : "studio-paper-link")}</figcaption></figure>`;
}

function values(fields) {
  const { single, entries } = given(fields);
  const column = (name) => t(`studio-column-${name}`);
  return html`<dl class="columns">${single.map(([key, text]) => html`<div><dt>${label(key)}</dt><dd>${local(choice(text))}</dd></div>`)}</dl>
    ${entries.length > 0 ? html`<ol class="columns">${entries.map(([, list]) =>
      html`<li>${list.map(([name, text]) => `${column(name)} ${local(choice(text))}`).join(", ")}</li>`)}</ol>` : nothing}`;
}

function check({ name, state, value, limit, unit, place }) {
  const [to, factor] = units.unit(unit);
  const shown = (x) => number(Math.abs(x) < 1e-9 ? 0 : factor * x);
  const limits = limit === null ? "" : ` / ${shown(limit)}`;
  return html`<li>${name}: ${shown(value)}${limits} ${to}${place ? `, ${place}` : ""} (${t(`studio-check-${state}`)})</li>`;
}
