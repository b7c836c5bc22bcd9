// One value of the form: name with help text, text or choice, and slider.

import { html, nothing, live } from "../core/dom.js";
import { t, local, language } from "../core/words.js";
import { typeset } from "../core/units.js";
import * as typed from "../core/typed.js";
import * as slider from "./slider.js";
import * as possible from "./possible.js";
import { label, choice, help } from "./names.js";

const NUMBERS = ["number", "number-or-word", "count"];
const isNumber = ({ kind }) => NUMBERS.includes(kind);
export const id = (key) => `f-${key.replaceAll(".", "-")}`;
// Listeners by key. The same objects are used in every drawing.
const kept = new Map();

// `of(key)` returns the present field of a key, `send(key, value, gesture)` sends a change, and `draw` draws the form again.
export function listeners(key, { of, send, draw, help: open }) {
  if (kept.has(key.key)) return kept.get(key.key);
  const name = key.key;
  const aim = () => {
    const field = of(name);
    if (field?.slider) possible.aimAt(name, slider.extent(name, field.slider));
  };
  const all = {
    open: () => open(name),
    row: { focusin: aim, pointerenter: aim },
    slider: slider.listeners(name, () => of(name), draw),
    choose: (event) => {
      slider.begin();
      send(name, event.target.value, slider.gestureOf(name));
    },
    focus: () => slider.begin(),
    blur: () => {
      slider.release();
      draw();
    },
    type: ({ target }) => {
      slider.type(name, target.value);
      send(name, isNumber(key) ? typed.value(target.value, unitOf(of(name))) : target.value, slider.gestureOf(name));
    },
    press: (event) => {
      if (event.key === "Enter") slider.begin();
      if (event.key === "F1") {
        event.preventDefault();
        open(name);
      }
      const field = of(name);
      if (["ArrowUp", "ArrowDown"].includes(event.key) && field?.slider) slider.nudge(name, field.slider, event);
    },
    end: ({ target }) => {
      slider.setEnd(name, of(name).slider, target.dataset.end, target.value);
      forget(name);
      draw();
    },
  };
  kept.set(name, all);
  return all;
}

const unitOf = (field) => field?.slider?.unit.trim() || typed.unitOf(field?.text) || typed.unitOf(field?.placeholder);

// Value with which lit-html leaves a part unchanged.
const noChange = Symbol.for("lit-noChange");
// Inputs from which each row was drawn, and contents of fields as text.
const drawn = new Map();
const contents = new WeakMap();

function content(field) {
  if (!field) return "";
  if (!contents.has(field)) contents.set(field, JSON.stringify(field));
  return contents.get(field);
}

// Draws the row again at the next update, even if its inputs have not changed, because the typed text may differ.
export const forget = (name) => drawn.delete(name);

// `row`: {key, field, text (content of the field), fault, isHidden, isMain, isAway, isOpen, isAimed, on}. An unchanged row is not drawn
// again.
export function template(row) {
  const { key: { key: name }, field, text, fault, isHidden, isAway, isOpen, isAimed } = row;
  const range = field?.slider && field.slider.to - field.slider.from > 1e-9 ? slider.extent(name, field.slider) : null;
  const seen = isAimed && range ? possible.shown(name, range) : null;
  const flags = [isHidden, isAway, isOpen, isAimed].map(Number).join("");
  const of = [language(), content(field), text, fault?.message, flags, slider.held(name)?.at, range?.from, range?.to, seen?.gradient, seen?.words].join("|");
  if (drawn.get(name) === of) return noChange;
  drawn.set(name, of);
  return whole(row, range, seen);
}

function whole(row, range, seen) {
  const { key, field, fault, on } = row;
  const name = key.key;
  const kinds = { row: true, main: row.isMain, idle: field && !field.acts, set: row.text !== "", unused: row.isAway, faulty: fault };
  const kind = Object.keys(kinds).filter((k) => kinds[k]).join(" ");
  const taken = row.text === "auto" && field?.taken;
  return html`<div class=${kind} data-row=${name} ?hidden=${row.isHidden} @focusin=${on.row.focusin} @pointerenter=${on.row.pointerenter}>
    <button type="button" class="term" id="${id(name)}-label" tabindex=${row.isAimed ? 0 : -1} aria-expanded=${row.isOpen ? "true" : "false"}
      aria-controls="${id(name)}-help" @click=${on.open}>${label(name)}</button>
    ${isNumber(key) || key.kind.startsWith("text") ? input(row) : select(row)}
    ${taken ? html`<small class="taken">→ ${local(typeset(field.taken))}</small>` : nothing}
    ${range ? track(row, range, seen) : nothing}
    <p class="help" id="${id(name)}-help" ?hidden=${!row.isOpen}>${row.isOpen ? html`${help(key)} <code>${name}</code>` : nothing}</p>
    <p class="row-fault" id="${id(name)}-fault" ?hidden=${!fault}>${fault ? fault.message + (fault.help ? `; ${fault.help}` : "") : ""}</p>
  </div>`;
}

const described = (name) => `${id(name)}-help ${id(name)}-fault`;

// Placeholder of an empty field: the value in the design, otherwise the default.
function left(key, field) {
  if (!field) return "";
  if (field.taken && key.default === "auto") return `auto → ${typeset(field.taken)}`;
  const isReached = field.placeholder !== (key.default ?? "");
  return isReached ? t("studio-reached", { value: typeset(field.placeholder) }) : typeset(field.placeholder);
}

function input({ key, field, text, fault, isAway, on }) {
  const name = key.key;
  const open = left(key, field);
  return html`<input type="text" id=${id(name)} name=${name} autocomplete="off" spellcheck="false" aria-labelledby="${id(name)}-label"
    aria-describedby=${described(name)} aria-invalid=${fault ? "true" : nothing} tabindex=${isAway ? -1 : 0}
    placeholder=${isNumber(key) ? local(open) : open} .value=${live(text)}
    @focus=${on.focus} @blur=${on.blur} @input=${on.type} @keydown=${on.press}>`;
}

function select({ key, field, text, fault, isAway, on }) {
  const name = key.key;
  const flags = { true: t("studio-yes"), false: t("studio-no") };
  const named = (value) => (key.kind === "flag" ? flags[value] : choice(value));
  const usual = field?.placeholder ? `(${named(field.placeholder) ?? field.placeholder})` : "–";
  const values = key.kind === "flag" ? ["true", "false"] : key.choices;
  return html`<select id=${id(name)} name=${name} aria-labelledby="${id(name)}-label" aria-describedby=${described(name)}
    aria-invalid=${fault ? "true" : nothing} tabindex=${isAway ? -1 : 0} @change=${on.choose}>
    <option value="" .selected=${live(text === "")}>${usual}</option>
    ${values.map((value) => html`<option value=${value} .selected=${live(text === value)}>${named(value)}</option>`)}
  </select>`;
}

function track({ key, field, text, isAway, isAimed, on }, range, seen) {
  const name = key.key;
  const pending = typed.unitOf(text) === range.unit.trim() ? typed.number(text) : NaN;
  const at = slider.held(name)?.at ?? (Number.isFinite(pending) ? pending : field.slider.at);
  const end = (which) => html`<input class="end" data-end=${which} inputmode="decimal" tabindex=${isAimed && !isAway ? 0 : -1}
    aria-label="${t(`studio-end-${which}`)}: ${label(name)}" .value=${live(slider.shownEnd(range[which]))} @change=${on.end}>`;
  return html`<div class="track">
    <input type="range" data-key=${name} min=${range.from} max=${range.to} step="any" tabindex=${isAway ? -1 : 0} .value=${live(String(at))}
      aria-label=${t("studio-slider", { name: label(name) })} aria-valuetext=${text} aria-description=${seen?.words || nothing}
      @pointerdown=${on.slider.pointerdown} @pointermove=${on.slider.pointermove} @pointercancel=${on.slider.pointercancel} @pointerup=${on.slider.pointerup}
      @input=${on.slider.input} @change=${on.slider.change} @keydown=${on.slider.keydown}>
    <i class="possible" style=${seen ? `--shade: ${seen.gradient}` : nothing}></i>
    <span class="ends">${end("from")}<small>${seen?.words ?? ""}</small>${end("to")}</span>
  </div>`;
}
