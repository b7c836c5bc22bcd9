// Scenes of the opened folder, scenes in the browser, and links. A scene is saved under an unused name or as a download.

import { html, nothing, notice } from "../core/dom.js";
import { t } from "../core/words.js";
import { engine } from "../core/net.js";
import { closeDialog, sheet } from "../core/view.js";
import { unpack } from "../core/packing.js";
import * as autosave from "../core/autosave.js";
import * as blobs from "../core/blobs.js";
import * as versions from "../core/versions.js";
import { label } from "../panels/names.js";
import { download } from "./exports.js";

let folder = "";

export function load(start) {
  folder = start.folder;
}

const said = (error) => [error.place, error.message, error.help].filter(Boolean).join(" – ") || t("studio-lost");

export async function open(openScene) {
  let list = [];
  try {
    list = engine.folder ? await engine.folder.list() : [];
  } catch (error) {
    notice(said(error), true);
  }
  const take = (scene, more) => {
    closeDialog();
    openScene(scene, more);
  };
  const scenes = list.filter((file) => file.scene);
  sheet("studio-open", "files", () => html`${engine.folder ? ofFolder(scenes, take) : nothing}${ofMachine(take)}${ofLink(take)}${lastScene(take)}`);
}

function ofFolder(scenes, take) {
  const get = async (path) => {
    try {
      take((await engine.folder.open(path)).scene);
    } catch (error) {
      notice(said(error));
    }
  };
  const entry = ({ path }) => html`<li><button type="button" class="plain" @click=${() => get(path)}>${path}</button></li>`;
  return html`<p class="lead">${t("studio-open-lead", { folder })}</p>
    ${scenes.length === 0 ? html`<p>${t("studio-open-none")}</p>` : html`<ul>${scenes.map(entry)}</ul>`}`;
}

function ofMachine(take) {
  const get = async ({ target }) => {
    if (target.files[0]) take(await target.files[0].text());
  };
  return html`<p><label class="pick" for="open-pick">${t("studio-open-pick")}</label>
    <input type="file" id="open-pick" accept=".toml" @change=${get}></p>`;
}

function ofLink(take) {
  const get = async (event) => {
    event.preventDefault();
    const held = await unpack(String(new FormData(event.target).get("link")).trim());
    if (held) take(held.scene, held);
    else notice(t("studio-open-no-link"));
  };
  return html`<form @submit=${get}><label for="open-link">${t("studio-open-link")}</label>
    <input type="text" id="open-link" name="link" autocomplete="off" placeholder="#s=…"><button type="submit">${t("studio-open")}</button></form>`;
}

function lastScene(take) {
  const last = autosave.last();
  if (!last) return nothing;
  const get = async () => {
    const held = await unpack(`s=${last.packed}`);
    if (held) take(held.scene, held);
    else notice(t("studio-open-no-link"));
  };
  return html`<p><button type="button" id="open-last" class="plain" @click=${get}>${t("studio-open-last", { name: last.name })}</button></p>`;
}

const ENDING = ".toml";
const named = (text) => `${(text ?? "").trim().replace(/\.toml$/, "") || "scene"}${ENDING}`;

const file = (v) => new Blob([v.scene], { type: "application/toml" });

// Reason why the present version is not saved as displayed; null if it is.
function unsaved(v) {
  if (v.pending.length === 0) return null;
  const refused = v.pending.filter((p) => p.fault).flatMap((p) => p.keys.map(label));
  return refused.length > 0 ? t("studio-save-refused", { name: refused.join(", ") }) : t("studio-not-designed");
}

// Saves the displayed version. A version with pending or rejected values is not saved.
export function save() {
  if (!versions.now()) return;
  let out = "";
  let typed = named(versions.now().name);
  const get = () => {
    download(file(versions.now()), named(typed));
    return named(typed);
  };
  const write = async () => {
    const v = versions.now();
    if (!engine.folder) return get();
    const saved = await engine.folder.save({ scene: v.scene, files: blobs.listed(v.files), name: typed });
    return saved.written.join(", ");
  };
  const submit = async (event) => {
    event.preventDefault();
    try {
      out = unsaved(versions.now()) ?? t("studio-saved", { files: await write() });
    } catch (error) {
      out = said(error);
    }
    refresh();
  };
  const form = (v) => html`${v.fault ? html`<p class="fair">${t("studio-save-faulty", { name: v.name })}</p>` : nothing}
    ${engine.folder ? html`<p class="lead">${t("studio-save-lead", { folder })}</p>` : nothing}
    <form @submit=${submit}><label for="save-name">${t("studio-save-name")}</label>
      <input type="text" id="save-name" .value=${typed} @input=${(event) => { typed = event.target.value; refresh(); }}>
      <button type="submit" class="main">${t("studio-save-do")}</button></form><p role="status">${out}</p>
    ${engine.folder ? html`<p><button type="button" class="plain" @click=${get}>${t("studio-save-download", { name: named(typed) })}</button></p>` : nothing}`;
  const refresh = sheet("studio-save", "files", () => {
    const v = versions.now();
    const why = unsaved(v);
    return why ? html`<p class="bad" id="save-refused">${why}</p>` : form(v);
  });
  const name = /** @type {HTMLInputElement} */ (document.getElementById("save-name"));
  name?.focus();
  name?.setSelectionRange(0, name.value.length - ENDING.length);
}
