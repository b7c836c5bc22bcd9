// Verdict with reasons, conflict with its relaxations, figures, active limits, tables.

import { $, make, say, hide, clear } from "../core/dom.js";
import { t, language, local } from "../core/words.js";
import { engine } from "../core/net.js";
import * as units from "../core/units.js";
import * as view from "../core/view.js";
import * as blobs from "../core/blobs.js";
import * as designs from "../core/designs.js";
import { label } from "./form.js";

let apply = () => {};
let remedies = () => [];
let shown = null;

// `more` gives buttons for what is said about a recording: [text, action].
export function load(onApply, more) {
  apply = onApply;
  remedies = more;
}

export function render(version, { answer }) {
  if (!answer || answer === shown) return;
  shown = answer;
  const state = answer.infeasible ? "infeasible" : answer.verdict;
  view.verdict(answer.infeasible ? "unacceptable" : answer.verdict, t(`studio-verdict-${state}`));
  say($("verdict-reasons"), units.text(answer.reasons));
  hide($("cam-das"), !answer.cam_das || !Object.keys(answer.fields).some((key) => key.startsWith("law.segment.")));
  if (answer.cam_das) say($("cam-das"), `CAM-DAS: ${t(`studio-verdict-${answer.cam_das}`)}`);
  figures(answer);
  conflict(answer, answer.relaxations, []);
  renewed($("limits"), [answer.easing, answer.active, answer.notes], () => limits(answer));
  tables(answer);
  if (answer.needs_relaxing && !answer.quick) relax(answer);
}

// Fills a box anew where what it shows has changed.
const filled = new Map();
function renewed(box, content, fill) {
  const seen = JSON.stringify([language(), units.names(), content]);
  if (filled.get(box.id) === seen) return;
  filled.set(box.id, seen);
  fill();
}

function figures({ figures: list }) {
  const form = list.map(({ name, more }) => [name, Boolean(more)]);
  renewed($("figures"), form, () => clear($("figures")).append(...list.map(({ name, more }) =>
    make("div", {}, make("dt", {}, name), make("dd", {}, make("span", {}), more ? make("small", {}) : null)))));
  list.forEach(({ value, more }, i) => {
    const [text, small] = $("figures").children[i].lastChild.children;
    say(text, units.text(value));
    // A speed is given in both units; in one it is said once.
    const isTwice = [value, units.text(more)].every((shown) => shown.endsWith("rpm"));
    if (small) say(small, isTwice ? "" : units.text(more));
  });
}

// The whole design is tried with every relaxation, which takes longer than the design itself.
let asking = 0;
let relaxing = null;
function relax(answer) {
  clearTimeout(asking);
  asking = setTimeout(async () => {
    try {
      relaxing?.abort();
      relaxing = new AbortController();
      const question = { scene: answer.scene, files: blobs.listed(designs.present().files) };
      const tried = await engine.ask("relax", question, { signal: relaxing.signal });
      if (shown !== answer) return;
      if (designs.isCurrent()) $("verdict-reasons").textContent = units.text(tried.reasons);
      conflict(answer, tried.relaxations, tried.together);
    } catch { /* the conflict alone stays */ }
  }, 120);
}

// A new design is asked: what is tried for the last one is of no use.
export function stop() {
  clearTimeout(asking);
  relaxing?.abort();
}

function conflict(answer, relaxations, together) {
  const box = clear($("conflict"));
  const useful = relaxations.filter((r) => r.value);
  const asked = remedies({ message: answer.reasons });
  hide(box, answer.quick || !answer.needs_relaxing || (answer.conflict.length === 0 && useful.length === 0 && together.length === 0 && asked.length === 0));
  if (box.hidden) return;
  if (answer.conflict.length > 0) {
    box.append(make("p", {}, make("strong", {}, t("studio-conflict")), " ", units.text(answer.conflict.join(" · "))));
  }
  if (asked.length > 0) box.append(choices(asked));
  if (useful.length > 0) {
    box.append(make("p", {}, t("studio-relax")), make("div", { class: "buttons" }, ...useful.map(button)));
  } else if (together.length > 0 && together.every((r) => r.value)) {
    const all = together.map((r) => ({ set: { key: r.key, value: r.value } }));
    const text = together.map((r) => units.text(local(`${label(r.key)} ${r.from} → ${r.to}`))).join(", ");
    box.append(make("p", {}, t("studio-relax-together")),
      make("div", { class: "buttons" }, make("button", { type: "button", class: "relax", onclick: () => apply(all) }, text)));
  }
}

// What the reader of a recording asks for is chosen here.
function choices(asked) {
  return make("div", { class: "buttons" }, ...asked.map(([text, action]) => make("button", { type: "button", class: "choice", onclick: action }, text)));
}

function button({ key, from, to, value }) {
  return make("button", { type: "button", class: "relax", "data-relax": key, "data-value": value,
    onclick: () => apply([{ set: { key, value } }]) }, units.text(local(`${label(key)}: ${from} → `)), make("b", {}, units.text(local(to))));
}

function limits(answer) {
  const box = clear($("limits"));
  box.append(make("h2", {}, t("studio-active")));
  if (answer.easing.length > 0) {
    box.append(make("table", {}, make("thead", {}, make("tr", {},
      ...["limit", "eased", "objective"].map((k) => make("th", { scope: "col" }, t(`studio-active-${k}`))))),
    make("tbody", {}, ...answer.easing.slice(0, 6).map((e) => make("tr", {}, make("th", { scope: "row" }, e.name),
      make("td", {}, units.text(`${e.from} → ${e.to}`)), make("td", {}, units.text(`${e.objective}: ${e.before} → ${e.after}`)))))));
  } else {
    box.append(make("p", {}, answer.active.length > 0 ? answer.active.join(" · ") : t("studio-active-none")));
  }
  if (answer.notes.length > 0) box.append(make("details", { class: "notes" }, make("summary", {}, t("studio-notes", { count: answer.notes.length })),
    make("ul", {}, ...answer.notes.map((n) => make("li", {}, units.text(n))))));
}

// The report's own tables; the server escapes what stands in them. They lie below the picture and follow when the
// hand rests, or at once on paper.
let resting = 0;
let due = null;
function tables(answer) {
  clearTimeout(resting);
  due = () => {
    const { checks, active, data, solution } = answer.tables;
    $("tables").innerHTML = units.text(`<div>${checks}${active}</div><div>${data}${solution}</div>`);
    due = null;
  };
  resting = setTimeout(() => due?.(), 150);
}
addEventListener("beforeprint", () => due?.());
