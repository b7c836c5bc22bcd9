// What the page says about the version shown: designed, on its way, refused.

import { $, make, clear, say, hide, notice } from "./dom.js";
import { t, number } from "./words.js";
import * as versions from "./versions.js";
import * as view from "./view.js";

// A fault is said when the hand has rested so long, and a search is shown when it has lasted so long, ms.
const REST = 400;
const PATIENCE = 1000;
let longest = 60;
let remedies = () => [];
let resting = 0;
let said = "";

// `more` gives buttons for a fault: [text, action].
export function load(seconds, more) {
  longest = seconds;
  remedies = more;
}

export function render(v) {
  const refused = versions.refused(v);
  $("design").classList.toggle("stale", refused);
  $("undo").disabled = !versions.canUndo();
  $("redo").disabled = !versions.canRedo();
  say($("scene-name"), v?.name ?? "");
  const title = `${v?.name} – gaitcam studio`;
  if (v?.name && document.title !== title) document.title = title;
  faults(v);
}

function faults(v) {
  clearTimeout(resting);
  const list = [...(v?.fault ? [{ fault: v.fault }] : []), ...(v?.pending ?? []).filter((p) => p.fault)];
  const seen = JSON.stringify(list.map((p) => [p.fault, p.edits, document.documentElement.lang]));
  if (list.length === 0) {
    hide($("fault"));
    said = "";
  } else if (seen !== said) {
    resting = setTimeout(() => {
      said = seen;
      clear($("fault")).append(...list.map(line));
      $("fault").hidden = false;
    }, REST);
  }
}

function line(change) {
  const { fault } = change;
  const broken = { broken: "studio-broken", silent: "studio-silent" }[fault.code];
  const message = broken ? t(broken, { fault: fault.message }) : fault.message;
  const box = make("div", {}, make("p", {}, make("strong", {}, fault.place ? `${fault.place}: ` : ""), message,
    fault.help ? make("span", { class: "help" }, ` – ${fault.help}`) : null));
  const button = (text, action) => make("button", { type: "button", onclick: action }, text);
  for (const [text, action] of remedies(fault)) box.append(button(text, action));
  if (fault.key === "gait.file" || /(cannot-read|not-dropped)$/.test(fault.code)) box.append(button(t("studio-to-force"), () => view.tab("force")));
  return box;
}

// The engine does not answer: said once, taken back when it does.
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
