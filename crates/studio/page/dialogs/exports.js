// Every file that the command writes, as a download, grouped by purpose. The files belong to the displayed design.

import { html, nothing, notice } from "../core/dom.js";
import { t } from "../core/words.js";
import { engine } from "../core/net.js";
import { sheet } from "../core/view.js";
import { zipSync } from "../core/vendor.js";
import * as blobs from "../core/blobs.js";
import { pack } from "../core/packing.js";
import * as designs from "../core/designs.js";
import * as versions from "../core/versions.js";
import { turning } from "./turning.js";

// File that the page itself makes.
const FILM = "cam.gif";
// Files for a cutter, and endings of files that are already compressed.
const CUTTER = ["cutter.csv", "cutter.nc", "cutter_second.nc"];
const COMPRESSED = /\.(png|gif|pdf|xlsx|3mf)$/;

// Files by purpose. Files that are not listed belong to the last group.
const INTENTS = {
  cut: [
    "profile.dxf", "cam.step", "drawing.pdf", "profile.svg", "profile.csv", "second_profile.csv", "cutter.csv", "cutter.nc",
    "cutter_second.nc", "wire.nc",
  ],
  print: ["profile.stl", "profile.3mf", "groove_upper.stl", "groove_lower.stl"],
  control: ["ecam_codesys.st", "ecam_twincat.st", "ecam_rockwell.st", "ecam_segments.csv", "ecam_csv.csv", "law.csv"],
  show: ["report.html", "cam.png", "cam.svg", FILM],
};

// File names by group, in the order of the table. Names that are not in the table come last.
export function sorted(names) {
  const known = new Set(Object.values(INTENTS).flat());
  const others = names.filter((name) => !known.has(name));
  const all = Object.entries(INTENTS).map(([intent, list]) => [intent, list.filter((name) => names.includes(name))]);
  return all.map(([intent, list]) => [intent, intent === "show" ? [...list, ...others] : list]).filter(([, list]) => list.length > 0);
}

// Scene or recording as a file name.
export function fileName(name, recording) {
  const base = (recording ?? name).replace(/^.*[/\\]/, "").replace(/\.(c3d|mot|sto|csv|tsv|txt|asc)$/i, "");
  return base || "cam";
}

const said = (error) => [error.message, error.help].filter(Boolean).join(" – ") || t("studio-lost");

// Offers a file as a download.
export function download(blob, name) {
  const a = document.createElement("a");
  Object.assign(a, { href: URL.createObjectURL(blob), download: name });
  a.click();
  setTimeout(() => URL.revokeObjectURL(a.href), 2000);
}

// Link whose file is made when the user follows the link.
function link(name, made) {
  const get = async (event) => {
    event.preventDefault();
    try {
      download(await made(), name);
    } catch (error) {
      notice(said(error));
    }
  };
  return html`<a href="#" download=${name} @click=${get}>${name}</a>`;
}

// All files in one archive. The result also names the files that cannot be made.
async function archive(names, made) {
  const [files, without] = [{}, []];
  const mtime = new Date();
  for (const name of names) {
    try {
      const bytes = new Uint8Array(await (await made(name)).arrayBuffer());
      files[name] = [bytes, { mtime, level: COMPRESSED.test(name) ? 0 : 6 }];
    } catch {
      without.push(name);
    }
  }
  return { blob: new Blob([zipSync(files)], { type: "application/zip" }), without };
}

function all(title, names, made) {
  const get = async (event) => {
    const button = event.currentTarget;
    button.disabled = true;
    try {
      const { blob, without } = await archive(names, made);
      download(blob, `${title}.zip`);
      if (without.length > 0) notice(t("studio-export-without", { files: without.join(", ") }), true);
    } finally {
      button.disabled = false;
    }
  };
  return html`<button type="button" class="main" id="export-all" @click=${get}>${t("studio-export-all", { count: names.length })}</button>`;
}

// Download of this page with the scene inside, and the code with which another page includes it.
function page(name) {
  const made = async () => engine.page((await pack(versions.now(), true)).text);
  const frame = `<iframe src="${name}?embed=force,s" title="${name}" width="900" height="800"></iframe>`;
  return { item: html`<li>${link(name, made)}<small>${t("studio-file-page")}</small></li>`,
    more: html`<p class="lead">${t("studio-export-frame")}</p><code id="frame">${frame}</code>` };
}

let preview = "";

export function open() {
  if (!designs.isCurrent()) {
    notice(t("studio-not-designed"));
    return;
  }
  const { answer, files } = designs.present();
  let tool = answer.cutter;
  const made = (name) => (name === FILM ? turning(answer)
    : engine.download({ scene: answer.scene, files: blobs.listed(files), name, tool: CUTTER.includes(name) ? tool : undefined }));
  const names = answer.exports.flatMap(([, list]) => list).concat(answer.infeasible ? [] : [FILM]);
  const groups = sorted(names);
  const title = fileName(answer.name, versions.now().recording?.file);
  const own = engine.page ? page(`${title}.html`) : null;
  const item = (name) => html`<li>${link(name, () => made(name))}<small>${t(`studio-file-${name.replaceAll(".", "-")}`)}</small></li>`;
  const cutter = html`<p><label for="tool">${t("studio-tool")}</label>
    <input type="text" id="tool" size="8" value=${tool} @input=${(event) => { tool = event.target.value; }}></p>`;
  const group = ([intent, list]) => html`<section data-intent=${intent}><h3>${t(`studio-export-${intent}`)}</h3>
    <p class="lead">${t(`studio-export-${intent}-lead`)}</p><ul>${list.map(item)}${intent === "show" && own ? own.item : nothing}</ul>
    ${intent === "cut" && list.some((name) => CUTTER.includes(name)) ? cutter : nothing}${intent === "show" && own ? own.more : nothing}</section>`;
  URL.revokeObjectURL(preview);
  preview = "";
  const refresh = sheet("studio-export", "exports", () => html`<div class="whole">
    ${answer.infeasible ? nothing : html`<figure><img alt=${t("studio-export-preview")} src=${preview || nothing}></figure>`}
    <div>${all(title, groups.flatMap(([, list]) => list), made)}<p class="lead">${t("studio-export-tolerance")}</p></div></div>${groups.map(group)}`);
  if (answer.infeasible) return;
  made("cam.svg").then((blob) => {
    preview = URL.createObjectURL(blob);
    refresh();
  }, () => {});
}
