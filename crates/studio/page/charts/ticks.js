// Round numbers on an axis, and their text.

import { language } from "../core/words.js";

// Round numbers between two ends: about `count`, at least two.
export function ticks(low, high, count) {
  const raw = (high - low) / Math.max(count, 1);
  if (!(raw > 0) || !Number.isFinite(raw)) return [];
  const power = 10 ** Math.floor(Math.log10(raw));
  const sizes = [0.25, 0.5, 1, 2, 2.5, 5, 10].map((k) => k * power);
  const inside = (size) => Math.floor(high / size + 1e-9) - Math.ceil(low / size - 1e-9) + 1;
  const step = sizes.findLast((s, k) => inside(s) >= 2 && (k === 0 || sizes[k - 1] < raw * 0.999)) ?? sizes[0];
  const out = [];
  for (let x = Math.ceil(low / step - 1e-9) * step; x <= high + 1e-9 * step; x += step) out.push(Math.abs(x) < step * 1e-9 ? 0 : x);
  return out;
}

export function tickText(x, all) {
  const step = all.length > 1 ? all[1] - all[0] : Math.abs(x) || 1;
  const decimals = Math.max(0, Math.min(6, -Math.floor(Math.log10(step) + 1e-9)));
  const fine = Math.abs(step * 10 ** decimals % 1) > 1e-6 ? decimals + 1 : decimals;
  if (Math.abs(x) >= 1e5) return x.toExponential(0).replace("+", "").replace("-", "−");
  const text = x.toFixed(fine).replace("-", "−");
  return language() === "es" ? text.replace(".", ",") : text;
}
