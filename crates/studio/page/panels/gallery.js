// The built-in scenes with their pictures.

import { make } from "../core/dom.js";
import { t, language } from "../core/words.js";
import { link } from "../core/net.js";
import { dialog, closeDialog } from "../core/view.js";

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
