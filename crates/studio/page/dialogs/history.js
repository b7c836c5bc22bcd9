// The versions of the scene, newest first: a click goes back to one.

import { make } from "../core/dom.js";
import { t } from "../core/words.js";
import * as versions from "../core/versions.js";
import { dialog, closeDialog } from "../core/view.js";

const LISTED = 100;

export function open(move) {
  dialog("studio-versions", (body) => {
    body.className = "history";
    const { list, at } = versions.history();
    const entries = list.map((v, i) => [v, i]).slice(-LISTED).reverse();
    body.append(make("p", { class: "lead" }, t("studio-versions-lead")), make("ol", {}, ...entries.map(([v, i]) => entry(v, i, i === at, move))));
  });
}

function entry(v, i, present, move) {
  const values = v.made.map(({ key, value }) => `${key} = ${value || "–"}`).join(", ");
  const text = [v.title || v.name || t("studio-versions-opened"), values].filter(Boolean).join(": ");
  return make("li", {}, make("button", { type: "button", class: "plain", "aria-current": present ? "true" : null, "data-version": i,
    onclick: () => { closeDialog(); move(() => versions.goTo(i)); } }, text), versions.refused(v) ? make("span", { class: "bad" }, " –") : null);
}
