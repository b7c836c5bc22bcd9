(function () {
  "use strict";
  var data = JSON.parse(document.getElementById("motion").textContent);
  var get = function (id) { return document.getElementById(id); };
  var cam = get("cam-turning"), follower = get("cam-follower"), contact = get("cam-contact");
  var play = get("play"), angle = get("angle"), speed = get("speed");
  if (!cam || !play) return;
  var n = data.s.length - 1, turn = data.length, at = 0, running = false, last = 0;

  // Value of a sampled quantity at the share u of the cycle; null where it has none.
  function value(list, u) {
    var x = u * n, i = Math.min(Math.floor(x), n - 1), f = x - i;
    var a = list[i], b = list[i + 1];
    return a === null || b === null ? null : a + f * (b - a);
  }
  function text(id, v, digits, unit) {
    var cell = get(id);
    if (!cell) return;
    cell.textContent = v === null ? "\u2014" : v.toFixed(digits).replace("-", "\u2212") + unit;
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
    return { line: line, left: +svg.dataset.left, right: +svg.dataset.right };
  });

  function show(u) {
    at = u;
    var theta = data.start + u * turn;
    cam.setAttribute("transform", "rotate(" + theta + ")");
    var x = value(data.px, u), y = value(data.py, u), a = value(data.pa, u);
    follower.setAttribute("transform", "translate(" + x + " " + y + ") rotate(" + a + ")");
    contact.setAttribute("cx", value(data.cx, u));
    contact.setAttribute("cy", value(data.cy, u));
    text("now-angle", theta, 1, "\u00b0");
    text("now-lift", value(data.s, u), 3, " " + data.unit);
    text("now-force", value(data.f, u), 1, " N");
    text("now-phi", value(data.phi, u), 2, "\u00b0");
    text("now-rho", value(data.rho, u), 2, " mm");
    angle.value = theta;
    cursors.forEach(function (c) {
      var px = c.left + u * (c.right - c.left);
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
    get("pace").textContent = p > 0.999 ? "true speed" : "1/" + Math.round(1 / p) + " of true speed";
  }
  function frame(now) {
    if (!running) return;
    var u = at + Math.min(now - last, 100) / 1000 * pace() / data.period;
    last = now;
    show(u - Math.floor(u));
    requestAnimationFrame(frame);
  }
  function run(on) {
    running = on;
    play.textContent = on ? "Pause" : "Play";
    if (on) { last = performance.now(); requestAnimationFrame(frame); }
  }
  play.addEventListener("click", function () { run(!running); });
  angle.addEventListener("input", function () { run(false); show((+angle.value - data.start) / turn); });
  speed.addEventListener("input", tell);
  speed.value = Math.max(-2.3, Math.min(0, Math.log10(data.period / 6)));
  tell();
  show(0);
  if (!window.matchMedia("(prefers-reduced-motion: reduce)").matches) run(true);
})();
