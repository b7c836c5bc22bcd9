// Target force: recordings dropped on the page, their reading options, and their contacts.

import { $, hide, html, live, notice, nothing, picture, render as draw } from "../core/dom.js";
import { t, language, number } from "../core/words.js";
import { engine } from "../core/net.js";
import * as blobs from "../core/blobs.js";
import * as designs from "../core/designs.js";
import * as versions from "../core/versions.js";
import { dialog, embedded, enlarging, onTab, openTab, tab } from "../core/view.js";
import { focus } from "./form.js";
import { choice, label } from "./names.js";
import * as answers from "../core/answers.js";
import * as hand from "./hand.js";

const LARGEST = 64 * 2 ** 20;
const LARGE = 2 ** 20;
const ENDINGS = ".c3d,.mot,.sto,.csv,.txt,.tsv,.asc,.mat,.toml";
/** @type {(...all: any[]) => any} */
let edit = () => {};
/** @type {(...all: any[]) => any} */
let openScene = () => {};
let folderFiles = [];
// Results of reading recordings, by request; null for a rejected recording.
const known = new Map();
// Recordings read since the page was opened, by their names.
const read = new Map();

export function load(onEdit, onScene) {
  edit = onEdit;
  openScene = onScene;
  hand.load(onEdit, show);
  if (!embedded) drops();
  onTab("force", listFolder);
}

async function listFolder() {
  show();
  try {
    folderFiles = engine.folder ? (await engine.folder.list()).filter((f) => !f.scene) : [];
  } catch {
    folderFiles = [];
  }
  show();
}

// Displays a version. After undo, this restores its recording, excluded contacts and answers.
export function render(version, { answer, fields }) {
  hand.follow(answer);
  answers.remember(version, fields);
  accepted(version, fields);
  find(version);
  show();
}

function show() {
  if (openTab() === "force") draw(page(versions.now()), $("force"));
}

// --- content of a recording ----------------------------------------------------------------------

// Request about the recording of a version; null if there is none, or only its mean cycle.
function question(version) {
  const { recording, files } = version ?? {};
  if (!recording || recording.cycle || !files[recording.file]) return null;
  const fields = designs.known();
  const options = recording.options ?? answers.options(fields);
  const feet = fields["gait.feet"]?.text ?? "";
  return { file: recording.file, hash: files[recording.file], without: recording.without, feet, options };
}

const keyOf = (asked) => JSON.stringify([asked, language()]);

async function find(version) {
  const asked = question(version);
  if (!asked || known.has(keyOf(asked))) return;
  const key = keyOf(asked);
  known.set(key, null);
  try {
    // After a reload, the engine may not have the file yet.
    await blobs.get(asked.hash);
    const found = await engine.ask("contacts", asked);
    known.set(key, found);
    read.set(found.file, found);
  } catch (error) {
    // The request is repeated later if the engine did not respond.
    if (error.code === "lost" || error.code === "http") known.delete(key);
  }
  show();
}

function foundIn(version) {
  const asked = question(version);
  return asked ? known.get(keyOf(asked)) ?? null : null;
}

// --- dropping ------------------------------------------------------------------------------------

function drops() {
  const page_ = document.body;
  let depth = 0;
  const over = (event, by) => {
    if (!event.dataTransfer.types.includes("Files")) return false;
    depth = Math.max(0, by === 0 ? 0 : depth + by);
    hide($("drop"), depth === 0);
    event.preventDefault();
    return true;
  };
  page_.addEventListener("dragenter", (event) => over(event, 1));
  page_.addEventListener("dragover", (event) => { if (event.dataTransfer.types.includes("Files")) event.preventDefault(); });
  page_.addEventListener("dragleave", (event) => over(event, -1));
  page_.addEventListener("drop", (event) => { if (over(event, 0)) take(...event.dataTransfer.files); });
}

const said = (error) => [error.place, error.message, error.help].filter(Boolean).join(" – ") || t("studio-lost");

async function take(file, ...others) {
  if (!file) return;
  notice("");
  const words = [await taken(file), others.length > 0 ? t("studio-one-file", { file: file.name }) : ""];
  notice(words.filter(Boolean).join(" "));
}

// Opens a file. Returns a message about it, or an empty text.
async function taken(file) {
  if (/\.toml$/i.test(file.name)) {
    openScene(await file.text());
    return "";
  }
  tab("force");
  if (file.size > LARGEST) return `${file.name}: ${t("studio-too-large")}`;
  if (file.size > LARGE) notice(t("studio-reading", { file: file.name }), true);
  try {
    use(file.name, await blobs.put(file));
    return "";
  } catch (error) {
    return said(error);
  }
}

async function fromFolder(path) {
  try {
    const { name, hash } = await engine.folder.read(path);
    use(name, await blobs.put(engine.bytes(hash)));
  } catch (error) {
    notice(said(error));
  }
}

const set = (key, value) => ({ set: { key, value } });

// Makes the recording the force of the scene. It is read with the stored answers about this recording only. If it is rejected, the fault of
// the scene contains the reason and the possible changes.
function use(file, hash) {
  const version = versions.now();
  const named = answers.nameFor(file, version);
  const edits = [set("gait.file", file), ...answers.changesFor(hash, version, designs.known())];
  if (named) edits.push(set("name", named));
  edit(edits, null, { files: { [file]: hash }, recording: { file, without: [] }, hand: null, title: file });
}

// --- open questions ------------------------------------------------------------------------------

// Corrections of a fault or an open question: buttons with the values that the engine suggests, and buttons that go to the fields without a
// suggestion.
export function remedies({ remedies: offered = [] }) {
  return offered.map(({ key, value }) => (value === undefined
    ? [`${label(key)} …`, () => focus(key)]
    : [`${label(key)}: ${wordOf(key, value)}`, () => choose(key, value)]));
}

const wordOf = (key, value) => (key === "gait.accept" ? t(`studio-force-question-${value}`) : choice(value));

function choose(key, value) {
  const version = versions.now();
  const all = key === "gait.accept" ? [...acceptedOf(designs.known()), value].join(", ") : value;
  answers.chosen(version, key, value);
  edit([set(key, all)], null, { title: label(key) });
}

const acceptedOf = (fields) => (fields["gait.accept"]?.text ?? "").split(/[,\s]+/).filter(Boolean);

// Shows what the user has accepted about the recording, next to the verdict.
function accepted(version, fields) {
  const list = fields["gait.accept"]?.acts ? acceptedOf(fields) : [];
  hide($("accepted"), list.length === 0);
  draw(list.map((question_) => html`<p>${t("studio-force-accepted", { what: t(`studio-force-question-${question_}`) })}
    <button type="button" data-accepted=${question_} @click=${() => takeBack(question_)}>${t("studio-force-take-back")}</button></p>`),
  $("accepted"));
}

function takeBack(question_) {
  const left = acceptedOf(designs.known()).filter((other) => other !== question_).join(", ");
  edit([set("gait.accept", left)], null, { title: label("gait.accept") });
}

// --- the panel -----------------------------------------------------------------------------------

function page(version) {
  const found = foundIn(version);
  const { recording } = version ?? {};
  return html`
    <h2>${t("studio-force-recording")}</h2>
    <p class="lead">${t("studio-force-lead")}</p>
    <label class="pick" for="pick-file">${t("studio-force-pick")}</label>
    <input type="file" id="pick-file" accept=${ENDINGS} @change=${picked}>
    ${folderFiles.length > 0 ? folder() : nothing}
    ${recording?.cycle ? html`<p class="fair" id="cycle-only">${t("studio-force-cycle-only", { file: recording.file })}</p>` : nothing}
    ${found ? details(found, contacts(version, found)) : nothing}
    ${found && read.size > 1 ? html`<button type="button" id="side-by-side" @click=${() => sides(found)}>${
      t("studio-force-sides")}</button>` : nothing}
    <h2>${t("studio-force-hand")}</h2>
    <p class="lead">${t("studio-force-hand-lead")}</p>
    ${hand.section()}`;
}

function picked({ target }) {
  const files = [...target.files];
  // Without this, the same file could not be chosen again.
  target.value = "";
  take(...files);
}

function folder() {
  const choose_ = ({ target }) => { if (target.value) fromFolder(target.value); };
  return html`<label class="stack" for="folder-recording">${t("studio-force-folder-label")}</label>
    <select id="folder-recording" @change=${choose_}>
      <option value="">${t("studio-force-folder")}</option>
      ${folderFiles.map(({ path }) => html`<option value=${path}>${path}</option>`)}
    </select>`;
}

const figures = new WeakMap();
// Picture of a recording as an element, made once.
function figureOf(found) {
  if (!figures.has(found)) figures.set(found, enlarging(found.picture, "studio-force-recording"));
  return figures.get(found);
}

function details(found, ticks) {
  return html`<div class="found">
    <h3>${found.file}</h3>
    ${found.picture ? figureOf(found) : nothing}
    ${ticks}
    <details><summary>${t("studio-force-details")}</summary><pre tabindex="0">${found.table}</pre></details>
  </div>`;
}

// Element of a recording in the comparison, with all its details open.
const beside = (found) => html`<div class="found">
  <h3>${found.file}</h3>
  ${found.picture ? html`<figure>${picture(found.picture)}</figure>` : nothing}
  <details open><summary>${t("studio-force-details")}</summary><pre tabindex="0">${found.table}</pre></details>
</div>`;

// Two recordings side by side: the present one and a selected one.
function sides(found) {
  const others = [...read.values()].filter((r) => r.file !== found.file).reverse();
  dialog("studio-force-sides", (body) => {
    body.className = "sides";
    const [left, right] = [0, 1].map(() => body.appendChild(document.createElement("div")));
    draw(beside(found), left);
    const show_ = (i) => draw(html`
      ${others.length > 1 ? html`<select id="other-recording" aria-label=${t("studio-force-other")}
        @change=${({ target }) => show_(target.selectedIndex)}>${others.map((r) => html`<option>${r.file}</option>`)}</select>` : nothing}
      ${beside(others[i])}`, right);
    show_(0);
  });
}

function contacts(version, found) {
  if (!(found.stances?.length > 0)) return nothing;
  const without = new Set(version.recording.without);
  const tick = (i, isOn) => {
    if (isOn) without.delete(i);
    else without.add(i);
    leaveOut([...without].sort((a, b) => a - b));
  };
  const row = (s, i) => html`<tr>
    <td><input type="checkbox" id="contact-${i}" .checked=${live(!without.has(i))} @change=${({ target }) => tick(i, target.checked)}></td>
    <th scope="row"><label for="contact-${i}">${i + 1} ${s.foot ? t(`studio-foot-${s.foot}`) : ""}</label></th>
    <td>${number(s.start_s, 4)}–${number(s.end_s, 4)} s</td><td>${number(s.p1_n, 4)} N</td></tr>`;
  return html`<div class="scroll short" tabindex="0">
    <table><caption>${t("studio-contacts")}</caption><tbody>${found.stances.map(row)}</tbody></table></div>`;
}

// Excludes contacts. The mean cycle of the others becomes a separate file that the scene names. This file needs no reading options.
async function leaveOut(without) {
  const version = versions.now();
  const { file } = version.recording;
  const asked = { ...question(version), without };
  try {
    const found = await engine.ask("contacts", asked);
    known.set(keyOf(asked), found);
    read.set(file, found);
    const files = { [found.use]: found.use_hash };
    if (without.length > 0) await blobs.put(engine.bytes(found.use_hash));
    const recording = without.length > 0 ? { file, without, options: asked.options } : { file, without };
    const options = Object.entries(asked.options).map(([key, value]) => set(`gait.${key}`, without.length > 0 ? "" : value));
    edit([set("gait.file", found.use), ...options], null, { files, recording, title: t("studio-contacts") });
  } catch (error) {
    notice(said(error));
    show();
  }
}
