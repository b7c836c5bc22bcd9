// One diagram over the cam angle: axes, curves, limits, cursor.

import { make, say, svg, clear, html, render, renew } from "../core/dom.js";
import { t, number, quantity } from "../core/words.js";
import * as clock from "../core/clock.js";
import * as handles from "./handles.js";
import { tickText, ticks } from "./ticks.js";

const RIGHT = 8;
const TOP = 6;

const pen = document.createElement("canvas").getContext("2d");

export class Chart {
  // Displayed curves, and the curves of pinned designs.
  /** @type {any} */ panel;
  /** @type {any} */ curves;
  /** @type {any[]} */ pinned;
  // Ends of the vertical axis, and their unit.
  /** @type {[number, number]} */ ends;
  /** @type {string} */ endsOf;
  isMoving = false;
  // Functions that charts.js sets for user actions on the diagram.
  /** @type {Function} */ onEnlarge;
  /** @type {Function} */ onResize;
  /** @type {Function} */ onZoom;
  /** @type {Function} */ onSay;
  /** @type {Function} */ onLimit;
  /** @type {Function} */ onSegment;
  /** @type {Function} */ onKnot;
  /** @type {(key: string) => string} */ labelOf;
  /** @type {(chart: Chart) => Element[]} */ overlay;

  constructor(id) {
    this.id = id;
    this.value = make("output", { class: "value" });
    this.named = make("span");
    this.unit = make("span");
    this.title = make("button", { type: "button", class: "enlarge", onclick: () => this.onEnlarge?.(this.id) }, this.named, this.unit);
    this.heading = make("h2", {}, this.title);
    this.picture = svg("svg", { role: "group" });
    // The keyboard can move the cursor.
    this.picture.setAttribute("tabindex", "0");
    this.fields = {};
    this.root = make("figure", { class: `chart ${id}`, "data-chart": id },
      make("figcaption", {}, this.heading, this.value), make("div", { class: "plot" }, this.picture));
    // The cursor is a separate element over the picture. It moves in every frame, and the picture need not be drawn again.
    this.cursor = make("div", { class: "cursor" });
    this.dot = make("div", { class: "dot" });
    // Axes and numbers are in a separate picture behind the curves, so that they are not laid out again with every curve.
    this.frame = svg("g");
    this.lines = svg("g");
    this.handles = svg("g");
    this.over = svg("g");
    this.behind = svg("svg", { class: "frame", "aria-hidden": "true" }, this.frame);
    this.picture.append(this.lines, this.handles, this.over);
    this.picture.after(this.behind, this.cursor, this.dot);
    // Names of the pinned designs.
    this.legend = make("div", { class: "names" });
    this.root.append(this.legend);
    this.size = [0, 0];
    this.left = 40;
    new ResizeObserver(() => this.resize()).observe(this.picture);
    this.drag();
  }

  resize() {
    const { width, height } = this.picture.getBoundingClientRect();
    if (Math.abs(width - this.size[0]) < 1 && Math.abs(height - this.size[1]) < 1) return;
    this.size = [width, height];
    this.font = getComputedStyle(this.behind).font;
    this.onResize?.();
    this.draw();
    this.follow();
  }

  // Sets the curves of the diagram. `pinned` contains the designs for comparison, each with curves and a colour. The cursor follows the
  // clock.
  take(curves, panel, pinned) {
    Object.assign(this, { curves, panel, pinned });
    say(this.named, this.name());
    say(this.unit, `, ${panel.unit}`);
    this.title.title = t("studio-enlarge");
    const list = pinned.filter((p) => p.colour && this.root.classList.contains("large"));
    render(list.map(({ colour, name }) => html`<span><i style="border-color:${colour}"></i>${name}</span>`), this.legend);
  }

  // Width of the numbers on the vertical axis, px.
  room() {
    const [width, height] = this.size;
    if (!this.panel || width < 20) return 0;
    const [low, high] = this.range();
    const rows = this.rows(low, high, height - (this.root.classList.contains("labelled") ? 18 : 6));
    pen.font = this.font;
    return Math.ceil(rows.reduce((most, y) => Math.max(most, pen.measureText(tickText(y, rows)).width), 0)) + 8;
  }

  rows(low, high, bottom) {
    return ticks(low, high, Math.max(3, Math.min(9, (bottom - TOP) / 30)));
  }

  name() {
    const alone = this.id === "force" && !this.panel.lines.some((l) => l.role === "target");
    const name = t(alone ? "studio-chart-force-alone" : `studio-chart-${this.id}`);
    if (this.panel.isDifference) return `Δ ${name}`;
    if (this.id !== "speed") return name;
    const speeds = this.panel.lines[0].y;
    const ripple = (Math.max(...speeds) - Math.min(...speeds)) / this.panel.levels[0].y;
    return t("studio-chart-ripple", { ripple: quantity(100 * ripple, "%", 3) });
  }

  range() {
    // The axis stays unchanged while a limit or point is dragged.
    if (this.held?.range) return this.held.range;
    let low = Infinity;
    let high = -Infinity;
    const take = (y) => {
      if (y === null) return;
      if (y < low) low = y;
      if (y > high) high = y;
    };
    const seen = ({ theta, from, span }, { y }) => y.forEach((v, i) => {
      if (theta[i] >= from - 1e-9 && theta[i] <= from + span + 1e-9) take(v);
    });
    for (const line of this.panel.lines) seen(this.curves, line);
    for (const other of this.pinned) other.panel.lines.filter((l) => l.role === "main").forEach((l) => seen(other.curves, l));
    if (low > high) [low, high] = [0, 1];
    const span = high - low;
    // While a value is being changed, the axis stays unchanged if the curve still fits it well. Only the curve then moves.
    const [a, b] = this.ends ?? [0, 0];
    if (this.isMoving && this.endsOf === this.panel.unit && low >= a && high <= b && span > 0.5 * (b - a)) return this.ends;
    // A limit far from the curve is ignored, because it would flatten the curve.
    for (const { y: level } of this.panel.levels) if (level > low - 0.8 * span && level < high + 0.8 * span) take(level);
    if (["force", "s"].includes(this.id) && low > 0 && low < 0.6 * high) low = 0;
    if (high - low < 1e-9 * Math.max(Math.abs(high), 1e-9)) { low -= 1; high += 1; }
    const room = 0.07 * (high - low);
    return [low === 0 ? 0 : low - room, high + room];
  }

  draw() {
    const [width, height] = this.size;
    if (!this.panel || width < 20) return;
    const view = `0 0 ${width} ${height}`;
    for (const picture of [this.picture, this.behind]) if (picture.getAttribute("viewBox") !== view) picture.setAttribute("viewBox", view);
    const labels = this.root.classList.contains("labelled");
    const bottom = height - (labels ? 18 : 6);
    const { from, span } = this.curves;
    const [low, high] = this.range();
    Object.assign(this, { ends: [low, high], endsOf: this.panel.unit });
    this.x = (theta) => this.left + (theta - from) / span * (width - this.left - RIGHT);
    this.back = (py) => low + (bottom - py) / (bottom - TOP) * (high - low);
    this.y = (y) => bottom - (y - low) / (high - low) * (bottom - TOP);
    this.bottom = bottom;
    this.cursor.style.height = `${bottom - TOP}px`;
    renew(this.frame, this.grid(width, bottom, low, high, labels));
    const list = this.pinned.map((other) => this.other(other));
    const [lower, upper] = ["low", "high"].map((role) => this.panel.lines.find((l) => l.role === role));
    if (lower && upper) list.push(["path", { class: "band", d: this.band(lower.y, upper.y) }]);
    for (const role of ["target", "worst", "main"]) {
      const line = this.panel.lines.find((l) => l.role === role);
      if (line) list.push(["path", { class: `line ${role}`, d: this.path(this.curves.theta, line.y, this.x) }]);
    }
    renew(this.lines, list);
    handles.draw(this, this.handles, { left: this.left, right: RIGHT, top: TOP, bottom, width });
    clear(this.over);
    if (this.overlay && !this.panel.isDifference) this.over.append(...this.overlay(this));
    this.describe();
  }

  // Axes, grid and numbers as a list for `renew`.
  grid(width, bottom, low, high, labels) {
    const texts = [];
    const { from: start, span: length, unit } = this.curves;
    const rows = this.rows(low, high, bottom);
    const lines = { axis: "", grid: "" };
    for (const y of rows) {
      const at = this.y(y);
      lines[y === 0 ? "axis" : "grid"] += `M${this.left} ${at}H${width - RIGHT}`;
      texts.push(["text", { class: "tick up", x: this.left - 5, y: at + 3.5, "text-anchor": "end" }, tickText(y, rows)]);
    }
    const columns = unit === "°" && length > 100 ? [0, 1, 2, 3, 4].map((k) => start + k * length / 4) : ticks(start, start + length, 4);
    for (const x of columns) {
      const at = this.x(x);
      lines.grid += `M${at} ${TOP}V${bottom}`;
      if (!labels) continue;
      const text = `${number(x, 3)}${unit === "°" ? "°" : ""}`;
      texts.push(["text", { class: "tick", x: at, y: bottom + 13, "text-anchor": at > width - 24 ? "end" : "middle" }, text]);
    }
    return [["path", { class: "grid", d: lines.grid }], ["path", { class: "axis", d: lines.axis }], ...texts];
  }

  other({ curves, panel, colour }) {
    const line = panel.lines.find((l) => l.role === "main");
    const [a, b] = [this.left, this.size[0] - this.left - RIGHT];
    const x = (theta) => a + (theta - curves.from) / curves.span * b;
    return ["path", { class: colour ? "line pinned" : "line ghost", ...(colour ? { style: `stroke:${colour}` } : {}), d: this.path(curves.theta, line.y, x) }];
  }

  path(thetas, values, x) {
    let d = "";
    let pen = "M";
    let [drawn, last] = [null, null];
    const [left, right] = [this.left - 0.5, this.size[0] - RIGHT + 0.5];
    const to = (p) => {
      d += `${pen}${Math.round(10 * p[0]) / 10} ${Math.round(10 * p[1]) / 10}`;
      pen = "L";
      drawn = p;
      last = null;
    };
    for (let i = 0; i < values.length; i += 1) {
      const at = x(thetas[i]);
      if (values[i] === null || at < left || at > right) {
        if (last) to(last);
        pen = "M";
        continue;
      }
      const p = [at, this.y(values[i])];
      // Points less than one pixel from the last one are skipped. The ends of the curve are always drawn.
      if (pen === "L" && Math.abs(p[0] - drawn[0]) < 1 && Math.abs(p[1] - drawn[1]) < 1) last = p;
      else to(p);
    }
    if (last) to(last);
    return d;
  }

  band(lower, upper) {
    const { theta } = this.curves;
    const back = theta.map((_, i) => theta.length - 1 - i);
    return `${this.path(theta, upper, this.x)}L${this.path(back.map((i) => theta[i]), back.map((i) => lower[i]), this.x).slice(1)}Z`;
  }

  describe() {
    const main = this.panel.lines.find((l) => l.role === "main").y.filter((y) => y !== null);
    const low = main.reduce((m, y) => Math.min(m, y), Infinity);
    const high = main.reduce((m, y) => Math.max(m, y), -Infinity);
    this.picture.setAttribute("aria-label", t("studio-chart-alt", {
      name: this.name(), low: quantity(low, this.panel.unit), high: quantity(high, this.panel.unit),
    }));
  }

  // Index of the sample nearest to the angle of the cursor.
  index(theta) {
    const list = this.curves.theta;
    let [low, high] = [0, list.length - 1];
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (list[middle] <= theta) low = middle;
      else high = middle;
    }
    return theta - list[low] < list[high] - theta ? low : high;
  }

  follow() {
    if (!this.panel || !this.x) return;
    const theta = clock.angle();
    const at = this.x(theta).toFixed(1);
    const inside = this.isSeen(theta);
    this.cursor.style.transform = inside ? `translate(${at}px, ${TOP}px)` : "scale(0)";
    const i = this.index(theta);
    const main = this.panel.lines.find((l) => l.role === "main").y[i];
    const target = this.panel.lines.find((l) => l.role === "target")?.y[i];
    this.dot.style.transform = main === null || !inside ? "scale(0)" : `translate(${at}px, ${this.y(main).toFixed(1)}px)`;
    say(this.value, target === undefined ? number(main) : `${number(main)} / ${number(target)}`);
  }

  isSeen(theta) {
    const { from, span } = this.curves;
    return theta >= from - 1e-9 && theta <= from + span + 1e-9;
  }

  // Picture in a size for paper, with labelled axes and without the elements that can be dragged.
  copy() {
    const { size, font } = this;
    Object.assign(this, { size: [340, 170], font: `10.5px ${font.slice(font.indexOf("px") + 2)}` });
    this.root.classList.add("labelled");
    this.left = this.room();
    this.draw();
    Object.assign(this, { size, font });
    const picture = this.picture.cloneNode(true);
    picture.removeAttribute("tabindex");
    picture.prepend(this.frame.cloneNode(true));
    for (const e of picture.querySelectorAll(".grip, .knot, .border")) e.remove();
    return picture;
  }

  // Angle and value under the pointer.
  under(event) {
    const box = this.picture.getBoundingClientRect();
    const part = (event.clientX - box.left - this.left) / (box.width - this.left - RIGHT);
    return [this.curves.from + Math.max(0, Math.min(1, part)) * this.curves.span, this.back(event.clientY - box.top)];
  }

  drag() {
    this.picture.addEventListener("pointerdown", (event) => {
      if (!this.curves) return;
      clock.play(false);
      this.picture.setPointerCapture(event.pointerId);
      const { limit, segment, knot } = event.target.dataset ?? {};
      const gesture = `${limit ?? segment ?? knot ?? "cursor"} ${event.timeStamp}`;
      this.held = { limit, segment: Number(segment) || 0, knot, begins: true, gesture, range: limit || segment || knot ? this.ends : null };
      this.move(event);
    });
    this.picture.addEventListener("pointermove", (event) => { if (this.held) this.move(event); });
    const release = () => {
      const held = this.held;
      this.held = null;
      if (held?.range) this.draw();
    };
    this.picture.addEventListener("pointerup", release);
    this.picture.addEventListener("pointercancel", release);
    this.picture.addEventListener("keydown", (event) => this.key(event));
    this.picture.addEventListener("wheel", (event) => {
      if (!event.ctrlKey || !this.curves) return;
      event.preventDefault();
      this.onZoom(1.002 ** Math.max(-400, Math.min(400, event.deltaY)), this.under(event)[0]);
    }, { passive: false });
    this.picture.addEventListener("dblclick", (event) => this.onZoom(this.curves.span < this.curves.length ? null : 0.25, this.under(event)[0]));
  }

  move(event) {
    const [theta, y] = this.under(event);
    const { limit, segment, knot, begins, gesture } = this.held;
    this.held.begins = false;
    if (limit) this.onLimit(limit, handles.valueOf(this, y, limit), gesture);
    else if (segment) this.onSegment(handles.moveSegment(this, segment, theta, y), gesture);
    else if (knot) this.onKnot(Number(knot), (theta - this.curves.start) / this.curves.length, y, begins);
    else clock.set(theta);
  }

  key(event) {
    if (event.target !== this.picture || !this.curves) return;
    const factor = { "+": 0.5, "=": 0.5, "-": 2, 0: null }[event.key];
    if (factor !== undefined && !event.ctrlKey && !event.metaKey) this.onZoom(factor, clock.angle());
    const step = this.curves.span / (event.shiftKey ? 36 : 360);
    const by = { ArrowRight: step, ArrowUp: step, ArrowLeft: -step, ArrowDown: -step }[event.key];
    if (!by && event.key !== "Home") return;
    event.preventDefault();
    clock.play(false);
    clock.set(by ? clock.angle() + by : this.curves.start);
    const i = this.index(clock.angle());
    const main = this.panel.lines.find((l) => l.role === "main").y[i];
    this.onSay?.(`${quantity(clock.angle(), this.curves.unit)}: ${quantity(main, this.panel.unit)}`);
  }
}
