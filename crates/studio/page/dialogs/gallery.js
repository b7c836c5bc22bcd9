// The built-in scenes with their pictures.

import { make } from "../core/dom.js";
import { t, language } from "../core/words.js";
import { engine } from "../core/net.js";
import { dialog, closeDialog } from "../core/view.js";

// Pictures by scene, asked once.
const pictures = new Map();

async function picture(name, image) {
  if (!pictures.has(name)) pictures.set(name, engine.ask("scene-picture", { name }).then(({ svg }) => URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" }))));
  try {
    image.src = await pictures.get(name);
  } catch { pictures.delete(name); }
}

function lazily(name) {
  const image = make("img", { alt: "" });
  new IntersectionObserver((entries, observer) => {
    if (!entries.some((e) => e.isIntersecting)) return;
    observer.disconnect();
    picture(name, image);
  }).observe(image);
  return image;
}

export function open(scenes, openScene) {
  dialog("studio-scenes", (body) => {
    body.className = "gallery";
    body.append(make("p", { class: "lead" }, t("studio-scenes-lead")));
    for (const scene of scenes) {
      body.append(make("button", { type: "button", class: "card", "data-scene": scene.name, onclick: () => { closeDialog(); openScene(scene.toml); } },
        lazily(scene.name),
        make("b", {}, scene.name.replaceAll("_", " ")),
        make("span", {}, scene.doc[language()])));
    }
  });
}
