// The wanted force: recordings dropped on the page with their contacts, and points drawn by hand.

import { $, make, clear, notice, svg } from "./dom.js";
import { t, number, onLanguage } from "./words.js";
import { post, send, get } from "./net.js";
import { addFile } from "./store.js";
import { onTab, openTab, tab } from "./view.js";

let edit = () => {};
let openScene = () => {};
let recording = null;
let without = new Set();
let drawn = null;
let answer = null;
let folderFiles = [];

export function load(onEdit, onScene) {
  edit = onEdit;
  openScene = onScene;
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

export function show(next) {
  answer = next;
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
    if (file.size < 60000 && !/\.c3d$/i.test(file.name)) addFile(recording.file, await file.text());
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
  if (drawn) root.append(editor());
  else root.append(make("button", { type: "button", id: "draw-force", class: "main", onclick: begin }, t("studio-force-draw")));
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

// --- points by hand ------------------------------------------------------------------------------

// Begins with the present target, or a hump.
function begin() {
  const { curves, motion } = answer ?? {};
  const target = curves?.panels[0].lines.find((l) => l.role === "target") ?? curves?.panels[0].lines[0];
  const period = motion?.period ?? 1;
  const count = 13;
  const points = [];
  for (let k = 0; k < count - 1; k += 1) {
    const wanted = curves.start + curves.length * k / (count - 1);
    const i = curves.theta.findIndex((x) => x >= wanted - 1e-9);
    points.push([period * k / (count - 1), Math.round(10 * (target.y[Math.max(i, 0)] ?? 0)) / 10]);
  }
  drawn = { period_s: period, points };
  keep();
  build();
}

let version = 0;
async function keep() {
  version += 1;
  const mine = version;
  // Two names in turn: the scene is seen to change.
  const body = { file: `force-by-hand-${mine % 2}.csv`, period_s: drawn.period_s, points: drawn.points };
  try {
    const kept = await post("force", body);
    if (mine !== version) return;
    addFile(kept.use, kept.csv);
    drawn.curve = kept.force_n;
    edit([{ set: { key: "gait.file", value: kept.use } }], `drawn ${drawn.gesture ?? 0}`);
    redraw();
  } catch (error) {
    notice(error.message);
  }
}

let redraw = () => {};

function editor() {
  const [width, height, pad] = [320, 190, 28];
  const picture = svg("svg", { class: "editor", viewBox: `0 0 ${width} ${height}`, role: "group", "aria-label": t("studio-force-hand") });
  const period = make("input", { type: "text", id: "hand-period", size: 8, value: `${number(drawn.period_s, 5).replace(",", ".")}`, onchange: () => {
    const next = parseFloat(period.value.replace(",", "."));
    if (!(next > 0)) return;
    const factor = next / drawn.period_s;
    for (const p of drawn.points) p[0] *= factor;
    drawn.period_s = next;
    keep();
  } });
  let chosen = 0;
  const range = () => {
    const all = drawn.points.map((p) => p[1]).concat(drawn.curve ?? []);
    const [low, high] = [Math.min(0, ...all), Math.max(1, ...all)];
    return [low, high + 0.1 * (high - low)];
  };
  let scale = range();
  const x = (time) => pad + time / drawn.period_s * (width - pad - 8);
  const y = (force) => height - 18 - (force - scale[0]) / (scale[1] - scale[0]) * (height - 26);
  const back = (event) => {
    const p = new DOMPoint(event.clientX, event.clientY).matrixTransform(picture.getScreenCTM().inverse());
    const time = (p.x - pad) / (width - pad - 8) * drawn.period_s;
    const force = scale[0] + (height - 18 - p.y) / (height - 26) * (scale[1] - scale[0]);
    return [Math.max(0, Math.min(drawn.period_s * 0.999, time)), Math.round(force * 10) / 10];
  };
  const paint = () => {
    clear(picture);
    picture.append(svg("path", { class: "axis", d: `M${pad} ${y(0)}H${width - 8}M${pad} 8V${height - 18}` }));
    if (drawn.curve) {
      const step = drawn.period_s / drawn.curve.length;
      picture.append(svg("path", { class: "line target", d: drawn.curve.map((f, i) => `${i ? "L" : "M"}${x(i * step).toFixed(1)} ${y(f).toFixed(1)}`).join("") }));
    }
    drawn.points.forEach((point, i) => {
      const dot = svg("circle", { class: i === chosen ? "knot chosen" : "knot", cx: x(point[0]), cy: y(point[1]), r: 6, tabindex: 0, role: "button",
        "aria-label": t("studio-point", { number: i + 1, time: number(point[0], 3), force: number(point[1], 4) }) });
      dot.addEventListener("pointerdown", (event) => {
        chosen = i;
        scale = range();
        drawn.gesture = (drawn.gesture ?? 0) + 1;
        picture.setPointerCapture(event.pointerId);
        event.stopPropagation();
        paint();
      });
      dot.addEventListener("keydown", (event) => {
        const size = (scale[1] - scale[0]) / 100;
        const step = { ArrowUp: [0, size], ArrowDown: [0, -size], ArrowRight: [drawn.period_s / 100, 0], ArrowLeft: [-drawn.period_s / 100, 0] }[event.key];
        if (event.key === "Delete" && drawn.points.length > 3) drawn.points.splice(i, 1);
        else if (step) move(i, [point[0] + step[0], point[1] + step[1]]);
        else return;
        event.preventDefault();
        chosen = Math.min(i, drawn.points.length - 1);
        paint();
        picture.querySelectorAll(".knot")[chosen]?.focus();
        keep();
      });
      dot.addEventListener("dblclick", () => { if (drawn.points.length > 3) { drawn.points.splice(i, 1); paint(); keep(); } });
      picture.append(dot);
    });
  };
  // A point stays between its neighbours.
  const move = (i, [time, force]) => {
    const gap = drawn.period_s / 200;
    const low = i > 0 ? drawn.points[i - 1][0] + gap : 0;
    const high = i + 1 < drawn.points.length ? drawn.points[i + 1][0] - gap : drawn.period_s - gap;
    drawn.points[i] = [i === 0 ? 0 : Math.max(low, Math.min(high, time)), force];
  };
  picture.addEventListener("pointermove", (event) => {
    if (!picture.hasPointerCapture(event.pointerId)) return;
    move(chosen, back(event));
    paint();
    keep();
  });
  picture.addEventListener("dblclick", (event) => {
    if (event.target.classList.contains("knot")) return;
    const point = back(event);
    drawn.points.push(point);
    drawn.points.sort((a, b) => a[0] - b[0]);
    chosen = drawn.points.indexOf(point);
    paint();
    keep();
  });
  redraw = () => { paint(); };
  paint();
  const add = make("button", { type: "button", onclick: () => {
    const next = drawn.points[chosen + 1] ?? [drawn.period_s, drawn.points[0][1]];
    const [a, b] = [drawn.points[chosen], next];
    drawn.points.splice(chosen + 1, 0, [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2]);
    paint();
    keep();
  } }, t("studio-point-add"));
  const remove = make("button", { type: "button", onclick: () => {
    if (drawn.points.length <= 3) return;
    drawn.points.splice(chosen, 1);
    chosen = Math.max(0, chosen - 1);
    paint();
    keep();
  } }, t("studio-point-remove"));
  return make("div", { class: "hand" }, picture, make("div", { class: "buttons" }, add, remove,
    make("label", { for: "hand-period" }, t("studio-force-period")), period));
}
