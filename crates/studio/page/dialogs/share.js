// The present scene for others: as a link, as a QR code, or as a page in a single file.

import { html, notice, svgTemplate } from "../core/dom.js";
import { t } from "../core/words.js";
import { engine } from "../core/net.js";
import { sheet } from "../core/view.js";
import { qrCode } from "../core/vendor.js";
import { pack } from "../core/packing.js";
import * as autosave from "../core/autosave.js";
import * as versions from "../core/versions.js";
import { download } from "./exports.js";

// Maximum length of the text in a QR code that a telephone can read from a screen, characters.
const LONGEST_CODE = 1800;
const BESIDE = 4;

export async function open() {
  const version = versions.now();
  if (!version) return;
  const link = await autosave.link(version);
  sheet("studio-link", "share", () => content(version, link));
}

function content(version, link) {
  return html`
    ${inside(link.inside)}
    <label for="share-link">${t(link.isOwn ? "studio-link-part" : "studio-link-whole", { length: link.text.length })}</label>
    <textarea id="share-link" rows="3" readonly @focus=${(event) => event.target.select()}>${link.text}</textarea>
    <button type="button" id="copy-link" class="main" @click=${() => copy(link)}>${t("studio-link-copy")}</button>
    ${code(link)}
    <h3>${t("studio-link-page")}</h3>
    ${engine.page ? html`<p><button type="button" id="share-page" @click=${() => save(version)}>${named(version)}</button>
      ${t("studio-link-page-holds")}</p>` : html`<p>${t("studio-link-no-page")}</p>`}`;
}

// Text about the content of the link for each file, shown before the link is copied.
function inside(files) {
  if (files.length === 0) return html`<p id="share-inside">${t("studio-link-scene")}</p>`;
  const line = ({ name, how }) => html`<li data-inside=${how} class=${how === "not" ? "bad" : ""}>${t(`studio-link-file-${how}`, { file: name })}</li>`;
  return html`<ul id="share-inside">${files.map(line)}</ul>`;
}

async function copy({ text, isOwn }) {
  try {
    await navigator.clipboard.writeText(text);
    notice(t(isOwn ? "studio-linked-part" : "studio-linked"));
  } catch {
    notice(t("studio-linked-address"));
  }
}

// QR code of a link. If the link is too long, a text with the maximum length replaces the code.
function code({ text, inside: files }) {
  if (text.length > LONGEST_CODE) {
    const what = files.length > 0 ? "studio-link-no-code-file" : "studio-link-no-code";
    return html`<p id="share-code">${t(what, { length: text.length, longest: LONGEST_CODE })}</p>`;
  }
  const { data, size } = qrCode(text, { border: BESIDE, ecc: "L" });
  const path = data.map((row, y) => row.map((isDark, x) => (isDark ? `M${x} ${y}h1v1h-1z` : "")).join("")).join("");
  return html`<svg id="share-code" class="code" viewBox="0 0 ${size} ${size}" role="img" aria-label=${t("studio-link-code")}>
    ${svgTemplate`<rect width=${size} height=${size} fill="#fff"></rect><path d=${path} fill="#000"></path>`}</svg>`;
}

const named = (version) => `${version.name || "scene"}.html`;

async function save(version) {
  try {
    download(await engine.page((await pack(version, true)).text), named(version));
  } catch (error) {
    notice(error.message);
  }
}
