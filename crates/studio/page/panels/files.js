// Scenes of the opened folder: opened, and saved under a name that is free.

import { make, notice } from "../core/dom.js";
import { t } from "../core/words.js";
import { get, post } from "../core/net.js";
import { dialog, closeDialog } from "../core/view.js";
import { state } from "../core/store.js";

let folder = "";

export function load(start) {
  folder = start.folder;
}

export async function open(openScene) {
  const list = await get("folder.json");
  dialog("studio-open", (body) => {
    body.className = "files";
    body.append(make("p", { class: "lead" }, t("studio-open-lead", { folder })));
    const scenes = list.filter((f) => f.scene);
    if (scenes.length === 0) body.append(make("p", {}, t("studio-open-none")));
    body.append(make("ul", {}, ...scenes.map(({ path }) => make("li", {}, make("button", { type: "button", class: "plain", onclick: async () => {
      try {
        const file = await get(`folder/${path.split("/").map(encodeURIComponent).join("/")}`);
        closeDialog();
        openScene(file.scene);
      } catch (error) {
        notice(error.message);
      }
    } }, path)))));
  });
}

export function save(answer) {
  if (!answer) return;
  dialog("studio-save", (body) => {
    body.className = "files";
    const name = make("input", { type: "text", id: "save-name", value: `${answer.name}.toml` });
    const out = make("p", { role: "status" });
    const form = make("form", { onsubmit: async (event) => {
      event.preventDefault();
      try {
        const saved = await post("save", { scene: state.scene, name: name.value });
        out.textContent = t("studio-saved", { files: saved.written.join(", ") });
      } catch (error) {
        out.textContent = error.help ? `${error.message}; ${error.help}` : error.message;
      }
    } }, make("label", { for: "save-name" }, t("studio-save-name")), name, make("button", { type: "submit", class: "main" }, t("studio-save-do")));
    body.append(make("p", { class: "lead" }, t("studio-save-lead", { folder })), form, out);
    name.focus();
    name.setSelectionRange(0, answer.name.length);
  });
}
