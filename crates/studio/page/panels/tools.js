// The buttons of the header.

import { $, notice } from "../core/dom.js";
import { t, language, choose, onLanguage } from "../core/words.js";
import * as versions from "../core/versions.js";
import * as designs from "../core/designs.js";
import * as units from "../core/units.js";
import { embedded } from "../core/view.js";
import * as gallery from "../dialogs/gallery.js";
import * as exports from "../dialogs/exports.js";
import * as files from "../dialogs/files.js";
import * as exercise from "../dialogs/exercise.js";
import * as history from "../dialogs/history.js";
import * as share from "../dialogs/share.js";
import * as compare from "./compare.js";
import * as charts from "../charts/charts.js";

export function load({ start, move, openScene }) {
  $("undo").addEventListener("click", () => move(versions.undo));
  $("redo").addEventListener("click", () => move(versions.redo));
  $("versions").addEventListener("click", () => history.open(move));
  $("cancel").addEventListener("click", designs.cancel);
  $("pin").addEventListener("click", pin);
  $("open-scenes").addEventListener("click", () => gallery.open(start.scenes, openScene));
  $("open-files").addEventListener("click", () => files.open(openScene));
  $("open-save").addEventListener("click", files.save);
  $("open-export").addEventListener("click", exports.open);
  $("link").addEventListener("click", share.open);
  $("language").addEventListener("click", () => choose(language() === "en" ? "es" : "en"));
  const name = () => {
    const other = language() === "en" ? "ES" : "EN";
    $("language").textContent = other;
    // The label starts with the visible text.
    $("language").setAttribute("aria-label", `${other} – ${t("studio-language")}`);
  };
  onLanguage(name);
  name();
  document.querySelector(".skip").addEventListener("click", (event) => {
    event.preventDefault();
    $("verdict").focus();
  });
  $("choose-diagrams").addEventListener("click", charts.choose);
  $("show-table").addEventListener("click", charts.table);
  $("show-exercise").addEventListener("click", exercise.open);
  presenting();
  for (const id of ["units", "speeds"]) {
    const select = $(id);
    const [plain, other] = [...select.options].map((o) => o.value);
    if (units.names().split(" ").includes(other)) select.value = other;
    select.addEventListener("change", () => units.choose(select.value, select.value === plain ? other : plain));
  }
  phone();
  if (embedded) frame();
  $("notice-close").addEventListener("click", () => notice(""));
  welcome();
}

// Presentation mode: large text, one diagram and the cam. The arrow keys select the diagram, and Escape ends the mode.
function presenting() {
  const set = (on) => {
    document.documentElement.toggleAttribute("data-presenting", on);
    $("present").setAttribute("aria-pressed", String(on));
    if (on) document.documentElement.requestFullscreen?.().catch(() => {});
    else if (document.fullscreenElement) document.exitFullscreen();
  };
  const isOn = () => document.documentElement.hasAttribute("data-presenting");
  $("present").addEventListener("click", () => set(!isOn()));
  document.addEventListener("fullscreenchange", () => { if (!document.fullscreenElement && isOn()) set(false); });
  document.addEventListener("keydown", (event) => {
    if (!isOn() || /** @type {Element} */ (event.target).closest("input, select, textarea, dialog, .stage, .chart svg")) return;
    const by = { PageDown: 1, ArrowRight: 1, PageUp: -1, ArrowLeft: -1 }[event.key];
    if (by) charts.step(by);
    else if (event.key === "Escape") set(false);
  });
}

function pin() {
  if (!designs.isCurrent()) {
    notice(t("studio-not-designed"));
    return;
  }
  compare.pin();
  notice(t("studio-pinned"));
}

// On a phone, the header has one row. A button shows its other parts.
function phone() {
  const show = (on) => {
    $("tools").toggleAttribute("data-open", on);
    $("more").setAttribute("aria-expanded", String(on));
  };
  $("more").addEventListener("click", () => show(!$("tools").hasAttribute("data-open")));
  for (const button of $("tools").querySelectorAll(".rest")) button.addEventListener("click", () => show(false));
}

// Link from a frame to the whole page with the present scene.
function frame() {
  const whole = /** @type {HTMLAnchorElement} */ ($("whole"));
  const aim = () => {
    const address = new URL(location.href);
    address.searchParams.delete("embed");
    whole.href = address.href;
  };
  aim();
  for (const event of ["pointerdown", "focus"]) whole.addEventListener(event, aim);
}

function welcome() {
  let seen = false;
  try { seen = localStorage.getItem("gaitcam-seen") === "1"; } catch { /* A private window stores nothing. */ }
  $("welcome").hidden = seen;
  $("welcome-close").addEventListener("click", welcomed);
}

// Hides the welcome text after the first change of a value.
export function welcomed() {
  if ($("welcome").hidden) return;
  $("welcome").hidden = true;
  try { localStorage.setItem("gaitcam-seen", "1"); } catch { /* as above */ }
}
