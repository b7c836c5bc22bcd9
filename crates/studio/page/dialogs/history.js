// Versions of the scene, newest first. A click returns to a version.

import { html, nothing } from "../core/dom.js";
import { t } from "../core/words.js";
import * as versions from "../core/versions.js";
import { closeDialog, sheet } from "../core/view.js";
import { label } from "../panels/names.js";

const LISTED = 100;

export function open(move) {
  const { list, at } = versions.history();
  const entries = list.map((v, i) => [v, i]).slice(-LISTED).reverse();
  sheet("studio-versions", "history", () => html`<p class="lead">${t("studio-versions-lead")}</p>
    <ol>${entries.map(([v, i]) => entry(v, i, i === at, move))}</ol>`);
}

function entry(v, i, present, move) {
  const values = v.made.map(({ key, value }) => `${label(key)} ${value || "–"}`).join(", ");
  const named = v.made.some(({ key }) => label(key) === v.title); // the values already contain the title
  const text = [named ? "" : v.title || v.name || t("studio-versions-opened"), values].filter(Boolean).join(": ");
  const go = () => {
    closeDialog();
    move(() => versions.goTo(i));
  };
  return html`<li><button type="button" class="plain" aria-current=${present ? "true" : nothing} data-version=${i} @click=${go}>${text}</button>
    ${versions.refused(v) ? html`<span class="bad">–</span>` : nothing}</li>`;
}
