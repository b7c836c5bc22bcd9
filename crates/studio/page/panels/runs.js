// The finished cam in motion, what a log of it shows, and a table of designs over one or two values.

import { $, make, clear, notice } from "../core/dom.js";
import { t, number, local } from "../core/words.js";
import { engine } from "../core/net.js";
import { enlarging } from "../core/view.js";
import * as units from "../core/units.js";
import { label } from "./form.js";

// Values of one key, and of each of two.
const [ALONE, BOTH] = [13, 7];
const said = (error) => notice([error.place, error.message, error.help].filter(Boolean).join(" – "));
let ran = null;
let logged = null;
let grid = null;

// `ask` sends a question about the design on the screen for a box, `fields` are its fields, `figures` the columns with units.
// `take` opens a scene with the files of the present one.
export function sections({ ask, fields, figures, edit, take }) {
  const keys = Object.keys(fields).filter((key) => fields[key].slider && fields[key].text);
  const choice = (id, first) => make("select", { id, "aria-label": t(`studio-${id}`) }, ...first, ...keys.map((key) => make("option", { value: key }, label(key))));
  const across = choice("sweep-across", []);
  const down = choice("sweep-down", [make("option", { value: "" }, "–")]);
  const figure = make("select", { id: "sweep-figure", "aria-label": t("studio-sweep-figure") }, ...figures.map(([name]) => make("option", { value: name }, t(`figure-${name}`))));
  const button = (id, action) => make("button", { type: "button", id, onclick: async ({ target }) => {
    target.disabled = true;
    await action().catch(said);
    target.disabled = false;
  } }, t("studio-compute"));
  const run = async () => {
    ran = await ask("simulate", "motion");
    motion();
  };
  const sweep = async () => {
    const size = down.value && down.value !== across.value ? BOTH : ALONE;
    const axes = [across.value, size === BOTH ? down.value : ""].filter(Boolean).map((key) => ({ key, values: values(fields[key].slider, size) }));
    const vary = axes.map(({ key, values: [first, ...rest] }) => `${key}=${first}:${rest.at(-1)}:${size}`);
    const answer = await ask("sweep", "grid", { vary, column: figure.value });
    grid = { ...answer, axes, figure: figures.find(([name]) => name === figure.value) };
    designs(edit);
  };
  const log = make("input", { type: "file", id: "log", accept: ".csv,.txt", onchange: () => identify().catch(said) });
  const identify = async () => {
    const file = log.files[0];
    if (!file) return;
    const hash = await engine.keep(file);
    logged = await ask("identify", "logged", { log: file.name, hash });
    machine(take);
  };
  const out = [make("h2", {}, t("studio-simulate")), make("p", { class: "lead" }, t("studio-simulate-lead")), make("div", { class: "buttons" }, button("simulate", run)), make("div", { id: "motion" }),
    make("h2", {}, t("studio-log")), make("p", { class: "lead" }, t("studio-log-lead")), make("label", { class: "pick", for: "log" }, t("studio-log-pick")), log, make("div", { id: "logged" }),
    make("h2", {}, t("studio-sweep")), make("p", { class: "lead" }, t("studio-sweep-lead")), make("div", { class: "buttons" }, across, down, figure, button("sweep", sweep)), make("div", { id: "grid" })];
  queueMicrotask(() => { motion(); machine(take); designs(edit); });
  return out;
}

// From 50 % to 150 %, within the slider's ends.
function values({ from, to, at, unit }, count) {
  const [low, high] = [Math.max(from, at - 0.5 * Math.abs(at)), Math.min(to, at + 0.5 * Math.abs(at))];
  return Array.from({ length: count }, (_, i) => `${Number((low + (high - low) * i / (count - 1)).toPrecision(4))}${unit}`);
}

function motion() {
  const box = $("motion");
  if (!box || !ran) return;
  if (ran.why) clear(box).append(make("p", {}, ran.why));
  else {
    const rows = ran.table.trimEnd().split("\n").map((line) => line.trim().split(/ {2,}/)).map(([name, ...rest]) => make("tr", {}, make("th", { scope: "row" }, name), make("td", {}, units.text(rest.join(" ")))));
    clear(box).append(make("table", { class: "ran" }, make("tbody", {}, ...rows)), enlarging(ran.picture, "studio-simulate"));
  }
}

// What the log shows, and the button that opens the scene of the next cam.
function machine(take) {
  const box = $("logged");
  if (!box || !logged) return;
  if (logged.why) {
    clear(box).append(make("p", {}, logged.why));
    return;
  }
  const { lines, picture, next } = logged;
  const offer = next.why ? [make("p", {}, next.why)] : [make("p", {}, t("studio-log-next", { before: next.before, after: next.after })),
    make("div", { class: "buttons" }, make("button", { type: "button", id: "take-next", onclick: () => take(next.scene) }, t("studio-log-take")))];
  clear(box).append(make("ul", {}, ...lines.map((line) => make("li", {}, line.replace(/ +/g, " ")))), enlarging(picture, "studio-log"), ...offer);
}

// A table coloured by the figure: rows over the first key, columns over the second; a click takes the values.
function designs(edit) {
  const box = $("grid");
  if (!box || !grid) return;
  if (!grid.values) {
    clear(box).append(make("p", {}, t("studio-sweep-none")));
    return;
  }
  const { axes: [rows, columns], figure: [name, [of, plain]] } = grid;
  const [unit, factor] = units.unit(of);
  const width = columns?.values.length ?? 1;
  const found = grid.values.filter((x) => x !== null);
  const [low, high] = [Math.min(...found), Math.max(...found)];
  const cell = (i, j) => {
    const [x, verdict] = [grid.values[i * width + j], grid.verdicts[i * width + j]];
    const take = () => edit([rows, columns].filter(Boolean).map((axis, k) => ({ set: { key: axis.key, value: axis.values[k === 0 ? i : j] } })));
    return make("td", { class: `n ${verdict ?? ""}`, style: x === null ? null : `--part:${high > low ? Math.round(100 * (x - low) / (high - low)) : 0}%` },
      make("button", { type: "button", class: "plain", onclick: take, title: verdict ? t(`studio-verdict-${verdict}`) : "" }, x === null ? "–" : number(x * plain * factor)));
  };
  const head = columns ? [make("tr", {}, make("td", {}, `${label(rows.key)} / ${label(columns.key)}`), ...columns.values.map((v) => make("th", { scope: "col" }, units.text(local(v)))))] : [];
  const body = rows.values.map((v, i) => make("tr", {}, make("th", { scope: "row" }, units.text(local(v))), ...Array.from({ length: width }, (_, j) => cell(i, j))));
  clear(box).append(make("p", {}, `${t(`figure-${name}`)}, ${unit}`), make("div", { class: "scroll", tabindex: "0" }, make("table", { class: "grid" }, make("thead", {}, ...head), make("tbody", {}, ...body))));
}
