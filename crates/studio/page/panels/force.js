// The wanted force: recordings dropped on the page, with their contacts.

import { $, make, clear, notice } from "../core/dom.js";
import { t, number, onLanguage } from "../core/words.js";
import { engine } from "../core/net.js";
import * as blobs from "../core/blobs.js";
import * as versions from "../core/versions.js";
import { dialog, embedded, enlarging, onTab, openTab, tab } from "../core/view.js";
import { label, focus } from "./form.js";
import * as hand from "./hand.js";

const LARGEST = 64 * 2 ** 20;
// Most columns that are offered as buttons.
const MOST = 12;
let edit = () => {};
let openScene = () => {};
// What the recording of the version holds, and the key of that version's recording.
let found = null;
let seen = null;
let folderFiles = [];
// The recordings of this visit, by their names.
const read = new Map();

export function load(onEdit, onScene) {
  edit = onEdit;
  openScene = onScene;
  hand.load(onEdit);
  if (!embedded) drops();
  onTab("force", async () => {
    try {
      folderFiles = engine.folder ? (await engine.folder.list()).filter((f) => !f.scene) : [];
    } catch {
      folderFiles = [];
    }
    build();
  });
  onLanguage(() => { if (openTab() === "force") build(); });
}

// Follows the version: undo brings the recording and its ticks back.
export function render(version, { answer }) {
  const changed = hand.show(answer ?? undefined);
  const recording = versions.now()?.recording ?? null;
  const key = recording && JSON.stringify([recording.file, recording.without, versions.now().files[recording.file]]);
  if (key !== seen) follow(recording, key);
  if (changed && openTab() === "force") build();
}

async function follow(recording, key) {
  seen = key;
  if (recording && found?.key !== key) {
    try {
      found = { ...await described(recording, versions.now().files[recording.file]), key };
    } catch {
      found = null;
    }
  }
  if (!recording) found = null;
  if (seen === key && openTab() === "force") build();
}

async function described({ file, without }, hash) {
  // After a reload the engine may not have it yet.
  await blobs.get(hash);
  return without.length > 0 ? engine.ask("contacts", { file, hash, without }) : engine.ask("recording", { file, hash });
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
    const [file, ...others] = event.dataTransfer.files;
    if (others.length > 0) notice(t("studio-one-file", { file: file.name }));
    if (file) take(file);
  });
}

const said = (error) => [error.place, error.message, error.help].filter(Boolean).join(" – ") || t("studio-lost");

async function take(file) {
  if (/\.toml$/i.test(file.name)) {
    openScene(await file.text());
    return;
  }
  tab("force");
  if (file.size > LARGEST) {
    notice(t("studio-too-large"));
    return;
  }
  if (file.size > 2 ** 20) notice(t("studio-reading", { file: file.name }), true);
  const hash = await blobs.put(file);
  await use(file.name, hash);
}

async function fromFolder(path) {
  try {
    const { name, hash } = await engine.folder.read(path);
    await use(name, hash);
  } catch (error) {
    notice(said(error));
  }
}

// The recording becomes the scene's force; of one that the reader refuses the scene says why and what can be chosen.
async function use(file, hash) {
  const recording = { file, without: [] };
  const key = JSON.stringify([file, [], hash]);
  try {
    found = { ...await engine.ask("recording", { file, hash }), key };
    // A link holds the recording; of a large or binary one the mean cycle, unless something about it is open.
    if (found.csv && !found.doubts?.length) blobs.addCycle(hash, found.csv);
    notice("");
  } catch (error) {
    found = null;
    if (error.code === "lost" || error.code === "http") {
      notice(t("studio-lost"), true);
      return;
    }
  }
  seen = key;
  edit([{ set: { key: "gait.file", value: file } }], null, { files: { [file]: hash }, recording, hand: null, title: file });
  build();
}

// What can be done about a fault of a recording: buttons with the value that the reader asks for, and ways to the
// fields that it names without one.
export function remedies(fault) {
  const text = `${fault.message} ${fault.help ?? ""}`;
  const given = [...text.matchAll(/\b(?:gait\.)?(kind|feet|period|accept|unit|force|time|span) = "([^"]+)"/g), ...(fault.columns ?? []).slice(0, MOST).map((column) => [column, "force", column])];
  const out = given.map(([, name, value]) => [`${label(`gait.${name}`)}: ${value}`, () => edit([{ set: { key: `gait.${name}`, value } }], null, { title: label(`gait.${name}`) })]);
  const named = [...text.matchAll(/\b(?:gait\.|option |opción )(kind|feet|period|accept|unit|force|time|span|rate|mass)\b(?! = ")/g)].map(([, name]) => name);
  for (const name of new Set(named)) out.push([`${label(`gait.${name}`)} …`, () => focus(`gait.${name}`)]);
  return out;
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
  if (found) {
    read.set(found.file, found);
    root.append(panel(found));
    if (read.size > 1) root.append(make("button", { type: "button", id: "side-by-side", onclick: sides }, t("studio-force-sides")));
  }
  root.append(make("h2", {}, t("studio-force-hand")), make("p", { class: "lead" }, t("studio-force-hand-lead")));
  root.append(hand.section(build));
}

// What a recording holds; of the scene's own the contacts can be chosen, beside another one all is open.
function panel(shown, isBeside = false) {
  const box = make("div", { class: "found" });
  box.append(make("h3", {}, shown.file));
  if (shown.picture) {
    box.append(isBeside ? figure(shown.picture) : enlarging(shown.picture, "studio-force-recording"));
  }
  if (!isBeside && shown.stances?.length > 0) box.append(contacts());
  box.append(make("details", { open: isBeside }, make("summary", {}, t("studio-force-details")), make("pre", { tabindex: "0" }, shown.table)));
  return box;
}

function figure(picture) {
  const box = make("figure", {});
  box.innerHTML = picture;
  return box;
}

// Two recordings of this visit side by side: the present one and one that is chosen.
function sides() {
  const others = [...read.values()].filter((r) => r.file !== found.file).reverse();
  dialog("studio-force-sides", (body) => {
    body.className = "sides";
    const right = make("div", {});
    const choose = make("select", { id: "other-recording", "aria-label": t("studio-force-other"), onchange: () => clear(right).append(panel(others[choose.selectedIndex], true)) },
      ...others.map((r) => make("option", {}, r.file)));
    right.append(panel(others[0], true));
    body.append(panel(found, true), make("div", {}, others.length > 1 ? choose : null, right));
  });
}

function contacts() {
  const without = new Set(versions.now().recording?.without ?? []);
  const rows = found.stances.map((s, i) => {
    const tick = make("input", { type: "checkbox", id: `contact-${i}`, checked: !without.has(i), onchange: () => {
      if (tick.checked) without.delete(i);
      else without.add(i);
      leaveOut([...without].sort((a, b) => a - b));
    } });
    return make("tr", {}, make("td", {}, tick), make("th", { scope: "row" }, make("label", { for: `contact-${i}` }, `${i + 1} ${s.foot ? t(`studio-foot-${s.foot}`) : ""}`)),
      make("td", {}, `${number(s.start_s, 4)}–${number(s.end_s, 4)} s`), make("td", {}, `${number(s.p1_n, 4)} N`));
  });
  return make("div", { class: "scroll short", tabindex: "0" }, make("table", {}, make("caption", {}, t("studio-contacts")), make("tbody", {}, ...rows)));
}

// The mean cycle of the contacts that stay is a file of its own, which the scene names.
async function leaveOut(without) {
  const { file } = versions.now().recording;
  const hash = versions.now().files[file];
  const key = JSON.stringify([file, without, hash]);
  try {
    found = { ...await described({ file, without }, hash), key };
    seen = key;
    const files = { [found.use]: found.use_hash ?? hash };
    if (found.csv && found.use !== file) files[found.use] = await blobs.put(new TextEncoder().encode(found.csv));
    edit([{ set: { key: "gait.file", value: found.use } }], null, { files, recording: { file, without }, title: t("studio-contacts") });
  } catch (error) {
    notice(said(error));
  }
  build();
}
