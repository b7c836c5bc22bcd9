// Theme, tabs and dialog.

import { $, above, html, make, picture as drawn, render } from "./dom.js";
import { t, onLanguage } from "./words.js";

const TABS = ["values", "force", "programme", "compare", "text"];
const opened = new Map();

// In a frame of another page (`?embed=force,s`): the cam and these diagrams, without controls.
export const embedded = new URLSearchParams(location.search).get("embed")?.split(",") ?? null;

export function theme() {
  let dark = window.matchMedia("(prefers-color-scheme: dark)").matches;
  try {
    const kept = localStorage.getItem("gaitcam-theme");
    if (kept) dark = kept === "dark";
  } catch { /* A private window stores nothing. */ }
  const show = () => { document.documentElement.dataset.theme = dark ? "dark" : "light"; };
  show();
  $("theme").addEventListener("click", () => {
    dark = !dark;
    try { localStorage.setItem("gaitcam-theme", dark ? "dark" : "light"); } catch { /* as above */ }
    show();
  });
}

export function onTab(name, listener) {
  opened.set(name, listener);
}

export function tab(name) {
  for (const other of TABS) {
    const on = other === name;
    $(other).hidden = !on;
    $(`tab-${other}`).setAttribute("aria-selected", String(on));
    $(`tab-${other}`).tabIndex = on ? 0 : -1;
  }
  $("panel").dataset.tab = name;
  $("panel").parentElement.dataset.tab = name;
  opened.get(name)?.();
}

export function openTab() {
  return $("panel").dataset.tab;
}

export function tabs() {
  for (const [i, name] of TABS.entries()) {
    const button = $(`tab-${name}`);
    button.addEventListener("click", () => tab(name));
    button.addEventListener("keydown", (event) => {
      const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
      if (!step) return;
      const next = TABS[(i + step + TABS.length) % TABS.length];
      tab(next);
      $(`tab-${next}`).focus();
    });
  }
  tab("values");
}

let filling = null;

// Opens the dialog with a title and the content that `fill` adds. A change of the language fills it again.
export function dialog(title, fill) {
  filling = () => {
    $("dialog-title").textContent = t(title);
    const body = make("div", { id: "dialog-body" });
    $("dialog-body").replaceWith(body);
    fill(body);
  };
  filling();
  const box = /** @type {HTMLDialogElement} */ ($("dialog"));
  if (!box.open) box.showModal();
  above($("notice"));
  box.scrollTop = 0;
}

// Opens the dialog with a template. Returns the function that draws it again.
export function sheet(title, className, template) {
  let box = null;
  const refresh = () => { if (box.isConnected) render(template(), box); };
  dialog(title, (body) => {
    body.className = "";
    box = make("div", { class: className });
    body.append(box);
    refresh();
  });
  return refresh;
}

// Picture that opens in the dialog when it is clicked.
export function enlarging(text, title) {
  const large = () => dialog(title, (body) => {
    render(html`<div class="scroll enlarged" tabindex="0">${drawn(text)}</div>`, body);
  });
  const box = make("div", { class: "picture" });
  render(html`${drawn(text)}<button type="button" title=${t("studio-picture-enlarge")}
    aria-label="${t("studio-picture-enlarge")}: ${t(title)}" @click=${large}></button>`, box);
  return box;
}

export function closeDialog() {
  $("dialog").close();
}

export function dialogs() {
  $("dialog-close").addEventListener("click", closeDialog);
  $("dialog").addEventListener("click", (event) => { if (event.target === $("dialog")) closeDialog(); });
  $("dialog").addEventListener("close", () => { filling = null; });
  onLanguage(() => filling?.());
}
