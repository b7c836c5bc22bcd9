// Exercise sheet for a class: given values, and quantities to be found. A button shows the answers; on paper they are on a separate page.

import { html, notice } from "../core/dom.js";
import { t, local } from "../core/words.js";
import { sheet } from "../core/view.js";
import * as units from "../core/units.js";
import * as designs from "../core/designs.js";
import * as charts from "../charts/charts.js";
import { choice, label } from "../panels/names.js";
import * as stage from "../panels/stage.js";
import { engine } from "../core/net.js";
import { nameOf } from "./laws.js";

const DIAGRAMS = ["force", "s", "v", "a", "j"];

export function open() {
  if (!designs.isCurrent()) {
    notice(t("studio-not-designed"));
    return;
  }
  const { answer } = designs.present();
  let laws = { laws: [], dwell: {} };
  let shown = false;
  const diagrams = () => charts.pictures(DIAGRAMS).map(([id, name, picture]) =>
    html`<figure class="copy ${id}"><figcaption>${name}</figcaption>${picture}</figure>`);
  const [blank, filled] = [diagrams(), diagrams()];
  const cam = stage.picture();
  const figures = (value) => html`<dl class="find-these">${answer.figures.map((f) => html`<div><dt>${f.name}</dt><dd>${value(f)}</dd></div>`)}</dl>`;
  const value = (f) => units.text([f.value, f.more].filter(Boolean).join(", "));
  const toggle = () => {
    shown = !shown;
    refresh();
  };
  engine.ask("laws", {}).then((known) => {
    laws = known;
    refresh();
  });
  const refresh = sheet("studio-exercise", "sheet", () => html`<p class="buttons">
      <button type="button" class="main" id="show-answers" aria-pressed=${String(shown)} @click=${toggle}>${t("studio-exercise-show")}</button>
      <button type="button" @click=${() => window.print()}>${t("studio-exercise-print")}</button></p>
    <section><h3>${answer.name}: ${t("studio-exercise-given")}</h3>${given(answer.fields, laws)}
      <h3>${t("studio-exercise-find")}</h3>${figures(() => "")}<div class="copies blank">${blank}</div></section>
    <section class="answers" ?hidden=${!shown}><h3>${answer.name}: ${t("studio-exercise-answers")}</h3>
      <p>${t(`studio-verdict-${answer.infeasible ? "infeasible" : answer.verdict}`)} ${units.text(answer.reasons)}</p>
      ${figures(value)}<div class="copies"><figure class="copy">${cam}</figure>${filled}</div></section>`);
}

// Value of a key in the words of the reader.
function worded(key, text, laws) {
  return key === "motion" ? nameOf(laws, text) : local(choice(text)).replace(/ ?deg$/, "°");
}

// Values of the scene as a list, with its segments and points as tables.
function given(fields, laws) {
  const set = Object.entries(fields).filter(([key, { text }]) => text !== "" && key !== "name");
  const plain = set.filter(([key]) => !/\.\d+\./.test(key));
  const lists = [...new Set(set.flatMap(([key]) => /^(.*)\.\d+\./.exec(key)?.[1] ?? []))];
  return html`<dl class="given">${plain.map(([key, { text }]) => html`<div><dt>${label(key)}</dt><dd>${worded(key, text, laws)}</dd></div>`)}</dl>
    ${lists.map((list) => table(list, set, laws))}`;
}

function table(list, set, laws) {
  const mine = set.filter(([key]) => key.startsWith(`${list}.`)).map(([key, { text }]) => [...key.slice(list.length + 1).split("."), text]);
  const columns = [...new Set(mine.map(([, column]) => column))];
  const numbers = [...new Set(mine.map(([number]) => number))];
  const cell = (number, column) => worded(column, mine.find(([n, c]) => n === number && c === column)?.[2] ?? "", laws);
  return html`<table><caption>${t(`studio-list-${list.replace(".", "-")}`)}</caption>
    <thead><tr><th scope="col">#</th>${columns.map((c) => html`<th scope="col">${t(`studio-column-${c}`)}</th>`)}</tr></thead>
    <tbody>${numbers.map((n) => html`<tr><th scope="row">${n}</th>${columns.map((c) => html`<td>${cell(n, c)}</td>`)}</tr>`)}</tbody></table>`;
}
