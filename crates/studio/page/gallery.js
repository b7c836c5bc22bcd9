// The built-in scenes with their pictures.

import { make } from "./dom.js";
import { t, language } from "./words.js";
import { link } from "./net.js";
import { dialog, closeDialog } from "./view.js";

export function open(scenes, openScene) {
  dialog("studio-scenes", (body) => {
    body.className = "gallery";
    body.append(make("p", { class: "lead" }, t("studio-scenes-lead")));
    for (const scene of scenes) {
      body.append(make("button", { type: "button", class: "card", "data-scene": scene.name, onclick: () => { closeDialog(); openScene(scene.toml); } },
        make("img", { src: link(`scene/${scene.name}.svg`), alt: "", loading: "lazy" }),
        make("b", {}, scene.name.replaceAll("_", " ")),
        make("span", {}, scene.doc[language()])));
    }
  });
}
