// The scene file as text.

import { $, make, clear } from "../core/dom.js";
import { t, onLanguage } from "../core/words.js";
import { onTab, openTab } from "../core/view.js";
import * as versions from "../core/versions.js";

let openScene = () => {};

export function load(open) {
  openScene = open;
  build();
  onTab("text", fill);
  onLanguage(() => { build(); fill(); });
}

function build() {
  const area = make("textarea", { id: "scene-text", spellcheck: "false", "aria-label": t("studio-text-label"), rows: 30 });
  clear($("text")).append(make("p", { class: "lead" }, t("studio-text-lead")), area,
    make("button", { type: "button", class: "main", onclick: () => openScene(area.value) }, t("studio-text-apply")));
}

function fill() {
  const area = $("scene-text");
  if (area && document.activeElement !== area) area.value = versions.now()?.scene ?? "";
}

export function render(version, { moving }) {
  if (!moving && openTab() === "text") fill();
}
