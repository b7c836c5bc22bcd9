// Every file that the command writes, as a download.

import { make } from "../core/dom.js";
import { t } from "../core/words.js";
import { link } from "../core/net.js";
import { dialog } from "../core/view.js";

const GROUPS = [
  ["tables", ["law.csv", "profile.csv", "second_profile.csv", "summary.json", "scene.toml"]],
  ["drawings", ["profile.dxf", "profile_arcs.dxf", "profile.svg"]],
  ["pictures", ["cam.svg", "cam.png", "force.svg", "force.png", "svaj.svg", "svaj.png"]],
  ["report", ["report.html"]],
  ["workshop", ["cam.step", "profile.stl", "profile.3mf", "profile.xlsx", "groove_upper.stl", "groove_lower.stl", "cutter.csv"]],
];
const INFEASIBLE = ["summary.json", "scene.toml", "report.html"];

// Which files this design has.
function has(answer, name) {
  if (answer.infeasible) return INFEASIBLE.includes(name);
  const barrel = answer.fields["cam.depth"] !== undefined;
  if (name === "second_profile.csv") return answer.drawing.includes("cam-second");
  if (name.startsWith("groove_")) return barrel;
  if (["cam.step", "profile.stl", "profile.3mf", "profile_arcs.dxf"].includes(name)) return !barrel;
  return true;
}

export function open(answer) {
  if (!answer) return;
  dialog("studio-export", (body) => {
    body.className = "exports";
    if (!answer.infeasible) {
      body.append(make("figure", {}, make("img", { src: link(`export/${answer.id}/cam.svg`), alt: t("studio-export-preview") })));
    }
    const tool = make("input", { type: "text", value: "3 mm", id: "tool", size: 8 });
    for (const [group, names] of GROUPS) {
      const mine = names.filter((name) => has(answer, name));
      if (mine.length === 0) continue;
      const list = make("ul", {}, ...mine.map((name) => {
        const a = make("a", { href: link(`export/${answer.id}/${name}`), download: name }, name);
        if (name === "cutter.csv") {
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
