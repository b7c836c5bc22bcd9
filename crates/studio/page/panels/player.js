// Controls of the animation: start, speed and direction.

import { $, html, render, say } from "../core/dom.js";
import { t, onLanguage } from "../core/words.js";
import * as clock from "../core/clock.js";

const PACES = [1, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01];

export function load() {
  const paint = () => {
    say($("play"), clock.isPlaying() ? "❚❚" : "▶");
    $("play").setAttribute("aria-label", t(clock.isPlaying() ? "studio-pause" : "studio-play"));
    $("reverse").setAttribute("aria-pressed", String(clock.isBackwards()));
  };
  const paces = () => {
    const before = $("pace").value;
    const name = (p) => (p === 1 ? t("studio-true-speed") : t("studio-of-speed", { share: Math.round(1 / p) }));
    render(PACES.map((p) => html`<option value=${p}>${name(p)}</option>`), $("pace"));
    if (before) $("pace").value = before;
  };
  clock.onPlay(paint);
  onLanguage(() => { paint(); paces(); });
  paint();
  paces();
  $("play").addEventListener("click", () => clock.play(!clock.isPlaying()));
  $("reverse").addEventListener("click", clock.reverse);
  $("pace").addEventListener("change", () => clock.setPace(Number($("pace").value)));
  $("angle").addEventListener("input", () => { clock.play(false); clock.set(Number($("angle").value)); });
}

// Starts the animation of a new cam, with one turn in about five seconds.
export function begin(motion) {
  clock.set(motion.start);
  const wanted = motion.period / 5;
  const pace = PACES.reduce((best, p) => (Math.abs(Math.log(p / wanted)) < Math.abs(Math.log(best / wanted)) ? p : best));
  $("pace").value = String(pace);
  clock.setPace(pace);
  clock.play(!window.matchMedia("(prefers-reduced-motion: reduce)").matches);
}
