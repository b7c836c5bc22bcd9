// Messages about the displayed version: designed, in progress, rejected.

import { $, hide, html, notice, nothing, render as draw, say } from "./dom.js";
import { language, number, t } from "./words.js";
import * as designs from "./designs.js";
import * as versions from "./versions.js";
import * as view from "./view.js";

// Pause before a fault is shown, and duration of a search before its progress is shown, ms.
const REST = 400;
const PATIENCE = 1000;
let longest = 60;
/** @type {(...all: any[]) => any} */
let remedies = () => [];
let resting = 0;
let said = "";

// Sets the time limit of a search, s. `more` returns the buttons for a fault: [text, action].
export function load(seconds, more) {
  longest = seconds;
  remedies = more;
}

export function render(v) {
  const refused = versions.refused(v);
  $("design").classList.toggle("stale", refused);
  $("design").classList.toggle("foreign", designs.isForeign() && Boolean(v?.fault));
  $("undo").disabled = !versions.canUndo();
  $("redo").disabled = !versions.canRedo();
  say($("scene-name"), v?.name ?? "");
  const title = `${v?.name} – gaitcam studio`;
  if (v?.name && document.title !== title) document.title = title;
  faults(v);
}

// Shows faults after a pause and hides them at once.
function faults(v) {
  clearTimeout(resting);
  const own = v?.fault ? [v.fault] : [];
  const list = [...own, ...(v?.pending ?? []).map((p) => p.fault).filter(Boolean)];
  const seen = JSON.stringify([list, language()]);
  hide($("fault"), list.length === 0 || seen !== said);
  if (list.length === 0) said = "";
  else if (seen !== said) {
    resting = setTimeout(() => {
      said = seen;
      draw(list.map(line), $("fault"));
      hide($("fault"), false);
    }, REST);
  }
}

const button = ([text, action]) => html`<button type="button" @click=${action}>${text}</button>`;

function line(fault) {
  const broken = { broken: "studio-broken", silent: "studio-silent" }[fault.code];
  const message = broken ? t(broken, { fault: fault.message }) : fault.message;
  const isOfFile = fault.key === "gait.file" || /(cannot-read|not-dropped)$/.test(fault.code);
  const toForce = [t("studio-to-force"), () => view.tab("force")];
  return html`<div>
    <p>${fault.place ? html`<strong>${fault.place}: </strong>` : nothing}${message}${
      fault.help ? html`<span class="help"> – ${fault.help}</span>` : nothing}</p>
    ${[...remedies(fault), ...isOfFile ? [toForce] : []].map(button)}
  </div>`;
}

// Shows a notice that the engine does not respond.
export function lost(error) {
  notice(t(error.code === "http" ? "studio-refused" : "studio-lost"), true);
}

let waiting = 0;
export function working(on, since) {
  clearInterval(waiting);
  $("design").setAttribute("aria-busy", String(on));
  if (!on) {
    $("design").classList.remove("busy");
    hide($("working"));
    return;
  }
  waiting = setInterval(() => {
    const passed = performance.now() - since;
    if (passed < PATIENCE) return;
    $("design").classList.add("busy");
    hide($("working"), false);
    Object.assign($("working-share"), { max: longest, value: passed / 1000 });
    $("working-time").textContent = t("studio-working", { seconds: number(passed / 1000, 2), longest });
  }, 60);
}
