// The wanted force: recordings dropped on the page, with their contacts.

import { $, make, clear, notice } from "../core/dom.js";
import { t, number, onLanguage } from "../core/words.js";
import { post, send, get } from "../core/net.js";
import { addCycle, addFile } from "../core/store.js";
import { onTab, openTab, tab } from "../core/view.js";
import * as hand from "./hand.js";

let edit = () => {};
let openScene = () => {};
let recording = null;
let without = new Set();
let folderFiles = [];

export function load(onEdit, onScene) {
  edit = onEdit;
  openScene = onScene;
  hand.load(onEdit);
  drops();
  onTab("force", async () => {
    try {
      folderFiles = (await get("folder.json")).filter((f) => !f.scene);
    } catch {
      folderFiles = [];
    }
    build();
  });
  onLanguage(() => { if (openTab() === "force") build(); });
}

export function show(answer) {
  hand.show(answer);
}

// --- dropping ------------------------------------------------------------------------------------

function drops() {
  const page = document.body;
  let depth = 0;
  const files = (event) => [...event.dataTransfer.types].includes("Files");
  page.addEventListener("dragenter", (event) => { if (files(event)) { depth += 1; $("drop").hidden = false; event.preventDefault(); } });
  page.addEventListener("dragover", (event) => { if (files(event)) event.preventDefault(); });
  page.addEventListener("dragleave", (event) => { if (files(event)) { depth -= 1; if (depth <= 0) { depth = 0; $("drop").hidden = true; } } });
  page.addEventListener("drop", (event) => {
    if (!files(event)) return;
    event.preventDefault();
    depth = 0;
    $("drop").hidden = true;
    const [file] = event.dataTransfer.files;
    if (file) take(file);
  });
}

async function take(file) {
  tab("force");
  if (file.size > 64 * 2 ** 20) {
    notice(t("studio-too-large"));
    return;
  }
  if (/\.toml$/i.test(file.name)) {
    openScene(await file.text());
    return;
  }
  try {
    recording = await send(`recording?name=${encodeURIComponent(file.name)}`, file);
    without = new Set();
    // A link holds the recording; of a large or binary one the mean cycle, unless something about it is open.
    if (file.size < 60000 && !/\.c3d$/i.test(file.name)) addFile(recording.file, await file.text());
    else if (recording.csv && !recording.doubts?.length) addCycle(recording.file, recording.csv);
    use(recording.use);
  } catch (error) {
    recording = null;
    notice([error.place, error.message, error.help].filter(Boolean).join(" – ") || t("studio-lost"), true);
  }
  build();
}

async function fromFolder(path) {
  try {
    recording = await post("contacts", { file: path });
    without = new Set();
    use(path);
  } catch (error) {
    notice([error.place, error.message, error.help].filter(Boolean).join(" – "), true);
  }
  build();
}

function use(name) {
  edit([{ set: { key: "gait.file", value: name } }]);
}

// --- the panel -----------------------------------------------------------------------------------

function build() {
  const root = clear($("force"));
  const pick = make("input", { type: "file", id: "pick-file", accept: ".c3d,.mot,.sto,.csv,.txt,.tsv,.asc,.toml", onchange: () => { if (pick.files[0]) take(pick.files[0]); } });
  root.append(make("h2", {}, t("studio-force-recording")), make("p", { class: "lead" }, t("studio-force-lead")),
    make("label", { class: "pick", for: "pick-file" }, t("studio-force-pick")), pick);
  if (folderFiles.length > 0) {
    const select = make("select", { id: "folder-recording", onchange: () => { if (select.value) fromFolder(select.value); } },
      make("option", { value: "" }, t("studio-force-folder")), ...folderFiles.map(({ path }) => make("option", { value: path }, path)));
    root.append(make("label", { class: "stack", for: "folder-recording" }, t("studio-force-folder-label")), select);
  }
  if (recording) root.append(found());
  root.append(make("h2", {}, t("studio-force-hand")), make("p", { class: "lead" }, t("studio-force-hand-lead")));
  root.append(hand.section(build));
}

function found() {
  const box = make("div", { class: "found" });
  box.append(make("h3", {}, recording.file));
  if (recording.picture) {
    const figure = make("figure", {});
    figure.innerHTML = recording.picture;
    box.append(figure);
  }
  if (recording.stances?.length > 0) box.append(contacts());
  box.append(make("details", {}, make("summary", {}, t("studio-force-details")), make("pre", { tabindex: "0" }, recording.table)));
  return box;
}

function contacts() {
  const rows = recording.stances.map((s, i) => {
    const tick = make("input", { type: "checkbox", id: `contact-${i}`, checked: !without.has(i), onchange: () => {
      if (tick.checked) without.delete(i);
      else without.add(i);
      again();
    } });
    return make("tr", {}, make("td", {}, tick), make("th", { scope: "row" }, make("label", { for: `contact-${i}` }, `${i + 1} ${s.foot ? t(`studio-foot-${s.foot}`) : ""}`)),
      make("td", {}, `${number(s.start_s, 4)}–${number(s.end_s, 4)} s`), make("td", {}, `${number(s.p1_n, 4)} N`));
  });
  return make("div", { class: "scroll short", tabindex: "0" }, make("table", {}, make("caption", {}, t("studio-contacts")), make("tbody", {}, ...rows)));
}

async function again() {
  try {
    recording = { ...recording, ...await post("contacts", { file: recording.file, without: [...without] }) };
    if (recording.csv && recording.use !== recording.file) addFile(recording.use, recording.csv);
    use(recording.use);
  } catch (error) {
    notice(error.message);
  }
  build();
}
