// Scenes of the opened folder, scenes of this machine, links; saved under a name that is free, or as a download.

import { make, notice } from "../core/dom.js";
import { t } from "../core/words.js";
import { engine } from "../core/net.js";
import { dialog, closeDialog } from "../core/view.js";
import { unpack } from "../core/packing.js";
import * as autosave from "../core/autosave.js";
import * as blobs from "../core/blobs.js";
import * as versions from "../core/versions.js";

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
  const take = (scene, more) => { closeDialog(); openScene(scene, more); };
  dialog("studio-open", (body) => {
    body.className = "files";
    if (engine.folder) body.append(...ofFolder(list.filter((f) => f.scene), take));
    body.append(ofMachine(take), ofLink(take));
    const last = autosave.last();
    if (last) {
      body.append(make("p", {}, make("button", { type: "button", id: "open-last", class: "plain", onclick: async () => {
        const held = await unpack(`s=${last.packed}`);
        if (held) take(held.scene, held);
      } }, t("studio-open-last", { name: last.name }))));
    }
  });
}

function ofFolder(scenes, take) {
  const lead = make("p", { class: "lead" }, t("studio-open-lead", { folder }));
  if (scenes.length === 0) return [lead, make("p", {}, t("studio-open-none"))];
  const entry = ({ path }) => make("li", {}, make("button", { type: "button", class: "plain", onclick: async () => {
    try {
      const file = await engine.folder.open(path);
      take(file.scene);
    } catch (error) {
      notice(said(error));
    }
  } }, path));
  return [lead, make("ul", {}, ...scenes.map(entry))];
}

function ofMachine(take) {
  const pick = make("input", { type: "file", id: "open-pick", accept: ".toml", onchange: async () => { if (pick.files[0]) take(await pick.files[0].text()); } });
  return make("p", {}, make("label", { class: "pick", for: "open-pick" }, t("studio-open-pick")), pick);
}

function ofLink(take) {
  const field = make("input", { type: "text", id: "open-link", autocomplete: "off", placeholder: "#s=…" });
  return make("form", { onsubmit: async (event) => {
    event.preventDefault();
    const held = await unpack(field.value.trim());
    if (held) take(held.scene, held);
    else notice(t("studio-open-no-link"));
  } }, make("label", { for: "open-link" }, t("studio-open-link")), field, make("button", { type: "submit" }, t("studio-open")));
}

// Saves the version that is shown; one with a refused value is not saved as if it had none.
export function save() {
  const v = versions.now();
  if (!v) return;
  dialog("studio-save", (body) => {
    body.className = "files";
    const refused = v.pending.filter((p) => p.fault).flatMap((p) => p.keys);
    if (v.pending.length > 0) {
      body.append(make("p", { class: "bad", id: "save-refused" }, t(refused.length > 0 ? "studio-save-refused" : "studio-not-designed", { name: refused.join(", ") })));
      return;
    }
    if (v.fault) body.append(make("p", { class: "fair" }, t("studio-save-faulty", { name: v.name })));
    const name = make("input", { type: "text", id: "save-name", value: named(v.name) });
    const out = make("p", { role: "status" });
    const write = async () => {
      if (!engine.folder) return download(v, name.value);
      const saved = await engine.folder.save({ scene: v.scene, files: blobs.listed(v.files), name: name.value });
      return saved.written.join(", ");
    };
    const form = make("form", { onsubmit: async (event) => {
      event.preventDefault();
      try {
        out.textContent = t("studio-saved", { files: await write() });
      } catch (error) {
        out.textContent = said(error);
      }
    } }, make("label", { for: "save-name" }, t("studio-save-name")), name, make("button", { type: "submit", class: "main" }, t("studio-save-do")));
    if (engine.folder) body.append(make("p", { class: "lead" }, t("studio-save-lead", { folder })));
    body.append(form, out);
    if (engine.folder) body.append(make("p", {}, make("button", { type: "button", class: "plain", onclick: () => download(v, name.value) }, t("studio-save-download", { name: named(v.name) }))));
    name.focus();
    name.setSelectionRange(0, name.value.length - ENDING.length);
  });
}

const ENDING = ".toml";
const named = (text) => `${(text ?? "").trim().replace(/\.toml$/, "") || "scene"}${ENDING}`;

// Hands the scene to the browser as a file; its name.
function download(v, name) {
  const a = make("a", { href: URL.createObjectURL(new Blob([v.scene], { type: "application/toml" })), download: named(name) });
  a.click();
  setTimeout(() => URL.revokeObjectURL(a.href), 2000);
  return a.download;
}
