// Questions about the design on the screen, and what each answer was computed from.

import { html, notice } from "../core/dom.js";
import { engine } from "../core/net.js";
import * as blobs from "../core/blobs.js";
import * as designs from "../core/designs.js";

const answers = new Map();
const running = new Set();
let redraw = () => {};

/** @param {() => void} again Draws the panel again. */
export function load(again) {
  redraw = again;
}

// The scene on the screen with its files.
const present = () => ({ scene: designs.present().answer.scene, files: blobs.listed(designs.present().files) });

/** The last answer to a question; null before the first. @param {string} name */
export const found = (name) => answers.get(name)?.found ?? null;

/** Whether the answer belongs to a design that is no longer on the screen. @param {string} name */
export const isStale = (name) => answers.has(name) && answers.get(name).of !== JSON.stringify(present());

/** Whether an answer is on its way. @param {string} name */
export const isRunning = (name) => running.has(name);

/**
 * Asks the engine about the design on the screen; a fault is shown as a notice.
 * @param {string} route @param {string} name @param {object} [question] @param {object} [more] Kept with the answer.
 */
export async function ask(route, name, question = {}, more = {}) {
  const of = present();
  running.add(name);
  redraw();
  try {
    answers.set(name, { found: { ...await engine.ask(route, { ...of, ...question }), ...more }, of: JSON.stringify(of) });
  } catch (error) {
    notice([error.place, error.message, error.help].filter(Boolean).join(" – "));
  } finally {
    running.delete(name);
    redraw();
  }
}

/** A button that asks. @param {string} id @param {string} text @param {() => void} action */
export const button = (id, text, action) =>
  html`<button type="button" id=${id} ?disabled=${running.has(id)} @click=${action}>${text}</button>`;

/** The place of an answer; one of an earlier design is dimmed. @param {string} id @param {unknown} content */
export const place = (id, content) => html`<div id=${id} class=${isStale(id) ? "stale" : ""}>${content}</div>`;
