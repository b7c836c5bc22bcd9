// The page: boot, wiring, keys.

import { $, notice, make, clear } from "./core/dom.js";
import * as words from "./core/words.js";
import { get, send } from "./core/net.js";
import * as store from "./core/store.js";
import * as solver from "./core/solver.js";
import * as form from "./panels/form.js";
import * as clock from "./core/clock.js";
import * as stage from "./panels/stage.js";
import * as charts from "./panels/charts.js";
import * as verdict from "./panels/verdict.js";
import * as view from "./core/view.js";
import * as gallery from "./panels/gallery.js";
import * as exports from "./panels/exports.js";
import * as files from "./panels/files.js";
import * as force from "./panels/force.js";
import * as programme from "./panels/programme.js";
import * as compare from "./panels/compare.js";
import * as text from "./panels/text.js";

const { t } = words;
const PACES = [1, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01];
let answer = null;
let lastGesture = null;
let anew = true;
// The longest search, s.
let longest = 60;

// Changes values of the scene and asks for its design. Changes of one gesture are one step of the history.
function edit(changes, gesture = Symbol("step")) {
  if (gesture !== lastGesture) store.step(store.state.scene);
  lastGesture = gesture;
  store.change(changes);
  solver.ask(performance.now());
  buttons();
}

function openScene(toml) {
  store.replace(toml);
  lastGesture = null;
  fresh();
}

function fresh() {
  anew = true;
  form.reset();
  stage.anew();
  solver.cancel();
  solver.ask(performance.now());
  buttons();
}

function undo(move) {
  const before = move();
  lastGesture = null;
  if (before === null) return;
  form.reset();
  solver.cancel();
  solver.ask(performance.now());
  buttons();
}

function buttons() {
  $("undo").disabled = !store.state.canUndo;
  $("redo").disabled = !store.state.canRedo;
}

async function show(next, since, more) {
  answer = next;
  document.title = `${next.name} – gaitcam studio`;
  $("scene-name").textContent = next.name;
  $("fault").hidden = true;
  form.clearFault();
  form.update(next.fields);
  clock.load(next.motion);
  if (anew) begin(next.motion);
  verdict.show(next);
  charts.show(next.curves);
  stage.show(next);
  for (const part of [force, programme, compare, text]) part.show(next, more);
  clock.set(clock.angle());
  buttons();
  await painted();
  const design = $("design");
  design.dataset.ms = (performance.now() - since).toFixed(1);
  design.dataset.serverMs = next.server_ms.toFixed(2);
  design.dataset.revision = Number(design.dataset.revision) + 1;
}

// Resolves when the next picture is on the screen; a hidden page has none.
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

// A new cam starts to turn, one turn in about five seconds.
function begin(motion) {
  anew = false;
  clock.set(motion.start);
  const wanted = motion.period / 5;
  const pace = PACES.reduce((best, p) => (Math.abs(Math.log(p / wanted)) < Math.abs(Math.log(best / wanted)) ? p : best));
  $("pace").value = String(pace);
  clock.setPace(pace);
  const calm = window.matchMedia("(prefers-reduced-motion: reduce)").matches;
  clock.play(!calm);
}

function fault(error) {
  if (error.code === "lost" || error.code === "http") {
    notice(t(error.code === "lost" ? "studio-lost" : "studio-refused"), true);
    return;
  }
  form.fault(error);
  const place = error.place ? `${error.place}: ` : "";
  const box = clear($("fault"));
  box.hidden = false;
  box.append(make("p", {}, make("strong", {}, place), error.message, error.help ? make("span", { class: "help" }, ` – ${error.help}`) : null));
  if (error.key === "gait.file" || error.code.endsWith("cannot-read")) {
    box.append(make("button", { type: "button", onclick: () => view.tab("force") }, t("studio-to-force")));
  }
}

let waiting = 0;
function working(on, since) {
  clearInterval(waiting);
  clock.hold(on);
  $("design").setAttribute("aria-busy", String(on));
  if (!on) {
    $("design").classList.remove("busy");
    $("working").hidden = true;
    return;
  }
  waiting = setInterval(() => {
    const passed = performance.now() - since;
    if (passed < 180) return;
    clock.hold(false);
    $("design").classList.add("busy");
    $("working").hidden = false;
    Object.assign($("working-share"), { max: longest, value: passed / 1000 });
    $("working-time").textContent = t("studio-working", { seconds: words.number(passed / 1000, 2), longest });
  }, 60);
}

function player() {
  const paint = () => {
    $("play").textContent = clock.isPlaying() ? "❚❚" : "▶";
    $("play").setAttribute("aria-label", t(clock.isPlaying() ? "studio-pause" : "studio-play"));
    $("reverse").setAttribute("aria-pressed", String(clock.isBackwards()));
  };
  const paces = () => {
    const before = $("pace").value;
    clear($("pace")).append(...PACES.map((p) => make("option", { value: p }, p === 1 ? t("studio-true-speed") : t("studio-of-speed", { share: Math.round(1 / p) }))));
    if (before) $("pace").value = before;
  };
  clock.onPlay(paint);
  words.onLanguage(() => { paint(); paces(); });
  paint();
  paces();
  $("play").addEventListener("click", () => clock.play(!clock.isPlaying()));
  $("reverse").addEventListener("click", clock.reverse);
  $("pace").addEventListener("change", () => clock.setPace(Number($("pace").value)));
  $("angle").addEventListener("input", () => { clock.play(false); clock.set(Number($("angle").value)); });
}

function keyboard() {
  document.addEventListener("keydown", (event) => {
    const typing = event.target.closest("input[type=text], input[type=search], textarea, select, dialog");
    if ((event.ctrlKey || event.metaKey) && event.key.toLowerCase() === "z" && !event.target.closest("textarea")) {
      event.preventDefault();
      undo(event.shiftKey ? store.redo : store.undo);
    } else if ((event.ctrlKey || event.metaKey) && event.key.toLowerCase() === "y") {
      event.preventDefault();
      undo(store.redo);
    } else if (event.key === " " && !typing && !event.target.closest("button, summary, [role=slider], input, label")) {
      event.preventDefault();
      clock.play(!clock.isPlaying());
    }
  });
}

function tools(start) {
  $("undo").addEventListener("click", () => undo(store.undo));
  $("redo").addEventListener("click", () => undo(store.redo));
  $("cancel").addEventListener("click", solver.cancel);
  $("pin").addEventListener("click", () => { compare.pin(answer); notice(t("studio-pinned")); });
  $("open-scenes").addEventListener("click", () => gallery.open(start.scenes, openScene));
  $("open-files").addEventListener("click", () => files.open(openScene));
  $("open-save").addEventListener("click", () => files.save(answer));
  $("open-export").addEventListener("click", () => exports.open(answer));
  $("link").addEventListener("click", async () => {
    const place = new URL(location.href);
    place.hash = "scene=" + await store.packed();
    history.replaceState(null, "", place);
    try {
      await navigator.clipboard.writeText(place.href);
      const recording = store.shortened();
      notice(recording ? t("studio-linked-cycle", { file: recording }) : t("studio-linked"));
    } catch {
      notice(t("studio-linked-address"));
    }
  });
  $("language").addEventListener("click", () => words.choose(words.language() === "en" ? "es" : "en"));
  const skip = document.querySelector(".skip");
  skip.addEventListener("click", (event) => { event.preventDefault(); $("verdict").focus(); });
}

function welcome() {
  let seen = false;
  try { seen = localStorage.getItem("gaitcam-seen") === "1"; } catch { /* private windows keep nothing */ }
  $("welcome").hidden = seen;
  $("welcome-close").addEventListener("click", () => {
    $("welcome").hidden = true;
    try { localStorage.setItem("gaitcam-seen", "1"); } catch { /* as above */ }
  });
}

async function boot() {
  view.theme();
  const start = await get("start.json");
  words.load(start.words);
  longest = start.longest_s;
  let tag = document.documentElement.lang;
  try { tag = localStorage.getItem("gaitcam-language") ?? tag; } catch { /* private windows keep nothing */ }
  words.choose(tag);
  words.onLanguage((next) => {
    $("language").textContent = next === "en" ? "ES" : "EN";
    if (answer) solver.ask(performance.now());
  });
  $("language").textContent = tag === "en" ? "ES" : "EN";
  form.load(start.keys, edit);
  verdict.load((changes) => edit(changes));
  charts.load();
  stage.load(() => solver.ask(performance.now()));
  player();
  view.tabs();
  view.dialogs();
  keyboard();
  tools(start);
  force.load(edit, openScene);
  programme.load(edit);
  compare.load({ start, edit, openScene });
  text.load(openScene);
  files.load(start);
  welcome();
  solver.on({ show, fault, working, colour: stage.chosen });
  store.replace(await store.fromAddress() ?? start.scene, false);
  for (const [name, content] of Object.entries(store.state.files)) await send(`recording?name=${encodeURIComponent(name)}`, content);
  window.addEventListener("hashchange", async () => {
    const other = await store.fromAddress();
    if (other && other !== store.state.scene) openScene(other);
  });
  solver.ask(performance.now());
  buttons();
}

boot().catch(() => notice(t("studio-lost"), true));
