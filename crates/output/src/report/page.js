(function () {
  "use strict";
  var source = document.getElementById("motion");
  if (!source) return;
  var data = JSON.parse(source.textContent);
  var get = function (id) { return document.getElementById(id); };
  var cam = get("cam-turning"), follower = get("cam-follower"), second = get("cam-second");
  var contact = get("cam-contact"), push = get("cam-push");
  var play = get("play"), angle = get("angle"), speed = get("speed");
  if (!cam || !play) return;
  var turns = data.turns, n = (data.s.length - 1) / turns, at = 0, running = false, last = 0;
  var most = data.f.reduce(function (m, f) { return Math.max(m, Math.abs(f)); }, 0) || 1;

  // Value of a sampled quantity after u turns; null where it has none.
  function value(list, u) {
    var x = u * n, i = Math.min(Math.floor(x), list.length - 2), f = x - i;
    var a = list[i], b = list[i + 1];
    return a === null || b === null ? null : a + f * (b - a);
  }
  // Angles go the short way where they wrap.
  function turned(list, u) {
    var x = u * n, i = Math.min(Math.floor(x), list.length - 2), f = x - i;
    var d = ((list[i + 1] - list[i]) % 360 + 540) % 360 - 180;
    return list[i] + f * d;
  }
  function text(id, v, digits, unit) {
    var cell = get(id);
    if (!cell) return;
    var shown = v === null ? "\u2014" : v.toFixed(digits);
    if (/^-0\.?0*$/.test(shown)) shown = shown.slice(1);
    if (document.documentElement.lang === "es") shown = shown.replace(".", ",");
    cell.textContent = v === null ? shown : shown.replace("-", "\u2212") + unit;
  }
  // A thin line across every diagram at the present angle.
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
  function stand(part, x, y, a) {
    part.setAttribute("transform", "translate(" + x + " " + y + ") rotate(" + a + ")");
  }

  function show(u) {
    at = u;
    var here = u - Math.floor(u) || (u > 0 && data.slide && u === turns ? 1 : 0);
    var theta = data.start + here * data.length;
    cam.setAttribute("transform", data.slide
      ? "translate(" + -theta * data.slide + " 0)" : "rotate(" + theta + ")");
    stand(follower, value(data.px, u), value(data.py, u), turned(data.pa, u));
    if (second) stand(second, value(data.qx, u), value(data.qy, u), turned(data.qa, u));
    var x = value(data.cx, u), y = value(data.cy, u), f = value(data.f, u);
    var touching = x !== null;
    contact.setAttribute("visibility", touching ? "visible" : "hidden");
    push.setAttribute("visibility", touching && Math.abs(f) > 0.01 * most ? "visible" : "hidden");
    if (touching) {
      contact.setAttribute("cx", x);
      contact.setAttribute("cy", y);
      var size = f / most * push.dataset.reach;
      push.setAttribute("transform", "translate(" + x + " " + y + ") rotate(" + turned(data.push, u) + ") scale(" + size + ")");
    }
    var shown = data.start + u * data.length;
    text("now-angle", shown, 1, data.angle_unit);
    text("now-lift", value(data.s, u), 3, (data.unit === "\u00b0" ? "" : " ") + data.unit);
    text("now-force", f, data.digits[0], " " + data.force_unit);
    text("now-torque", value(data.readings.torque, u), data.digits[1], data.slide && data.angle_unit !== "\u00b0" ? " N" : " N\u00b7m");
    text("now-gap", value(data.readings.gap, u), 3, (data.unit === "\u00b0" ? "" : " ") + data.unit);
    text("now-phi", value(data.readings.phi, u), 2, "\u00b0");
    text("now-rho", value(data.readings.rho, u), 2, " mm");
    angle.value = shown;
    cursors.forEach(function (c) {
      var part = (c.turns === 1 ? here : u / turns);
      var px = c.left + part * (c.right - c.left);
      c.line.setAttribute("x1", px);
      c.line.setAttribute("x2", px);
    });
  }
  function pace() {
    // The slider is logarithmic: from a two-hundredth of the true speed up to it.
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
