// Catalogue of laws with curves and factors. One of them can be selected for a segment.

import { html, svgTemplate, nothing } from "../core/dom.js";
import { t, number, language } from "../core/words.js";
import { closeDialog, sheet } from "../core/view.js";

// Title of a law in the language of the page. The hyphens of 3-4-5 are restored.
const titleOf = (law) => law.title[language()].replace(/(\d) (?=\d)/g, "$1-");

// Name of a law in the language of the page. A law with parameters is shown as written in the scene.
export function nameOf({ laws, dwell }, written) {
  if (written === "dwell") return dwell?.[language()] ?? written;
  const law = laws.find((one) => one.written === written || one.name === written);
  return law ? titleOf(law) : written;
}

// Curve as a small picture. For a fall, the picture is upside down.
export function curve(values, kind, isFall = false) {
  const [width, height] = [54, 24];
  const known = values.filter((v) => v !== null);
  const [low, high] = [Math.min(...known, 0), Math.max(...known, kind === "s" ? 1 : 0)];
  const y = (v) => height - 2 - ((isFall ? high + low - v : v) - low) / (high - low || 1) * (height - 4);
  const x = (i) => i / (values.length - 1) * (width - 2) + 1;
  const d = values.map((v, i) => (v === null ? "" : `${i ? "L" : "M"}${x(i).toFixed(1)} ${y(v).toFixed(1)}`)).join("");
  return svgTemplate`<svg class="small ${kind}" viewBox="0 0 ${width} ${height}" aria-hidden="true">
    <path class="zero" d="M0 ${y(0)}H${width}"></path><path class="curve" d=${d}></path></svg>`;
}

const KINDS = ["s", "v", "a", "j"];
const FACTORS = ["cv", "ca", "cj"];

function entry(law, chosen, take) {
  const factor = (k) => html`<td class="n">${law[k] === null ? "∞" : number(law[k])}</td>`;
  const use = () => {
    closeDialog();
    take(law.written);
  };
  return html`<tr class=${law.written === chosen ? "chosen" : ""}><th scope="row">${titleOf(law)}
      <small class="formula">${law.formula}</small><small class="advice">${law.advice[language()]}</small></th>
    ${KINDS.map((k) => html`<td>${curve(law[k], k)}</td>`)}${FACTORS.map(factor)}
    <td title=${[...new Set(law.joins[language()])].join(" → ")}>${law.vdi.join("–")}</td>
    <td>${take ? html`<button type="button" data-law=${law.name} aria-label="${t("studio-laws-use")}: ${titleOf(law)}"
      @click=${use}>${t("studio-laws-use")}</button>` : nothing}</td></tr>`;
}

export function catalogue(all, chosen, take) {
  const head = (text, kind = "") => html`<th scope="col" class=${kind}>${text}</th>`;
  sheet("studio-laws", "laws", () => html`<p class="lead">${t("studio-laws-lead")} ${t("studio-laws-vdi")}</p>
    <div class="scroll" tabindex="0"><table><thead><tr>${head(t("studio-column-motion"))}${KINDS.map((k) => head(k))}
      ${FACTORS.map((k) => head(`C${k[1]}`, "n"))}${head(t("studio-laws-joins"))}<th><span class="hidden">${t("studio-actions")}</span></th></tr></thead>
      <tbody>${all.laws.map((law) => entry(law, chosen, take))}</tbody></table></div>`);
}
