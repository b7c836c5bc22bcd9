// Every file that the command writes, as a download.

import { make } from "../core/dom.js";
import { t } from "../core/words.js";
import { link } from "../core/net.js";
import { dialog } from "../core/view.js";

// Files that are made for a cutter.
const CUTTER = ["cutter.csv", "cutter.nc", "cutter_second.nc"];

export function open(answer) {
  if (!answer) return;
  dialog("studio-export", (body) => {
    body.className = "exports";
    if (!answer.infeasible) {
      body.append(make("figure", {}, make("img", { src: link(`export/${answer.id}/cam.svg`), alt: t("studio-export-preview") })));
    }
    const tool = make("input", { type: "text", value: answer.cutter, id: "tool", size: 8 });
    for (const [group, names] of answer.exports) {
      const list = make("ul", {}, ...names.map((name) => {
        const a = make("a", { href: link(`export/${answer.id}/${name}`), download: name }, name);
        if (CUTTER.includes(name)) {
          const own = () => { a.href = link(`export/${answer.id}/${name}?tool=${encodeURIComponent(tool.value)}`); };
          tool.addEventListener("input", own);
          own();
        }
        return make("li", {}, a, make("small", {}, t(`studio-file-${name.replaceAll(".", "-")}`)));
      }));
      body.append(make("section", {}, make("h3", {}, t(`studio-export-${group}`)), list));
    }
    if (!answer.infeasible) body.append(make("p", {}, make("label", { for: "tool" }, t("studio-tool")), " ", tool));
    body.append(make("p", { class: "lead" }, t("studio-export-tolerance")));
  });
}
