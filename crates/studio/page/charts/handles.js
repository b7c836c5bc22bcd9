// Elements of a diagram that can be dragged: limit lines, and borders and lifts of the segments of a programme.

import { svg, clear } from "../core/dom.js";
import { t, quantity, language } from "../core/words.js";

// Unit as written in a scene file.
export const written = (unit) => unit.replace("°", "deg").replaceAll("·", " ").replace("²", "^2").replace("³", "^3");

// Number with three digits, the precision of dragging on a screen.
export const rounded = (x) => Number(x.toPrecision(3));

// Draws the elements of a diagram that can be dragged, if they have changed.
export function draw(chart, group, place) {
  const lines = chart.panel.levels;
  const knots = knotsOf(chart);
  const { ends, curves: { from, span }, panel: { unit } } = chart;
  const seen = JSON.stringify([lines, knots, place, ends, from, span, unit, language(), Boolean(chart.onLimit)]);
  if (seen === chart.handled) return;
  chart.handled = seen;
  clear(group);
  drawLimits(chart, group, lines, place);
  drawKnots(chart, group, knots, place);
}

// Draws the limit lines. Each line is a slider that the arrow keys also move.
function drawLimits(chart, plot, lines, { left, right, top, bottom, width }) {
  for (const { y: level, key } of lines) {
    const at = chart.y(level);
    if (at < top - 1 || at > bottom + 1) continue;
    plot.append(svg("path", { class: "level", d: `M${left} ${at}H${width - right}` }));
    if (!key || !chart.onLimit) continue;
    const name = t("studio-limit-line", { name: chart.labelOf(key), low: quantity(level, chart.panel.unit) });
    const grip = svg("path", { class: "grip", d: `M${left} ${at}H${width - right}`, "data-limit": key, tabindex: "0", role: "slider", "aria-label": name,
      "aria-valuenow": level, "aria-orientation": "vertical", "aria-valuetext": quantity(level, chart.panel.unit) });
    const title = svg("title");
    title.textContent = name;
    grip.append(title);
    grip.addEventListener("keydown", (event) => {
      const step = { ArrowUp: 0.01, ArrowDown: -0.01, PageUp: 0.1, PageDown: -0.1 }[event.key];
      if (!step) return;
      event.preventDefault();
      event.stopPropagation();
      chart.onLimit(key, valueOf(chart, level + step * Math.abs(level || 1), key), `line ${key}`);
      chart.refocus = key;
    });
    plot.append(grip);
    if (chart.refocus === key) grip.focus();
  }
}

// Value of the key of a limit for a line at this height.
export function valueOf(chart, y, key) {
  const from = chart.panel.levels.find((l) => l.key === key)?.from ?? null;
  return `${rounded(from === null ? y : Math.abs(y - from))} ${written(chart.panel.unit)}`;
}

// Ends of the segments of a programme: [{number, theta, lift}].
export function borders(fields, start) {
  const out = [];
  let theta = start;
  let lift = 0;
  for (let n = 1; fields[`law.segment.${n}.angle`]; n += 1) {
    theta += parseFloat(fields[`law.segment.${n}.angle`].text) || 0;
    lift += parseFloat(fields[`law.segment.${n}.lift`]?.text) || 0;
    out.push({ number: n, theta, lift });
  }
  return out;
}

// Whether all angles are in degrees and all lifts in the unit of the diagram. Other values can be changed only in the table.
function plain(fields, unit) {
  const wrong = Object.entries(fields).some(([key, { text }]) => /^law\.segment\.\d+\.(angle|lift)$/.test(key) && text && !new RegExp(`^[-+\\d.]+ (deg|${unit})$`).test(text));
  return !wrong;
}

// Borders that can be dragged: [{number, theta, lift}], with lifts above the lowest one.
function knotsOf(chart) {
  if (chart.id !== "s" || !chart.onSegment || chart.curves.unit !== "°" || !plain(chart.fields, written(chart.panel.unit))) return [];
  const list = borders(chart.fields, chart.curves.start);
  const low = Math.min(0, ...list.map((b) => b.lift));
  return list.slice(0, -1).filter((b) => chart.isSeen(b.theta)).map((b) => ({ ...b, lift: b.lift - low }));
}

function drawKnots(chart, plot, knots, { top, bottom }) {
  for (const border of knots) {
    const [x, y] = [chart.x(border.theta), chart.y(border.lift)];
    plot.append(svg("path", { class: "border", d: `M${x} ${top}V${bottom}` }));
    plot.append(svg("circle", { class: "knot segment", cx: x, cy: y, r: 5, "data-segment": border.number, role: "img", "aria-label": t("studio-segment-end", { number: border.number }) }));
  }
}

// Moves a border between its neighbours. A change of the lift is subtracted from the next moving segment, so that the sum of the lifts
// stays 0.
export function moveSegment(chart, number, theta, lift) {
  const { fields } = chart;
  const list = borders(fields, chart.curves.start);
  const at = list[number - 1];
  const [before, after] = [list[number - 2]?.theta ?? chart.curves.start, list[number].theta];
  const angle = Math.round(Math.max(before + 1, Math.min(after - 1, theta)));
  const unit = written(chart.panel.unit);
  const edits = [[number, angle - before], [number + 1, after - angle]]
    .map(([n, x]) => ({ set: { key: `law.segment.${n}.angle`, value: `${Number(x.toFixed(6))} deg` } }));
  const change = rounded(lift) - at.lift;
  const liftOf = (n) => parseFloat(fields[`law.segment.${n}.lift`]?.text) || 0;
  const moving = list.map((b) => b.number).filter((n) => liftOf(n) !== 0);
  const own = moving.findLast((n) => n <= number);
  const next = moving.find((n) => n > number);
  if (own && next && change !== 0) {
    for (const [n, x] of [[own, liftOf(own) + change], [next, liftOf(next) - change]]) edits.push({ set: { key: `law.segment.${n}.lift`, value: `${Number(x.toFixed(6))} ${unit}` } });
  }
  return edits;
}

// Curves of a diagram as a table, at whole degrees, or at every hundredth of the travel.
export function table(chart) {
  const { curves, panel } = chart;
  const step = curves.unit === "°" ? 1 : curves.length / 100;
  const lines = panel.lines.filter((l) => ["main", "target"].includes(l.role));
  const rows = [];
  for (let theta = curves.start; theta <= curves.start + curves.length + 1e-9; theta += step) {
    const i = chart.index(theta);
    rows.push([theta, ...lines.map((l) => l.y[i])]);
  }
  return { lines, rows };
}
