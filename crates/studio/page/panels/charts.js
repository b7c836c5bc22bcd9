// All diagrams with one cursor.

import { $ } from "../core/dom.js";
import { Chart } from "./chart.js";
import * as clock from "../core/clock.js";
import { onLanguage } from "../core/words.js";

const charts = new Map();
let shown = null;
let pinned = [];

export function load() {
  clock.onAngle(() => { for (const chart of charts.values()) chart.follow(); });
  onLanguage(again);
}

export function show(curves) {
  shown = curves;
  const ids = curves.panels.map((p) => p.id);
  for (const [id, chart] of charts) {
    if (ids.includes(id)) continue;
    chart.root.remove();
    charts.delete(id);
  }
  curves.panels.forEach((panel, i) => {
    let chart = charts.get(panel.id);
    if (!chart) {
      chart = new Chart(panel.id);
      charts.set(panel.id, chart);
    }
    const at = $("charts").children[i];
    if (at !== chart.root) $("charts").insertBefore(chart.root, at ?? null);
    chart.root.classList.toggle("labelled", i === 0 || i >= ids.length - 2);
    const others = pinned.flatMap(({ curves: other, colour }) => {
      const same = other.panels.find((p) => p.id === panel.id && p.unit === panel.unit);
      return same ? [{ curves: other, panel: same, colour }] : [];
    });
    chart.show(curves, panel, others);
  });
}

// Designs to lie under the present one.
export function compare(list) {
  pinned = list;
  again();
}

function again() {
  if (!shown) return;
  show(shown);
  clock.set(clock.angle());
}
