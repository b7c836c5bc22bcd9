(function () {
  var source = document.getElementById("motion");
  if (!source) return;
  var data = JSON.parse(source.textContent);
  var get = function (id) { return document.getElementById(id); };
  var parts = partsOf(document);
  var play = get("play"), angle = get("angle"), speed = get("speed");
  if (!parts["cam-turning"] || !play) return;
  var turns = data.turns, at = 0, running = false, last = 0;

  function text(id, v, digits, unit) {
    var cell = get(id);
    if (!cell) return;
    var shown = v === null ? "\u2014" : v.toFixed(digits);
    if (/^-0\.?0*$/.test(shown)) shown = shown.slice(1);
    if (document.documentElement.lang === "es") shown = shown.replace(".", ",");
    cell.textContent = v === null ? shown : shown.replace("-", "\u2212") + unit;
  }
  // A thin line in every diagram at the present angle.
  var cursors = Array.prototype.map.call(document.querySelectorAll("svg[data-left]"), function (svg) {
    var line = document.createElementNS("http://www.w3.org/2000/svg", "line");
    line.setAttribute("y1", svg.dataset.top);
    line.setAttribute("y2", svg.dataset.bottom);
    line.setAttribute("style", "stroke:var(--ink)");
    line.setAttribute("stroke-width", "1");
    line.setAttribute("class", "turning");
    svg.appendChild(line);
    return { line: line, left: +svg.dataset.left, right: +svg.dataset.right, turns: +(svg.dataset.turns || 1) };
  });
  function show(u) {
    at = u;
    var here = u - Math.floor(u) || (u > 0 && data.slide && u === turns ? 1 : 0);
    var theta = data.start + here * data.length;
    move(parts, data, u, theta);
    var now = function (list) { return value(data, list, u); };
    var shown = data.start + u * data.length;
    text("now-angle", shown, 1, data.angle_unit);
    text("now-lift", now(data.s), 3, (data.unit === "\u00b0" ? "" : " ") + data.unit);
    text("now-force", now(data.f), data.digits[0], " " + data.force_unit);
    text("now-torque", now(data.readings.torque), data.digits[1], data.slide && data.angle_unit !== "\u00b0" ? " N" : " N\u00b7m");
    text("now-gap", now(data.readings.gap), 3, (data.unit === "\u00b0" ? "" : " ") + data.unit);
    text("now-phi", now(data.readings.phi), 2, "\u00b0");
    text("now-rho", now(data.readings.rho), 2, " " + data.length_unit);
    angle.value = shown;
    cursors.forEach(function (c) {
      var part = (c.turns === 1 ? here : u / turns);
      var px = c.left + part * (c.right - c.left);
      c.line.setAttribute("x1", px);
      c.line.setAttribute("x2", px);
    });
  }
  function pace() {
    // The slider is logarithmic, from 1/200 of the true speed up to the true speed.
    return Math.pow(10, +speed.value);
  }
  function tell() {
    var p = pace();
    var said = get("pace");
    said.textContent = p > 0.999 ? said.dataset.full : "1/" + Math.round(1 / p) + " " + said.dataset.of;
  }
  function frame(now) {
    if (!running) return;
    var step = Math.min(now - last, 100) / 1000 * pace() / data.period;
    var u = at + (data.back ? -step : step);
    last = now;
    show(u - turns * Math.floor(u / turns));
    requestAnimationFrame(frame);
  }
  function run(on) {
    running = on;
    play.textContent = on ? play.dataset.pause : play.dataset.play;
    if (on) { last = performance.now(); requestAnimationFrame(frame); }
  }
  play.addEventListener("click", function () { run(!running); });
  angle.addEventListener("input", function () { run(false); show((+angle.value - data.start) / data.length); });
  speed.addEventListener("input", tell);
  speed.value = Math.max(-2.3, Math.min(0, Math.log10(data.period / 6)));
  tell();
  show(0);
  if (!window.matchMedia("(prefers-reduced-motion: reduce)").matches) run(true);
})();
