// Start of the page, and connections between its modules.

import { $, hide, notice } from "./core/dom.js";
import * as words from "./core/words.js";
import { t } from "./core/words.js";
import { engine, Fault } from "./core/net.js";
import * as versions from "./core/versions.js";
import * as designs from "./core/designs.js";
import * as autosave from "./core/autosave.js";
import * as units from "./core/units.js";
import * as status from "./core/status.js";
import { hasScene, unpack } from "./core/packing.js";
import * as answers from "./core/answers.js";
import * as form from "./panels/form.js";
import * as clock from "./core/clock.js";
import * as stage from "./panels/stage.js";
import * as charts from "./charts/charts.js";
import * as verdict from "./panels/verdict.js";
import * as view from "./core/view.js";
import * as tools from "./panels/tools.js";
import * as player from "./panels/player.js";
import * as files from "./dialogs/files.js";
import * as force from "./panels/force.js";
import * as programme from "./panels/programme.js";
import * as compare from "./panels/compare.js";
import * as text from "./panels/text.js";
import * as paper from "./panels/paper.js";

let anew = true;

let lastGesture = null;
// Message to show after the first design.
let told = "";

// Changes values of the scene and requests its design. All changes of one gesture belong to one version.
function edit(changes, gesture = null, more = {}) {
  const before = designs.present()?.answer.curves;
  if (before && gesture !== lastGesture) charts.leave(before);
  else charts.linger();
  lastGesture = gesture;
  versions.edit(changes, gesture, more);
  tools.welcomed();
  designs.ask(performance.now());
}

// Opens another scene. `more` contains the files that the scene names, its recording, and its drawn force.
function openScene(toml, more = {}) {
  const [, name = ""] = /^name\s*=\s*"([^"]*)"/m.exec(toml) ?? [];
  versions.open(toml, { name, ...more });
  form.anew();
  elsewhere(true);
  anew = true;
  stage.anew();
}

// Moves to another version: undo, redo, or a version from the list.
function move(there) {
  const { name } = versions.now();
  if (there()) elsewhere(versions.now().name !== name);
}

// Requests the design of another version. The fields of another scene are unknown. Otherwise the old fields stay until the new ones arrive,
// so that the form does not flicker.
function elsewhere(isOther) {
  charts.forget();
  form.reset();
  if (isOther) designs.forget();
  designs.askAnew();
}

async function show(answer, since, more) {
  if ($("notice").dataset.lasting === "true") hide($("notice"));
  if (told) notice(told, true);
  told = "";
  clock.load(answer.motion);
  if (anew) {
    anew = false;
    player.begin(answer.motion);
  }
  charts.show(answer.curves, answer.fields, answer.idle);
  stage.show(answer);
  state(more);
  clock.set(clock.angle());
  await painted();
  const design = $("design");
  if (design.dataset.revision === "0") performance.mark("first-design");
  design.dataset.forceHash = answer.force_hash ?? "";
  design.dataset.ms = (performance.now() - since).toFixed(1);
  design.dataset.serverMs = answer.server_ms.toFixed(2);
  design.dataset.revision = Number(design.dataset.revision) + 1;
}

// Draws every panel after a change of the state. A panel stores none of the state. It receives the version and `seen`: the displayed
// response (null before the first), the known fields of the scene, and whether more responses of one gesture follow.
function state(moving = false) {
  const version = versions.now();
  const seen = { answer: designs.present()?.answer ?? null, fields: designs.known(), moving };
  /** @type {{render: Function}[]} */
  const panels = [verdict, status, form, force, programme, compare, text];
  for (const panel of panels) panel.render(version, seen);
}

// Resolves when the next frame has been painted. A hidden page paints no frames, so the promise resolves at once.
function painted() {
  if (document.hidden) return Promise.resolve();
  return new Promise((resolve) => {
    requestAnimationFrame(() => {
      const channel = new MessageChannel();
      channel.port1.onmessage = resolve;
      channel.port2.postMessage(0);
    });
  });
}

function keyboard() {
  document.addEventListener("keydown", (event) => {
    const target = /** @type {Element} */ (event.target);
    const typing = target.closest("input[type=text], input[type=search], textarea, select, dialog");
    const held = event.ctrlKey || event.metaKey;
    const key = event.key.toLowerCase();
    if (held && key === "z" && !target.closest("textarea")) {
      event.preventDefault();
      move(event.shiftKey ? versions.redo : versions.undo);
    } else if (held && key === "y") {
      event.preventDefault();
      move(versions.redo);
    } else if (event.key === " " && !typing && !target.closest("button, summary, [role=slider], input, label")) {
      event.preventDefault();
      clock.play(!clock.isPlaying());
    }
  });
}

function working(on, since) {
  clock.hold(on);
  if (on) verdict.stop();
  status.working(on, since);
}

async function first(start) {
  if (!view.embedded && await autosave.restore()) {
    designs.ask();
    return;
  }
  // A page in a single file may contain a scene.
  const inside = document.getElementById("packed")?.textContent;
  const held = await linked() ?? (inside ? await unpack(`s=${inside}`) : null);
  if (held) openScene(held.scene, held);
  else openScene(start.scene);
}

// Scene in the address of the page. For a damaged one, a message is prepared.
async function linked() {
  const held = await unpack(location.hash);
  if (!held && hasScene(location.hash)) told = t("studio-link-broken");
  return held;
}

async function boot() {
  view.theme();
  units.load();
  const start = await engine.ask("start", {});
  words.load(start.words);
  words.begin();
  status.load(start.longest_s, (fault) => force.remedies(fault));
  form.load(start.keys, edit);
  verdict.load((changes) => edit(changes), /** @type {any} */ ((fault) => force.remedies(fault)), () => state());
  charts.load(edit);
  stage.load(() => designs.ask());
  player.load();
  view.tabs();
  view.dialogs();
  keyboard();
  answers.load(start.scenes.map((scene) => scene.name));
  force.load(edit, openScene);
  programme.load(edit);
  compare.load({ start, edit, openScene });
  text.load(openScene);
  paper.load();
  files.load(start);
  document.documentElement.toggleAttribute("data-embed", Boolean(view.embedded));
  tools.load({ start, move, openScene });
  designs.on({ show, state, working, lost: status.lost, colour: stage.chosen });
  if (!view.embedded) autosave.load();
  words.onLanguage(() => designs.ask());
  units.watch(() => designs.ask());
  window.addEventListener("hashchange", async () => {
    const other = await linked();
    if (told) notice(told, true);
    told = "";
    if (other && other.scene !== versions.now().scene) openScene(other.scene, other);
  });
  await first(start);
  compare.restore();
}

boot().catch((error) => {
  if (!(error instanceof Fault)) throw error;
  notice(t("studio-lost"), true);
});
