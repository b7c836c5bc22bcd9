// Sensitivity of a figure of the design as bars, and the trade-off front.

import { html, nothing, svgTemplate } from "../core/dom.js";
import { t } from "../core/words.js";
import * as units from "../core/units.js";
import { tickText, ticks } from "../charts/ticks.js";
import { label } from "./names.js";
import { ask, button, found, place } from "./asked.js";

const SHARE = 0.05;
// Size and margins of the picture of the front, px.
const [WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM] = [380, 240, 52, 14, 26, 36];
const ERROR = "force_rms_error_n";
let observed = ERROR;
let against = null;

const options = (names, chosen) => names.map((q) => html`<option value=${q} ?selected=${q === chosen}>${t(`figure-${q}`)}</option>`);

/** Sensitivity to the numbers of the scene, as bars. @param {{figures: [string, [string, number]][]}} start */
export function sensitivity(start) {
  const names = start.figures.map(([name]) => name);
  return html`<h2>${t("studio-sensitivity")}</h2><p class="lead">${t("studio-sensitivity-lead")}</p>
    <div class="buttons"><select id="quantity" aria-label=${t("studio-sensitivity-of")} @change=${(e) => { observed = e.target.value; }}>
      ${options(names, observed)}</select>
    ${button("vary", t("studio-sensitivity-do"), () => ask("sensitivity", "tornado", { quantity: observed, share: SHARE }))}</div>
    ${place("tornado", found("tornado") ? bars(found("tornado")) : nothing)}`;
}

function bars({ bars: list, middle, quantity, shown }) {
  if (list.length === 0) return html`<p>${t("studio-sensitivity-none")}</p>`;
  const ends = list.flatMap((b) => [b.low, b.high]).filter((x) => x !== null);
  const most = Math.max(...ends.map((x) => Math.abs(x - middle))) || 1;
  const side = (x, kind) => {
    const part = x === null ? 0 : 50 * (x - middle) / most;
    return html`<i class=${kind} style="left:${50 + Math.min(0, part)}%;width:${Math.abs(part)}%"></i>`;
  };
  const row = (bar) => html`<tr><th scope="row">${label(bar.key)}</th><td class="bar">${side(bar.low, "less")}${side(bar.high, "more")}</td>
    <td class="n">${units.text(`${bar.shown[0] ?? "–"} … ${bar.shown[1] ?? "–"}`)}</td></tr>`;
  return html`<p>${units.text(`${t(`figure-${quantity}`)}: ${shown}`)}</p><table class="tornado"><tbody>${list.map(row)}</tbody></table>
    <p class="key"><i class="less"></i>${t("studio-minus")} <i class="more"></i>${t("studio-plus")}</p>`;
}

/**
 * Trade-off between the force error and another quantity.
 * @param {{trades: string[], figures: [string, [string, number]][]}} start
 * @param {{answer: any, edit: (changes: object[]) => void}} seen
 */
export function front(start, { answer, edit }) {
  against ??= start.trades[0];
  const asked = () => ask("front", "front", { against });
  return html`<h2>${t("studio-front")}</h2><p class="lead">${t("studio-front-lead")}</p>
    <div class="buttons"><select id="against" aria-label=${t("studio-front-against")} @change=${(e) => { against = e.target.value; }}>
      ${options(start.trades, against)}</select>${button("trade", t("studio-front-do"), asked)}</div>
    ${place("front", found("front") ? points(found("front"), start, answer, edit) : nothing)}`;
}

// Linear scale that contains all values, with round ticks.
function scaleOf(values, from, to) {
  const [low, high] = [Math.min(...values), Math.max(...values)];
  const room = 0.04 * (high - low) || 0.5 * Math.abs(high) || 1;
  const [a, b] = [low === 0 ? 0 : low - room, high + room];
  return Object.assign((v) => from + (v - a) / (b - a) * (to - from), { ticks: ticks(a, b, 5) });
}

function points({ points: list, against: name, unit }, { figures }, answer, edit) {
  if (list.length === 0) return html`<p>${t("studio-front-none")}</p>`;
  const [, plain] = figures.find(([column]) => column === name)[1];
  const { [name]: x0, [ERROR]: y0 } = answer.numbers;
  const present = x0 === null || y0 === null ? null : { x: plain * x0, y: y0 };
  const all = present ? [...list, present] : list;
  const x = scaleOf(all.map((p) => p.x), LEFT, WIDTH - RIGHT);
  const y = scaleOf([0, ...all.map((p) => p.y)], HEIGHT - BOTTOM, TOP);
  const line = list.map((p, i) => `${i ? "L" : "M"}${x(p.x)} ${y(p.y)}`).join("");
  return html`<svg class="front" viewBox="0 0 ${WIDTH} ${HEIGHT}" role="group" aria-label=${t("studio-front")}>
    ${axes(x, y, `${t(`figure-${name}`)}, ${unit}`)}
    ${svgTemplate`<path class="line main" d=${line}/>${list.map((p) => knot(p, x, y, edit))}
      ${present ? svgTemplate`<path class="present" d=${cross(x(present.x), y(present.y))}/>` : nothing}`}</svg>
    ${present ? html`<p class="key"><span class="present">✕</span> ${t("studio-front-present")}</p>` : nothing}`;
}

const cross = (x, y) => `M${x - 6} ${y - 6}L${x + 6} ${y + 6}M${x - 6} ${y + 6}L${x + 6} ${y - 6}`;

function axes(x, y, name) {
  const [bottom, right] = [HEIGHT - BOTTOM, WIDTH - RIGHT];
  const text = (a, b, content, anchor) => svgTemplate`<text class="tick" x=${a} y=${b} text-anchor=${anchor}>${content}</text>`;
  const grid = [...x.ticks.map((v) => `M${x(v)} ${TOP}V${bottom}`), ...y.ticks.map((v) => `M${LEFT} ${y(v)}H${right}`)].join("");
  return svgTemplate`<path class="grid" d=${grid}/><path class="axis" d="M${LEFT} ${TOP}V${bottom}H${right}"/>
    ${x.ticks.map((v) => text(x(v), bottom + 14, tickText(v, x.ticks), "middle"))}
    ${y.ticks.map((v) => text(LEFT - 5, y(v) + 3.5, tickText(v, y.ticks), "end"))}
    ${text((LEFT + right) / 2, HEIGHT - 6, name, "middle")}${text(4, 14, `${t(`figure-${ERROR}`)}, N`, "start")}`;
}

function knot(p, x, y, edit) {
  const take = () => edit([{ set: { key: p.key, value: p.value } }]);
  const key = (event) => {
    if (event.key !== "Enter" && event.key !== " ") return;
    event.preventDefault();
    take();
  };
  const name = units.text(p.shown.join(", "));
  return svgTemplate`<circle class="knot ${p.verdict}" cx=${x(p.x)} cy=${y(p.y)} r="6" tabindex="0" role="button" aria-label=${name}
    @click=${take} @keydown=${key}><title>${name}</title></circle>`;
}

