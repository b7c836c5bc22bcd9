// Every file that the command writes, as a download; of the design that is shown, never of another.

import { make, notice } from "../core/dom.js";
import { t } from "../core/words.js";
import { engine } from "../core/net.js";
import { dialog } from "../core/view.js";
import * as blobs from "../core/blobs.js";
import { turning } from "./turning.js";
import { zip } from "../core/zip.js";
import { pack } from "../core/packing.js";
import * as designs from "../core/designs.js";
import * as versions from "../core/versions.js";

// The file that the page itself makes.
const FILM = "cam.gif";
// Files that are made for a cutter.
const CUTTER = ["cutter.csv", "cutter.nc", "cutter_second.nc"];

export function open() {
  if (!designs.isCurrent()) {
    notice(t("studio-not-designed"));
    return;
  }
  const { answer, files } = designs.present();
  const make_ = (name, tool) => (name === FILM ? turning(answer) : engine.download({ scene: answer.scene, files: blobs.listed(files), name, tool }));
  const groups = answer.infeasible ? answer.exports : [...answer.exports, ["film", [FILM]]];
  dialog("studio-export", (body) => {
    body.className = "exports";
    const tool = make("input", { type: "text", value: answer.cutter, id: "tool", size: 8 });
    if (!answer.infeasible) body.append(preview(() => make_("cam.svg")));
    for (const [group, names] of groups) {
      const links = names.map((name) => make("li", {}, link(name, () => make_(name, CUTTER.includes(name) ? tool.value : undefined)),
        make("small", {}, t(`studio-file-${name.replaceAll(".", "-")}`))));
      body.append(make("section", {}, make("h3", {}, t(`studio-export-${group}`)), make("ul", {}, ...links)));
    }
    if (engine.page) body.append(page(`${answer.name}.html`));
    body.append(make("p", {}, whole(answer.name, groups, make_)));
    if (!answer.infeasible) body.append(make("p", {}, make("label", { for: "tool" }, t("studio-tool")), " ", tool));
    body.append(make("p", { class: "lead" }, t("studio-export-tolerance")));
  });
}

// A link whose file is made when it is asked for.
function link(name, made) {
  const a = make("a", { href: "#", download: name, onclick: async (event) => {
    if (a.dataset.ready) return;
    event.preventDefault();
    try {
      a.href = URL.createObjectURL(await made());
      a.dataset.ready = "true";
      a.click();
    } catch (error) {
      notice([error.message, error.help].filter(Boolean).join(" – "));
    } finally {
      setTimeout(() => { URL.revokeObjectURL(a.href); a.href = "#"; delete a.dataset.ready; }, 2000);
    }
  } }, name);
  return a;
}

// This page with the scene inside, and how another page shows it.
function page(name) {
  const made = async () => engine.page((await pack(versions.now())).text);
  const frame = `<iframe src="${name}?embed=force,s" title="${name}" width="900" height="600"></iframe>`;
  return make("section", {}, make("h3", {}, t("studio-export-page")),
    make("ul", {}, make("li", {}, link(name, made), make("small", {}, t("studio-file-page")))),
    make("p", { class: "lead" }, t("studio-export-frame")), make("code", { id: "frame" }, frame));
}

// All files in one archive; one that cannot be made is left out and named.
function whole(title, groups, made) {
  const names = groups.flatMap(([, list]) => list);
  const button = make("button", { type: "button", class: "main", id: "export-all", onclick: async () => {
    button.disabled = true;
    const [files, without] = [[], []];
    for (const name of names) {
      try {
        files.push([name, new Uint8Array(await (await made(name)).arrayBuffer())]);
      } catch {
        without.push(name);
      }
    }
    const a = make("a", { href: URL.createObjectURL(zip(files)), download: `${title}.zip` });
    a.click();
    button.disabled = false;
    if (without.length > 0) notice(t("studio-export-without", { files: without.join(", ") }));
  } }, t("studio-export-all", { count: names.length }));
  return button;
}

function preview(made) {
  const image = make("img", { alt: t("studio-export-preview") });
  made().then((blob) => { image.src = URL.createObjectURL(blob); }, () => {});
  image.addEventListener("load", () => URL.revokeObjectURL(image.src));
  return make("figure", {}, image);
}
