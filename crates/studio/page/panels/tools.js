// The buttons of the header.

import { $, notice } from "../core/dom.js";
import { t, language, choose, onLanguage } from "../core/words.js";
import * as versions from "../core/versions.js";
import * as designs from "../core/designs.js";
import * as autosave from "../core/autosave.js";
import * as gallery from "./gallery.js";
import * as exports from "./exports.js";
import * as files from "./files.js";
import * as compare from "./compare.js";

export function load({ start, move, openScene }) {
  $("undo").addEventListener("click", () => move(versions.undo));
  $("redo").addEventListener("click", () => move(versions.redo));
  $("cancel").addEventListener("click", designs.cancel);
  $("pin").addEventListener("click", pin);
  $("open-scenes").addEventListener("click", () => gallery.open(start.scenes, openScene));
  $("open-files").addEventListener("click", () => files.open(openScene));
  $("open-save").addEventListener("click", files.save);
  $("open-export").addEventListener("click", exports.open);
  $("link").addEventListener("click", copy);
  $("language").addEventListener("click", () => choose(language() === "en" ? "es" : "en"));
  const name = () => { $("language").textContent = language() === "en" ? "ES" : "EN"; };
  onLanguage(name);
  name();
  document.querySelector(".skip").addEventListener("click", (event) => {
    event.preventDefault();
    $("verdict").focus();
  });
  $("notice-close").addEventListener("click", () => notice(""));
  welcome();
}

function pin() {
  if (!designs.isCurrent()) {
    notice(t("studio-not-designed"));
    return;
  }
  compare.pin();
  notice(t("studio-pinned"));
}

async function copy() {
  const { text, shortened, own } = await autosave.link();
  try {
    await navigator.clipboard.writeText(text);
    notice([t(own ? "studio-linked-part" : "studio-linked"), shortened ? t("studio-linked-cycle", { file: shortened }) : ""].filter(Boolean).join(" "));
  } catch {
    notice(t("studio-linked-address"));
  }
}

function welcome() {
  let seen = false;
  try { seen = localStorage.getItem("gaitcam-seen") === "1"; } catch { /* private windows keep nothing */ }
  $("welcome").hidden = seen;
  $("welcome-close").addEventListener("click", () => {
    $("welcome").hidden = true;
    try { localStorage.setItem("gaitcam-seen", "1"); } catch { /* as above */ }
  });
}
