// Animation of the cam: positions of the parts of its drawing after u turns. The report and the studio use this module.

// Value of a sampled quantity by linear interpolation; null if a neighbouring sample is null.
export function value({ turns }, list, u) {
  const x = u / turns * (list.length - 1);
  const i = Math.min(Math.floor(x), list.length - 2);
  const [a, b] = [list[i], list[i + 1]];
  return a === null || b === null ? null : a + (x - i) * (b - a);
}

// Angle in degrees, interpolated along the shorter way around the circle.
function turned({ turns }, list, u) {
  const x = u / turns * (list.length - 1);
  const i = Math.min(Math.floor(x), list.length - 2);
  return list[i] + (x - i) * ((((list[i + 1] - list[i]) % 360) + 540) % 360 - 180);
}

// Moving parts of a drawing by their ids.
export function partsOf(drawing) {
  return Object.fromEntries(["cam-turning", "cam-follower", "cam-second", "cam-push", "cam-contact"].map((id) => [id, drawing.querySelector(`#${id}`)]));
}

// Moves the parts: rotates the cam to the angle theta, and places the follower, the contact and the force as after u turns.
export function move(parts, motion, u, theta) {
  const at = (list) => value(motion, list, u);
  const stand = (part, x, y, a) => part.setAttribute("transform", `translate(${at(x)} ${at(y)}) rotate(${turned(motion, a, u)})`);
  parts["cam-turning"].setAttribute("transform", motion.slide ? `translate(${-theta * motion.slide} 0)` : `rotate(${theta})`);
  stand(parts["cam-follower"], motion.px, motion.py, motion.pa);
  if (parts["cam-second"]) stand(parts["cam-second"], motion.qx, motion.qy, motion.qa);
  const [contact, push] = [parts["cam-contact"], parts["cam-push"]];
  const [x, y, force] = [motion.cx, motion.cy, motion.f].map(at);
  const touching = x !== null;
  motion.most ??= motion.f.reduce((m, f) => Math.max(m, Math.abs(f)), 0) || 1;
  contact.setAttribute("visibility", touching ? "visible" : "hidden");
  push.setAttribute("visibility", touching && Math.abs(force) > 0.01 * motion.most ? "visible" : "hidden");
  if (!touching) return;
  contact.setAttribute("cx", x);
  contact.setAttribute("cy", y);
  const size = force / motion.most * push.dataset.reach;
  push.setAttribute("transform", `translate(${x} ${y}) rotate(${turned(motion, motion.push, u)}) scale(${size})`);
}
