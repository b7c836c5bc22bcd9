// A sheet for a class: what is given and what is to be found; the answers are shown by a button, on paper they have a page
// of their own.

import { make, notice } from "../core/dom.js";
import { t, local } from "../core/words.js";
import { dialog } from "../core/view.js";
import * as units from "../core/units.js";
import * as designs from "../core/designs.js";
import * as charts from "../charts/charts.js";
import { label } from "../panels/form.js";
import * as stage from "../panels/stage.js";

const DIAGRAMS = ["force", "s", "v", "a", "j"];

export function open() {
  if (!designs.isCurrent()) {
    notice(t("studio-not-designed"));
    return;
  }
  const { answer } = designs.present();
  dialog("studio-exercise", (body) => {
    body.className = "sheet";
    const diagrams = () => charts.pictures(DIAGRAMS).map(([id, name, picture]) => make("figure", { class: `copy ${id}` }, make("figcaption", {}, name), picture));
    const figures = (value) => make("dl", { class: "find-these" }, ...answer.figures.map((f) => make("div", {}, make("dt", {}, f.name), make("dd", {}, value(f)))));
    const answers = make("section", { class: "answers", hidden: true }, make("h3", {}, `${answer.name}: ${t("studio-exercise-answers")}`),
      make("p", {}, t(`studio-verdict-${answer.infeasible ? "infeasible" : answer.verdict}`), " ", units.text(answer.reasons)),
      figures((f) => units.text([f.value, f.more].filter(Boolean).join(", "))), make("div", { class: "copies" }, make("figure", { class: "copy" }, stage.picture()), ...diagrams()));
    const show = make("button", { type: "button", class: "main", id: "show-answers", "aria-pressed": "false", onclick: () => {
      answers.hidden = !answers.hidden;
      show.setAttribute("aria-pressed", String(!answers.hidden));
    } }, t("studio-exercise-show"));
    body.append(make("p", { class: "buttons" }, show, make("button", { type: "button", onclick: () => window.print() }, t("studio-exercise-print"))),
      make("section", {}, make("h3", {}, `${answer.name}: ${t("studio-exercise-given")}`), ...given(answer.fields), make("h3", {}, t("studio-exercise-find")), figures(() => ""),
        make("div", { class: "copies blank" }, ...diagrams())), answers);
  });
}

// The values of the scene as a list, its segments and points as tables.
function given(fields) {
  const set = Object.entries(fields).filter(([key, { text }]) => text !== "" && key !== "name");
  const plain = set.filter(([key]) => !/\.\d+\./.test(key));
  const out = [make("dl", { class: "given" }, ...plain.map(([key, { text }]) => make("div", {}, make("dt", {}, label(key)), make("dd", {}, local(text)))))];
  for (const list of new Set(set.flatMap(([key]) => /^(.*)\.\d+\./.exec(key)?.[1] ?? []))) {
    const mine = set.filter(([key]) => key.startsWith(`${list}.`)).map(([key, { text }]) => [...key.slice(list.length + 1).split("."), text]);
    const columns = [...new Set(mine.map(([, column]) => column))];
    const rows = Map.groupBy(mine, ([number]) => number);
    out.push(make("table", {}, make("caption", {}, t(`studio-list-${list.replace(".", "-")}`)),
      make("thead", {}, make("tr", {}, make("th", { scope: "col" }, "#"), ...columns.map((c) => make("th", { scope: "col" }, t(`studio-column-${c}`))))),
      make("tbody", {}, ...[...rows].map(([number, cells]) => make("tr", {}, make("th", { scope: "row" }, number),
        ...columns.map((c) => make("td", {}, local(cells.find(([, column]) => column === c)?.[2] ?? ""))))))));
  }
  return out;
}
