// The programme of segments as a table, the catalogue of laws as small curves.

import { $, make, clear, svg } from "../core/dom.js";
import { t, number, language, onLanguage } from "../core/words.js";
import { engine } from "../core/net.js";
import { onTab, openTab, dialog } from "../core/view.js";

const LISTS = ["law.segment", "law.point", "law.dwell", "gait.weight"];
const ORDER = ["motion", "angle", "length", "from", "to", "lift", "force", "weight", "velocity", "acceleration", "jerk"];
let edit = () => {};
let fields = {};
let laws = [];
let gesture = 0;

export function load(onEdit) {
  edit = onEdit;
  onTab("programme", async () => {
    build();
    if (laws.length === 0) ({ laws } = await engine.ask("laws", {}));
    build();
  });
  onLanguage(() => { if (openTab() === "programme") build(); });
}

export function render(version, seen) {
  if (fields === seen.fields) return;
  fields = seen.fields;
  if (openTab() === "programme" && !$("programme").contains(document.activeElement)) build();
  else if (openTab() === "programme") refresh();
}

function count(list) {
  let n = 0;
  while (Object.keys(fields).some((k) => k.startsWith(`${list}.${n + 1}.`))) n += 1;
  return n;
}

function columns(list) {
  const found = new Set();
  for (const key of Object.keys(fields)) {
    if (key.startsWith(`${list}.`)) found.add(key.split(".").at(-1));
  }
  const order = (c) => (ORDER.includes(c) ? ORDER.indexOf(c) : ORDER.length);
  return [...found].sort((a, b) => order(a) - order(b)).filter((c) => c !== "length" || Object.keys(fields).some((k) => k.endsWith(".length") && fields[k].text));
}

function build() {
  const root = clear($("programme"));
  root.append(make("h2", {}, t("studio-programme")), make("p", { class: "lead" }, t("studio-programme-lead")));
  for (const list of LISTS) {
    const n = count(list);
    const section = make("section", { class: "list", "data-list": list });
    if (n > 0) section.append(table(list, n));
    section.append(make("div", { class: "buttons" },
      make("button", { type: "button", onclick: () => edit([{ insert: { list, number: n + 1 } }]) }, t(`studio-add-${list.replace(".", "-")}`)),
      list === "law.segment" && n > 1 ? make("button", { type: "button", onclick: () => edit([{ rebalance: { keep: 0 } }]) }, t("studio-rebalance")) : null,
      list === "law.segment" && n > 0 ? make("button", { type: "button", onclick: catalogue }, t("studio-laws")) : null));
    root.append(section);
  }
}

function table(list, n) {
  const names = columns(list);
  const head = make("tr", {}, make("th", { scope: "col" }, "#"), ...names.map((c) => make("th", { scope: "col" }, t(`studio-column-${c}`))), make("th", {}, make("span", { class: "hidden" }, t("studio-actions"))));
  const rows = [];
  for (let i = 1; i <= n; i += 1) rows.push(row(list, i, n, names));
  return make("div", { class: "scroll", tabindex: "0" }, make("table", { class: "entries" },
    make("caption", {}, t(`studio-list-${list.replace(".", "-")}`)), make("thead", {}, head), make("tbody", {}, ...rows)));
}

function row(list, i, n, names) {
  const cells = names.map((column) => {
    const key = `${list}.${i}.${column}`;
    return make("td", {}, column === "motion" ? motion(key, i) : cell(key, list, i, column));
  });
  const act = (text, label, action, disabled) => make("button", { type: "button", class: "tiny", "aria-label": `${t(label)} ${i}`, title: t(label), disabled, onclick: action }, text);
  return make("tr", {}, make("th", { scope: "row" }, String(i)), ...cells, make("td", { class: "acts" },
    act("↑", "studio-up", () => edit([{ move: { list, from: i, to: i - 1 } }]), i === 1),
    act("+", "studio-insert", () => edit([{ insert: { list, number: i + 1 } }])),
    act("×", "studio-remove", () => edit([{ remove: { list, number: i } }]))));
}

function cell(key, list, i, column) {
  const field = fields[key];
  const input = make("input", { type: "text", name: key, "aria-label": `${t(`studio-column-${column}`)} ${i}`, size: 8, autocomplete: "off", spellcheck: "false", placeholder: field?.placeholder ?? "" });
  input.value = field?.text ?? "";
  let before = fields;
  input.addEventListener("focus", () => { gesture += 1; before = fields; });
  // The other angles follow at once, so that the turn stays whole.
  const follows = list === "law.segment" && column === "angle";
  const returns = list === "law.segment" && column === "lift";
  input.addEventListener("input", () => {
    if (!follows) edit([{ set: { key, value: input.value } }, ...(returns ? back(before, i, input.value) : [])], `${key} ${gesture}`);
  });
  input.addEventListener("change", () => { if (follows) edit([{ set: { key, value: input.value } }, { rebalance: { keep: i } }], `${key} ${gesture}`); });
  return input;
}

// The next segment that moves returns by what this lift has grown, so that the lifts still add to 0.
function back(before, i, value) {
  const parse = (text) => /^\s*([-+]?[\d.]+)\s*([^\d\s].*)$/.exec((text ?? "").replace(",", "."));
  const lift = (n) => parse(before[`law.segment.${n}.lift`]?.text);
  const [own, next] = [lift(i), parse(value)];
  if (!own || !next || own[2].trim() !== next[2].trim()) return [];
  const n = count("law.segment");
  const other = Array.from({ length: n - 1 }, (_, k) => (i + k) % n + 1).find((k) => lift(k) && Number(lift(k)[1]) !== 0 && lift(k)[2].trim() === own[2].trim());
  if (!other) return [];
  const x = Number(lift(other)[1]) - (Number(next[1]) - Number(own[1]));
  return [{ set: { key: `law.segment.${other}.lift`, value: `${Number(x.toFixed(6))} ${own[2].trim()}` } }];
}

function motion(key, i) {
  const present = fields[key]?.text ?? "";
  const names = laws.map((l) => l.written ?? l.name);
  const select = make("select", { name: key, "aria-label": `${t("studio-column-motion")} ${i}`, onchange: () => edit([{ set: { key, value: select.value } }]) });
  for (const name of new Set(["dwell", present, ...names])) if (name) select.append(make("option", { value: name }, name));
  select.value = present;
  const law = laws.find((l) => l.name === present || l.written === present);
  return make("span", { class: "motion" }, law ? small(law.s, "s") : null, select);
}

function refresh() {
  for (const input of $("programme").querySelectorAll("input[name], select[name]")) {
    const field = fields[input.name];
    if (field && input !== document.activeElement) input.value = field.text;
  }
}

function small(values, kind) {
  const [width, height] = [54, 24];
  const known = values.filter((v) => v !== null);
  const [low, high] = [Math.min(...known, 0), Math.max(...known, kind === "s" ? 1 : 0)];
  const y = (v) => height - 2 - (v - low) / (high - low || 1) * (height - 4);
  const d = values.map((v, i) => (v === null ? "" : `${i ? "L" : "M"}${(i / (values.length - 1) * (width - 2) + 1).toFixed(1)} ${y(v).toFixed(1)}`)).join("");
  return svg("svg", { class: `small ${kind}`, viewBox: `0 0 ${width} ${height}`, "aria-hidden": "true" }, svg("path", { class: "zero", d: `M0 ${y(0)}H${width}` }), svg("path", { class: "curve", d }));
}

function catalogue() {
  dialog("studio-laws", (body) => {
    body.className = "laws";
    body.append(make("p", { class: "lead" }, t("studio-laws-lead")));
    const head = ["s", "v", "a", "j"].map((k) => make("th", { scope: "col" }, k));
    const factors = ["cv", "ca", "cj"].map((k) => make("th", { scope: "col", class: "n" }, `C${k[1]}`));
    const rows = laws.map((law) => make("tr", {}, make("th", { scope: "row" }, law.name, make("small", { class: "formula" }, law.formula), make("small", { class: "advice" }, law.advice[language()])),
      ...["s", "v", "a", "j"].map((k) => make("td", {}, small(law[k], k))),
      ...["cv", "ca", "cj"].map((k) => make("td", { class: "n" }, law[k] === null ? "∞" : number(law[k], 4))),
      make("td", {}, [...new Set(law.joins[language()])].join(" → "))));
    body.append(make("div", { class: "scroll", tabindex: "0" }, make("table", {}, make("thead", {}, make("tr", {}, make("th", { scope: "col" }, t("studio-column-motion")), ...head, ...factors, make("th", { scope: "col" }, t("studio-laws-joins")))), make("tbody", {}, ...rows))));
  });
}

