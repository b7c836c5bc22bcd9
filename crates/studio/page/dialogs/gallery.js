// Built-in scenes by group, with their pictures. A search also finds scenes that no group contains.

import { html, nothing } from "../core/dom.js";
import { t, has, language } from "../core/words.js";
import { engine } from "../core/net.js";
import { closeDialog, sheet } from "../core/view.js";

const GROUPS = {
  force: ["footbridge", "measured_walk", "footbridge_double_harmonic", "footbridge_thesis_scale", "thesis_iteration_4"],
  heel: ["heel_tester", "heel_tester_fitted"],
  programme: ["camdas_01_roller", "camdas_03_flat", "camdas_09_eight_motions", "camdas_10_eccentric", "mushroom"],
  arm: ["camdas_02_oscillating_roller", "camdas_04_oscillating_flat", "camdas_11_oscillating_roller", "camdas_12_oscillating_flat"],
  pair: ["camdas_05_constant_diameter", "camdas_06_constant_breadth", "camdas_07_conjugate_roller", "camdas_08_conjugate_flat"],
  straight: ["thesis_barrel", "translating_cam"],
};

// Pictures of scenes, each requested once.
const pictures = new Map();

function asked(name) {
  const blob = ({ svg }) => URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" }));
  if (!pictures.has(name)) pictures.set(name, engine.ask("scene-picture", { name }).then(blob));
  return pictures.get(name);
}

// Requests a picture when its place becomes visible.
const near = new IntersectionObserver((entries) => {
  for (const { isIntersecting, target } of entries) {
    if (!isIntersecting) continue;
    near.unobserve(target);
    const image = /** @type {HTMLImageElement} */ (target);
    const { name } = image.dataset;
    asked(name).then((url) => { image.src = url; }, () => pictures.delete(name));
  }
});

function watchImages() {
  for (const image of document.querySelectorAll(".gallery img:not([src])")) near.observe(image);
}

const begun = (text) => text.charAt(0).toUpperCase() + text.slice(1);

// Title of a scene. For an example from a book, its number is at the end.
export function titled({ name, doc }) {
  const key = `studio-scene-${name}`;
  const whole = has(key) ? t(key) : doc[language()];
  const [source, ...rest] = whole.split(": ");
  return name.startsWith("camdas") ? [begun(rest.join(": ")), source] : [whole, ""];
}

const plain = (text) => text.toLowerCase().normalize("NFD").replace(/\p{M}/gu, "");

// Whether every search word is the start of a word in the name or the title. A number must match a whole word.
export function matches(scene, words) {
  const own = plain([scene.name, ...titled(scene)].join(" ")).split(/[^\p{L}\p{N}]+/u);
  const isFound = (word) => own.some((other) => (/^\d+$/.test(word) ? Number(other) === Number(word) : other.startsWith(word)));
  return plain(words).split(/[^\p{L}\p{N}]+/u).filter(Boolean).every(isFound);
}

function card(scene, openScene) {
  const [title, source] = titled(scene);
  const open = () => {
    closeDialog();
    openScene(scene.toml);
  };
  return html`<button type="button" class="card" data-scene=${scene.name} @click=${open}><img alt="" data-name=${scene.name}>
    <b>${title}</b><span>${source}</span></button>`;
}

export function open(scenes, openScene) {
  let words = "";
  const of = (name) => scenes.find((scene) => scene.name === name);
  const group = (name, list) => (list.length === 0 ? nothing
    : html`<section data-group=${name}><h3>${t(`studio-group-${name}`)}</h3><div class="cards">${list.map((s) => card(s, openScene))}</div></section>`);
  const listed = new Set(Object.values(GROUPS).flat());
  const found = () => scenes.filter((scene) => matches(scene, words));
  const content = () => {
    const hits = found();
    if (words.trim() === "") return Object.entries(GROUPS).map(([name, list]) => group(name, list.map(of).filter(Boolean)));
    if (hits.length === 0) return html`<p>${t("studio-scenes-none")}</p>`;
    const shown = Object.entries(GROUPS).map(([name, list]) => group(name, list.map(of).filter((s) => hits.includes(s))));
    return [...shown, group("more", hits.filter(({ name }) => !listed.has(name)))];
  };
  const search = (event) => {
    words = event.target.value;
    refresh();
    watchImages();
  };
  const refresh = sheet("studio-scenes", "gallery", () => html`<p class="lead">${t("studio-scenes-lead")}</p>
    <input type="search" id="find-scene" .value=${words} placeholder=${t("studio-scenes-find")} aria-label=${t("studio-scenes-find")} @input=${search}>
    ${content()}`);
  watchImages();
}
