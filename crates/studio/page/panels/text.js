// The scene file as text.

import { $, html, live, render as draw } from "../core/dom.js";
import { t } from "../core/words.js";
import { onTab, openTab } from "../core/view.js";
import * as versions from "../core/versions.js";

/** @type {(...all: any[]) => any} */
let openScene = () => {};
// Typed text that is not applied yet; null if the text is that of the scene.
let typed = null;

export function load(open) {
  openScene = open;
  onTab("text", () => show(versions.now()));
}

export function render(version, { moving }) {
  if (!moving && openTab() === "text") show(version);
}

function apply() {
  const scene = typed ?? versions.now()?.scene ?? "";
  typed = null;
  openScene(scene);
}

function show(version) {
  draw(html`
    <p class="lead">${t("studio-text-lead")}</p>
    <textarea id="scene-text" spellcheck="false" rows="30" aria-label=${t("studio-text-label")}
      .value=${live(typed ?? version?.scene ?? "")}
      @input=${(event) => { typed = event.target.value; }}></textarea>
    <button type="button" class="main" @click=${apply}>${t("studio-text-apply")}</button>`, $("text"));
}
