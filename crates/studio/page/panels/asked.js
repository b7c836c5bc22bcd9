// Requests about the displayed design, with the scene of each response.

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

// Displayed scene with its files.
const present = () => ({ scene: designs.present().answer.scene, files: blobs.listed(designs.present().files) });

/** Last response to a request; null before the first. @param {string} name */
export const found = (name) => answers.get(name)?.found ?? null;

/** Whether the response belongs to a design that is no longer displayed. @param {string} name */
export const isStale = (name) => answers.has(name) && answers.get(name).of !== JSON.stringify(present());

/** Whether a request is being processed. @param {string} name */
export const isRunning = (name) => running.has(name);

/**
 * Sends a request about the displayed design. A fault is shown as a notice.
 * @param {string} route @param {string} name @param {object} [question] @param {object} [more] Data that are stored with the response.
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

/** Button that sends a request. @param {string} id @param {string} text @param {() => void} action */
export const button = (id, text, action) =>
  html`<button type="button" id=${id} ?disabled=${running.has(id)} @click=${action}>${text}</button>`;

/** Element for a response. The response for an earlier design is dimmed. @param {string} id @param {unknown} content */
export const place = (id, content) => html`<div id=${id} class=${isStale(id) ? "stale" : ""}>${content}</div>`;
