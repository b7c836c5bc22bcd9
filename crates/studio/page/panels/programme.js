// Programme of segments: templates, picture of the turn, one row per segment. Below it are the other lists of the scene.

import { $, html, live, nothing, render as draw, repeat, svgTemplate } from "../core/dom.js";
import { t, has, number, local, onLanguage } from "../core/words.js";
import { engine } from "../core/net.js";
import { onTab, openTab } from "../core/view.js";
import * as clock from "../core/clock.js";
import * as designs from "../core/designs.js";
import * as segments from "../core/segments.js";
import * as typed from "../core/typed.js";
import * as versions from "../core/versions.js";
import { label } from "./names.js";
import { catalogue, curve, nameOf } from "../dialogs/laws.js";

const SEGMENT = "law.segment";
const LISTS = ["law.point", "law.dwell", "gait.weight"];
const ORDER = ["angle", "from", "to", "lift", "force", "weight", "velocity", "acceleration", "jerk"];
// Sections whose former values are restored when the last segment is removed.
const FORMER = /^(drive|gait|law|limits\.force_|accuracy|machine\.floor)/;
/** @type {(changes: any[], gesture?: string, more?: object) => void} */
let edit = () => {};
let version = null;
let seen = { answer: null, fields: {} };
let laws = { laws: [], dwell: {} };
// Row under the pointer, field that is being edited, and a number for each visit of a field.
let hot = -1;
let typing = null;
let visit = 0;

export function load(onEdit) {
  edit = onEdit;
  onTab("programme", async () => {
    show();
    if (laws.laws.length > 0) return;
    laws = await engine.ask("laws", {});
    show();
  });
  onLanguage(show);
  clock.onAngle(cursor);
}

export function render(v, now) {
  version = v;
  seen = now;
  show();
}

// --- programme of the version ----------------------------------------------------------------------

const textOf = (key) => seen.fields[key]?.text ?? "";
const isStraight = () => "cam.travel" in seen.fields;
const column = () => (isStraight() ? "length" : "angle");

// Segments of the last design, with the pending and rejected changes.
function rows() {
  let list = [];
  for (let n = 1; `${SEGMENT}.${n}.motion` in seen.fields; n += 1) {
    const of = (name) => textOf(`${SEGMENT}.${n}.${name}`);
    list.push({ motion: of("motion") || "dwell", lift: of("lift"), angle: of(column()) });
  }
  for (const e of (version.pending ?? []).flatMap((p) => p.edits)) {
    if (e.programme) list = e.programme.segments.map((s) => ({ motion: s.motion, lift: s.lift, angle: s[column()] ?? "" }));
    const [, digits, name] = /^law\.segment\.(\d+)\.(\w+)$/.exec(e.set?.key ?? "") ?? [];
    const n = Number(digits);
    if (list[n - 1]) list[n - 1] = { ...list[n - 1], [name === "length" ? "angle" : name]: e.set.value };
  }
  return list;
}

// Required sum of the segments: the travel, half a turn for a cam of constant breadth, or one or several turns.
function whole(list) {
  if (isStraight()) return segments.size(textOf("cam.travel")) || null;
  const total = list.reduce((x, row) => x + segments.size(row.angle), 0);
  if (textOf("cam.breadth") && total < 270) return 180;
  return 360 * (Number(textOf("cam.turns")) || 1);
}

function usual(list, isAngle) {
  const most = Math.max(0, ...list.map((row) => Math.abs(segments.size(row.lift || "0"))).filter(Number.isFinite));
  if (most > 0) return most;
  const limit = segments.size(textOf("limits.stroke") || "x");
  return Math.min(isAngle ? 15 : 20, limit > 0 ? limit : Infinity);
}

function present() {
  const list = rows();
  const isArm = textOf("cam.follower").includes("oscillating");
  const lifts = list.map((row) => typed.unitOf(row.lift)).find(Boolean) ?? (isArm ? "deg" : "mm");
  const { locks, rest = null, last = null } = version.programme ?? {};
  const own = locks?.length === list.length;
  return {
    rows: list, locks: own ? locks : list.map(() => false), rest: own ? rest : null, last: own ? last : null,
    whole: whole(list), unit: isStraight() ? "mm" : "deg", lifts, usual: usual(list, isArm), usualLength: 120,
  };
}

const isPending = () => version.pending.some((p) => p.keys.includes(SEGMENT));
const isProgramme = () => isPending() || textOf("law.family") === "program";

// --- changes ---------------------------------------------------------------------------------------

function change(next, title, gesture = null) {
  const former = isProgramme() ? version.programme?.former ?? null : formerValues();
  const { locks, rest, last } = next;
  const list = next.rows.map(({ motion, lift, angle }) => ({ motion, lift, [column()]: angle }));
  const back = list.length === 0 && former ? restored(former) : [];
  const more = list.length === 0
    ? { recording: version.recording, hand: version.hand, programme: null }
    : { programme: { locks, rest, last, former } };
  edit([{ programme: { segments: list } }, ...back], gesture, { title, ...more });
}

const formerValues = () => Object.entries(seen.fields)
  .filter(([key, { text }]) => text !== "" && FORMER.test(key) && !key.startsWith(SEGMENT))
  .map(([key, { text }]) => [key, text]);

// Changes that restore the values before the programme. For lists they contain all columns, because a new entry starts as a copy.
function restored(former) {
  const entries = former.map(([key, value]) => ({ key, value, list: /^(.*)\.(\d+)\.(\w+)$/.exec(key) }));
  const plain = entries.filter((e) => !e.list).map(({ key, value }) => ({ set: { key, value } }));
  const lists = [...new Set(entries.filter((e) => e.list).map((e) => e.list[1]))];
  const inserted = lists.flatMap((list) => {
    const all = entries.filter((e) => e.list?.[1] === list);
    const names = [...new Set(all.map((e) => e.list[3]))];
    const count = Math.max(...all.map((e) => Number(e.list[2])));
    return Array.from({ length: count }, (_, i) => i + 1).flatMap((n) => [{ insert: { list, number: n } }, ...names.map((name) => {
      const key = `${list}.${n}.${name}`;
      return { set: { key, value: all.find((e) => e.key === key)?.value ?? "" } };
    })]);
  });
  return [...plain, ...inserted];
}

// Adds a version for a change of data that only the page stores.
function remember(more, title) {
  const { locks, rest, last } = { ...present(), ...more };
  versions.note({ programme: { former: version.programme?.former ?? null, locks, rest, last }, title });
  designs.ask();
}

const numbered = (key, i) => `${t(key)} ${i + 1}`;

// --- picture of the turn ---------------------------------------------------------------------------

const percent = (x) => `${(100 * x).toFixed(3)}%`;
// Text of a scene with four digits, in the number format of the language.
function shown(text) {
  const unit = typed.unitOf(text);
  const plain = Number(text.slice(0, text.length - unit.length));
  if (unit === "" || !Number.isFinite(plain)) return local(text);
  const short = number(plain).replace("−", "-");
  return unit === "deg" || unit === "°" ? `${short}°` : `${short} ${unit}`;
}

const lengthOf = (x, unit) => shown(segments.text(Number(x.toPrecision(6)), unit));

function picture(p) {
  const { list, whole } = segments.parts(p);
  const heights = p.rows.reduce((all, row) => [...all, all.at(-1) + (segments.size(row.lift || "0") || 0)], [0]);
  const [low, high] = [Math.min(...heights), Math.max(...heights)];
  const y = (lift) => 30 - 22 * (lift - low) / (high - low || 1);
  const part = ({ row, from, to }) => {
    const width = to - from;
    const kind = row < 0 || from >= whole - 1e-9 ? "bad" : segments.isDwell(p.rows[row]) ? "dwell" : "moves";
    const name = row < 0 ? lengthOf(segments.gap(p), p.unit) : shown(p.rows[row].angle);
    return svgTemplate`<g class="part ${kind} ${row === hot && row >= 0 ? "hot" : ""}" data-row=${row + 1}
      @pointerenter=${() => light(row)} @pointerleave=${() => light(-1)} @click=${() => row >= 0 && focus(row)}>
      <rect x=${percent(from)} width=${percent(width)} y="0" height="54"></rect>
      ${row < 0 ? nothing : path(p.rows[row], from, width, y(heights[row]), y(heights[row + 1]))}
      ${width < 0.08 ? nothing : svgTemplate`<text x=${percent(from + width / 2)} y="48">${name}</text>`}</g>`;
  };
  const over = whole < 1 ? svgTemplate`<rect class="over" x=${percent(whole)} width=${percent(1 - whole)} y="0" height="54"></rect>` : nothing;
  return html`<svg class="turn" role="img" aria-label=${spoken(p)} data-gap=${segments.gap(p)}>
    ${list.map(part)}${over}<line class="at" id="turn-cursor" y1="0" y2="54"></line></svg>`;
}

function path(row, from, width, a, b) {
  const d = segments.isDwell(row) ? `M0 ${a}H100` : `M0 ${a}C45 ${a} 55 ${b} 100 ${b}`;
  return svgTemplate`<svg x=${percent(from)} width=${percent(width)} y="0" height="36" viewBox="0 0 100 36" preserveAspectRatio="none"><path d=${d}></path></svg>`;
}

function spoken(p) {
  const open = segments.gap(p);
  const size = lengthOf(Math.abs(open), p.unit);
  if (open === 0) return t("studio-turn-covered", { count: p.rows.length });
  return open > 0 ? t("studio-turn-gap", { size }) : t("studio-turn-over", { size });
}

// Draws the cam angle in the picture.
function cursor(theta) {
  const line = $("turn-cursor");
  if (!line || openTab() !== "programme" || !seen.answer) return;
  const { start, length } = seen.answer.motion;
  const x = percent(Math.min(1, (theta - start) / length));
  line.setAttribute("x1", x);
  line.setAttribute("x2", x);
}

function light(i) {
  if (hot === i) return;
  hot = i;
  show();
}

const focus = (i) => /** @type {HTMLInputElement} */ (document.querySelector(`#programme [name="${SEGMENT}.${i + 1}.${column()}"]`))?.select();

// --- rows ------------------------------------------------------------------------------------------

const LOCK = svgTemplate`<path d="M7 11V8a5 5 0 0 1 10 0v3M5 11h14v9H5z"/>`;
const OPEN = svgTemplate`<path d="M7 11V8a5 5 0 0 1 9.5-2M5 11h14v9H5z"/>`;

function refusedKeys() {
  return version.pending.map((p) => p.fault?.key).filter(Boolean);
}

// Text field. While it is being edited, it shows the typed text.
/** @param {{input?: Function, changed?: Function, disabled?: boolean}} on */
function field(key, name, text, on) {
  const own = typing?.key === key ? typing.text : shown(text);
  return html`<input type="text" name=${key} aria-label=${name} size="7" autocomplete="off" spellcheck="false" .value=${live(own)}
    placeholder=${seen.fields[key]?.placeholder ?? ""} ?disabled=${on.disabled} aria-invalid=${refusedKeys().includes(key) ? "true" : nothing}
    @focus=${(e) => { visit += 1; e.target.select(); }}
    @input=${(e) => { typing = { key, text: e.target.value, from: typing?.key === key ? typing.from : present() }; on.input?.(e.target.value, typing.from); }}
    @change=${(e) => { typing = null; if (on.changed) on.changed(e.target.value); else show(); }}
    @blur=${() => { if (typing) { typing = null; show(); } }}>`;
}

function motion(p, i) {
  const row = p.rows[i];
  const names = ["dwell", ...laws.laws.map((law) => law.written)];
  const set = (name) => change(segments.setMotion(present(), i, name), numbered("studio-column-motion", i));
  const law = laws.laws.find((l) => [l.name, l.written].includes(row.motion));
  const own = law?.written ?? row.motion;
  return html`<button type="button" class="tiny law" aria-label=${numbered("studio-laws", i)} title=${t("studio-laws")}
      @click=${() => catalogue(laws, own, set)}>${curve(law?.s ?? [0, 0], "s", segments.size(row.lift || "0") < 0)}</button>
    <select name="${SEGMENT}.${i + 1}.motion" aria-label=${numbered("studio-column-motion", i)} @change=${(e) => set(e.target.value)}>
      ${[...new Set([...names, own])].map((name) => html`<option value=${name} .selected=${live(name === own)}>${nameOf(laws, name)}</option>`)}</select>`;
}

function row(p, i) {
  const { lift, angle } = p.rows[i];
  const title = (name) => `${t("studio-segment")} ${i + 1}: ${t(`studio-column-${name}`)}`;
  const key = (name) => `${SEGMENT}.${i + 1}.${name}`;
  const act = (text, name, action, disabled = false) => html`<button type="button" class="tiny" aria-label=${numbered(name, i)}
    title=${t(name)} ?disabled=${disabled} @click=${() => change(action(present()), numbered(name, i))}>${text}</button>`;
  const locked = p.locks[i];
  const lock = () => remember({ locks: present().locks.map((x, k) => (k === i ? !x : x)) }, numbered(locked ? "studio-unlock" : "studio-lock", i));
  return html`<li class=${hot === i ? "hot" : ""} data-segment-row=${i + 1} @pointerenter=${() => light(i)} @pointerleave=${() => light(-1)}>
    <b>${i + 1}</b>${motion(p, i)}
    ${field(key("lift"), numbered("studio-column-lift", i), lift, {
      disabled: segments.isDwell(p.rows[i]),
      input: (text, from) => change(segments.setLift(from, i, text), title("lift"), `${key("lift")} ${visit}`),
    })}
    ${field(key(column()), numbered(`studio-column-${column()}`, i), angle, { changed: (text) => change(segments.setAngle(present(), i, text), title(column())) })}
    <button type="button" class="tiny lock" aria-pressed=${String(locked)} aria-label=${numbered("studio-lock", i)} title=${t(locked ? "studio-unlock" : "studio-lock")}
      @click=${lock}><svg viewBox="0 0 24 24" aria-hidden="true">${locked ? LOCK : OPEN}</svg></button>
    <input type="radio" name="takes-rest" aria-label=${numbered("studio-rest", i)} title=${t("studio-rest")} ?disabled=${locked}
      .checked=${live(segments.rest(p) === i)} @change=${() => remember({ rest: i }, numbered("studio-rest", i))}>
    <span class="acts">${act("↑", "studio-up", (now) => segments.move(now, i, i - 1), i === 0)}${act("+", "studio-insert", (now) => segments.add(now, i + 1))}${
      act("×", "studio-remove", (now) => segments.remove(now, i))}</span>
    ${p.last === i ? misfit(p, i) : nothing}</li>`;
}

// Message about angles that do not add up to the whole, with buttons for corrections.
function misfit(p, i) {
  const open = segments.gap(p);
  if (open === 0 || Number.isNaN(open)) return nothing;
  const size = lengthOf(Math.abs(open), p.unit);
  const most = i === null ? null : segments.largest(p, i);
  const r = segments.rest(p);
  const button = (text, action) => html`<button type="button" @click=${() => change(action(present()), text)}>${text}</button>`;
  const use = most === null ? nothing : button(t("studio-use-angle", { size: shown(most) }), (now) => segments.setAngle(now, i, most));
  const give = r >= 0 ? button(t("studio-give-rest", { size, number: r + 1 }), segments.close) : nothing;
  const which = open > 0 ? "studio-turn-gap" : most === null ? "studio-turn-over" : "studio-turn-most";
  return html`<p class="misfit" role="alert">${t(which, { size, most: most === null ? "" : shown(most) })} ${open > 0 && r >= 0 ? give : use}</p>`;
}

function openLifts(p) {
  const open = segments.rise(p);
  if (open === 0 || Number.isNaN(open)) return nothing;
  const moving = p.rows.findLastIndex((row) => !segments.isDwell(row));
  const lift = p.rows[moving] && segments.text(segments.size(p.rows[moving].lift || "0") - open, p.lifts);
  const title = t("studio-lifts-return", { size: lengthOf(-open, p.lifts) });
  const other = moving >= 0 && segments.size(lift) !== 0 ? t("studio-lifts-set", { number: moving + 1, size: shown(lift) }) : null;
  const set = () => {
    const now = present();
    change({ ...now, rows: now.rows.map((r, k) => (k === moving ? { ...r, lift } : r)) }, other);
  };
  return html`<p class="misfit" role="alert">${t("studio-lifts-open", { size: lengthOf(open, p.lifts) })}
    <button type="button" id="add-return" @click=${() => change(segments.addReturn(present()), title)}>${title}</button>
    ${other && p.rows.filter((r) => !segments.isDwell(r)).length > 1 ? html`<button type="button" @click=${set}>${other}</button>` : nothing}</p>`;
}

// --- templates, and values that a programme replaced -------------------------------------------------

function templates() {
  const small = (name) => {
    let [x, at] = [2, 26];
    const d = segments.TEMPLATES[name].map(([kind, part]) => {
      const [from, next] = [x, kind === "up" ? 6 : kind === "down" ? 26 : at];
      const middle = from + 38 * part;
      x += 76 * part;
      const line = kind === "dwell" ? `H${x}` : `C${middle} ${at} ${middle} ${next} ${x} ${next}`;
      at = next;
      return line;
    });
    return svgTemplate`<svg viewBox="0 0 80 32" aria-hidden="true"><path class="base" d="M2 26H78"></path><path d="M2 26${d.join("")}"></path></svg>`;
  };
  const choice = (name) => html`<button type="button" data-template=${name} title=${t(`studio-template-help-${name}`)}
    @click=${() => change(segments.template(present(), name), t(`studio-template-${name}`))}>${small(name)}<span>${t(`studio-template-${name}`)}</span></button>`;
  return html`<div class="templates" role="group" aria-label=${t("studio-templates")}>${Object.keys(segments.TEMPLATES).map(choice)}</div>`;
}

function setAside(p) {
  const former = p.rows.length > 0 ? version.programme?.former ?? [] : [];
  const gone = former.filter(([key, text]) => textOf(key) !== text && key !== "law.family");
  if (gone.length === 0 || isPending()) return nothing;
  const names = new Set(gone.map(([key]) => (/\.\d+\./.test(key) ? t(`studio-list-${key.split(".").slice(0, 2).join("-")}`) : label(key))));
  return html`<p class="lead" id="set-aside">${t("studio-set-aside", { names: [...names].join(", ") })}</p>`;
}

function idle(p) {
  if (p.rows.length === 0 || isProgramme() || textOf("law.family") === "") return nothing;
  return html`<p class="misfit" role="alert">${t("studio-programme-idle")}
    <button type="button" @click=${() => change(present(), t("studio-programme-take"))}>${t("studio-programme-take")}</button></p>`;
}

// --- other lists -------------------------------------------------------------------------------------

function count(list) {
  let n = 0;
  while (Object.keys(seen.fields).some((key) => key.startsWith(`${list}.${n + 1}.`))) n += 1;
  return n;
}

const valueOf = (key) => version.pending.flatMap((p) => p.edits).findLast((e) => e.set?.key === key)?.set.value ?? textOf(key);

function other(list) {
  const n = count(list);
  const applies = list === "gait.weight" ? Object.entries(seen.fields).some(([key, f]) => key.startsWith("gait.") && f.text !== "") : !isProgramme();
  if (n === 0 && !applies) return nothing;
  const name = list.replace(".", "-");
  const found = new Set(Object.keys(seen.fields).filter((key) => key.startsWith(`${list}.`)).map((key) => key.split(".").at(-1)));
  const names = [...found].sort((a, b) => ORDER.indexOf(a) - ORDER.indexOf(b));
  const cell = (i, column) => {
    const key = `${list}.${i + 1}.${column}`;
    const set = (text) => edit([{ set: { key, value: typed.value(text, typed.unitOf(textOf(key))) } }], `${key} ${visit}`);
    return html`<td>${field(key, numbered(`studio-column-${column}`, i), valueOf(key), { input: set })}</td>`;
  };
  const act = (text, key, i, change, disabled = false) => html`<button type="button" class="tiny" aria-label=${numbered(key, i)} title=${t(key)}
    ?disabled=${disabled} @click=${() => edit([change])}>${text}</button>`;
  const entry = (_, i) => html`<tr><th scope="row">${i + 1}</th>${names.map((column) => cell(i, column))}<td class="acts">
    ${act("↑", "studio-up", i, { move: { list, from: i + 1, to: i } }, i === 0)}${act("+", "studio-insert", i, { insert: { list, number: i + 2 } })}${
      act("×", "studio-remove", i, { remove: { list, number: i + 1 } })}</td></tr>`;
  const table = html`<div class="scroll" tabindex="0"><table class="entries"><caption>${t(`studio-list-${name}`)}</caption>
    <thead><tr><th scope="col">#</th>${names.map((c) => html`<th scope="col">${t(`studio-column-${c}`)}</th>`)}<th><span class="hidden">${t("studio-actions")}</span></th></tr></thead>
    <tbody>${Array.from({ length: n }, entry)}</tbody></table></div>`;
  return html`<section class="list" data-list=${list}>${n > 0 ? table : nothing}
    <button type="button" @click=${() => edit([{ insert: { list, number: n + 1 } }])}>${t(`studio-add-${name}`)}</button></section>`;
}

// --- whole panel -------------------------------------------------------------------------------------

function show() {
  if (openTab() !== "programme" || !version) return;
  // The fields of a version without a response are unknown. The old rows stay until the response arrives.
  if (Object.keys(seen.fields).length === 0 && !version.fault && !isPending()) return;
  const p = present();
  const heads = ["motion", "lift", column(), "rest"].map((name) => html`<span>${has(`studio-column-${name}`) ? t(`studio-column-${name}`) : nothing}</span>`);
  const free = p.locks.some((locked) => !locked);
  const act = (id, name, action) => html`<button type="button" id=${id} @click=${() => change(action(present()), t(name))}>${t(name)}</button>`;
  draw(html`<h2>${t("studio-programme")}</h2>${templates()}
    <section class="list" data-list=${SEGMENT}>
      ${p.rows.length > 0 ? html`${picture(p)}<div class="heads" aria-hidden="true">${heads}</div>
        <ol class="segments">${repeat(p.rows, (_, i) => i, (_, i) => row(p, i))}</ol>` : nothing}
      ${p.last === null ? misfit(p, null) : nothing}${openLifts(p)}${idle(p)}
      <div class="buttons">${act("add-segment", "studio-add-law-segment", (now) => segments.add(now, now.rows.length))}
        ${p.rows.length > 1 && p.whole !== null && free ? act("rebalance", "studio-rebalance", segments.rebalance) : nothing}</div>
      ${p.rows.length > 0 ? html`<p class="lead">${t("studio-programme-lead")}</p>` : nothing}${setAside(p)}</section>
    ${LISTS.map(other)}`, $("programme"));
  cursor(clock.angle());
}
