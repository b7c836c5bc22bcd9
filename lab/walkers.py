#!/usr/bin/env python3
"""Compares one cam with several cams for many walkers; writes reports/walkers.md and its pictures.

    python3 lab/walkers.py target/release/gaitcam [FOLDER OF RECORDINGS]

The 500 walkers are random samples of published distributions; load models provide the walkers of one cam for every bridge. Without
a folder, the section on recordings in the report is kept.
"""

import csv
import json
import math
import random
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
REPORT = ROOT / "reports" / "walkers.md"
WALKERS, STEPS, SEED = 500, 100, 2007
MODELS = ("young", "setra", "li-2010")
LIMITS = ("--set", "limits.stroke=60 mm")
TEXT = """# One cam for many walkers

Written by `lab/walkers.py` with `gaitcam cover` and `gaitcam synth`. Errors are RMS force errors in percent of each walker's mean force. Mass and speed of the machine are set for each walker. "others" is the error for new walkers by five-fold cross-validation (theory §8).

## One cam for every bridge

Step frequencies of 1.4 to 2.4 Hz in steps of 0.1 Hz, 24 spans, stroke at most 60 mm. The cam for 1.85 Hz is simulated at the speed of each walker, with the walker's weight.

{bridges}
## 500 walkers, random phases

Mass lognormal, ln(m/kg) with mean 4.28 and deviation 0.21 (Portier, Tolson and Roberts 2007); step frequency normal, 1.87 Hz and
0.186 Hz, held within 1.4 to 2.4 Hz, and harmonics 2 to 5 normal with means 0.07, 0.05, 0.05, 0.03 and deviations 0.03, 0.02, 0.02,
0.015, phases uniform (Živanović, Pavić and Reynolds 2007, Engineering Structures 29, 942–954); the first harmonic is that of Kerr
(1998) with a deviation of 16 %. The two numbers of the mass are also those of PyHSI (MonashSmartStructures/pyhsi, `pyhsi/crowd.py`).
Those of step frequency and harmonics are quoted from memory of these papers and were not compared with their print; of Živanović et
al. only the first page was read (studylib.net/doc/12918114), which names five harmonics and the subharmonics. Harmonics 6 to 8 are
zero: the one source found that has distributions of eight is Chen, Ding and Živanović (2019, Int. J. Struct. Stab. Dyn. 19, 1950029;
scribd.com/document/634571012), of one foot and in tables beyond the first page, which could not be read. Guides and load models (Rainer,
Kerr, Young, SETRA, SCI P354, Synpex) end at the fourth or fifth, and no public program of pedestrian loads was found with more.

{uniform}
If the worst error equals the bound, one walker determines it. Even this walker's own cam has this error, because a stroke of 60 mm is too small for a strong and slow step.

## 500 walkers, phases in order

These walkers have the phases of SCI P354 (0, −90°, 180°, 90°, 0) with an assumed spread of 0.3 rad. They represent one kind of step.

{ordered}
## Recordings

The recordings are measured stances and strides of adults and children, overground and on a treadmill. Several files belong to the same person with different names.

{recordings}
"""


def population(path, phases):
    """Random walkers. The mass is lognormal (Portier et al. 2007), step frequency and harmonics 2 to 5 are normal (Živanović et al.
    2007), and the first harmonic is Kerr's (1998) with 16 %. The phases are uniform, or those of SCI P354 with a spread of 0.3 rad."""
    rng = random.Random(SEED)
    names = ",".join(f"f_{i:03d}" for i in range(STEPS + 1))
    with open(path, "w", encoding="utf-8") as table:
        print(f"walker,period_s,mass_kg,{names}", file=table)
        for walker in range(WALKERS):
            mass = rng.lognormvariate(4.28, 0.21)
            f = min(2.4, max(1.4, rng.gauss(1.87, 0.186)))
            first = -0.2649 * f**3 + 1.3206 * f**2 - 1.7597 * f + 0.7613
            spread = [(0.07, 0.03), (0.05, 0.02), (0.05, 0.02), (0.03, 0.015)]
            a = [first * rng.gauss(1, 0.16)] + [max(0.0, rng.gauss(m, s)) for m, s in spread]
            if phases == "uniform":
                phi = [0.0] + [rng.uniform(-math.pi, math.pi) for _ in spread]
            else:
                phi = [0.0] + [p + rng.gauss(0, 0.3) for p in (-math.pi / 2, math.pi, math.pi / 2, 0.0)]
            wave = lambda x: 1 + sum(a[k] * math.sin((k + 1) * x + phi[k]) for k in range(5))
            force = [9.81 * mass * wave(2 * math.pi * i / STEPS) for i in range(STEPS)]
            print(f"W{walker:03d},{1 / f!r},{mass!r}," + ",".join(f"{v:.6f}" for v in [*force, force[0]]), file=table)


def run(gaitcam, *arguments):
    done = subprocess.run([gaitcam, *map(str, arguments)], capture_output=True, text=True)
    if done.returncode not in (0, 3):
        sys.exit(done.stderr)
    return done.stdout


def rows(path):
    with open(path, encoding="utf-8") as table:
        return list(csv.DictReader(table))


def number(text):
    return f"{float(text):.3f}" if text else "–"


def cover(gaitcam, folder, walkers, name, *settings, cams="1:6"):
    """Tables of a cover as Markdown. The picture is written beside the report."""
    out = folder / name
    begun = time.process_time()
    run(gaitcam, "cover", walkers, "--cams", cams, "--out", out, "--time-limit", "3000", *settings)
    parts = ["| cams | mean % | worst % | bound % | others, mean % | others, worst % |", "|---|---|---|---|---|---|"]
    folds = rows(out / "folds.csv")
    for row in rows(out / "cover.csv"):
        own = [f for f in folds if f["cams"] == row["cams"]]
        other = own[-1] if own else {}
        cells = [row["cams"], *(number(row[k]) for k in ("mean_percent", "worst_percent", "bound_percent"))]
        cells += [number(other.get("out_mean_percent", "")), number(other.get("out_worst_percent", ""))]
        parts.append("| " + " | ".join(cells) + " |")
    parts.append("")
    (ROOT / "reports" / f"walkers_{name}.svg").write_bytes((out / "cover.svg").read_bytes())
    own = [f for f in folds if f["cams"] == "1"]
    if own:
        parts += ["One cam, designed for a growing number of walkers:", "", "| walkers | own, mean % | own, worst % | others, mean % | others, worst % |", "|---|---|---|---|---|"]
        for f in own:
            keys = ("in_mean_percent", "in_worst_percent", "out_mean_percent", "out_worst_percent")
            parts.append(f"| {f['walkers']} | " + " | ".join(number(f[k]) for k in keys) + " |")
        parts.append("")
    assigned = [a for a in rows(out / "assignment.csv") if a["cams"] == "1"]
    worst = sorted(assigned, key=lambda a: -float(a["rms_error_percent"]))[:5]
    parts += ["The table lists the worst walkers of one cam, with the components of the error (the squares add up):", "", "| walker | error % | mean force % | size at this speed % | shape % |", "|---|---|---|---|---|"]
    for a in worst:
        keys = ("rms_error_percent", "weight_percent", "speed_percent", "shape_percent")
        parts.append(f"| {a['walker']} | " + " | ".join(number(a[k]) for k in keys) + " |")
    return "\n".join(parts) + f"\n\n![Error and number of cams](walkers_{name}.svg)\n"


def one_cam_for_every_bridge(gaitcam, folder):
    """Rows for each model: the cam of 1.85 Hz at other speeds, that of the mean error and that of the worst error."""
    lines = ["| model | cam for 1.85 Hz, mean % | worst % | cam for the mean error, mean % | worst % | cam for the worst error, mean % | worst % | gap |", "|---|---|---|---|---|---|---|---|"]
    for model in MODELS:
        common = ["--set", f"gait.model={model}", "--set", "accuracy.rms=none", "--set", "law.spans=24", *LIMITS]
        cells = [model]
        # Cam for one frequency at the other ones: the same law, with the mass and speed of each walker.
        frequencies = [1.4 + 0.1 * i for i in range(11)]
        forces = []
        for f in frequencies:
            out = folder / f"{model}_{f:.1f}"
            run(gaitcam, "synth", "--no-png", "--out", out, *common, "--set", f"gait.step_frequency={f:.1f} Hz")
            forces.append([float(r["target_n"]) for r in rows(out / "law.csv")])
        out = folder / f"{model}_185"
        run(gaitcam, "synth", "--no-png", "--out", out, *common, "--set", "gait.step_frequency=1.85 Hz")
        law = [float(r["force_n"]) for r in rows(out / "law.csv")]
        mean = sum(law) / len(law)
        errors = []
        for f, target in zip(frequencies, forces):
            weight = sum(target) / len(target)
            own = [weight * (1 + (f / 1.85) ** 2 * (x / mean - 1)) for x in law]
            errors.append(100 * math.sqrt(sum((x - y) ** 2 for x, y in zip(own, target)) / len(law)) / weight)
        cells += [f"{sum(errors) / len(errors):.2f}", f"{max(errors):.2f}"]
        for robust in ("mean", "worst"):
            text = run(gaitcam, "synth", "--json", *common, "--set", "gait.step_frequency=1.4 Hz:2.4 Hz:11", "--set", f"law.robust={robust}")
            own = json.loads(text)["population"]
            cells += [f"{own['mean_percent']:.2f}", f"{own['worst_percent']:.2f}"]
        cells.append(f"{own['gap']:.0e}")
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def recordings(gaitcam, folder, place):
    """Section on recordings. Recordings that the command rejects are excluded by name."""
    left = []
    for _ in range(5):
        settings = ["--set", f"gait.leave_out={json.dumps(left)}", "--set", "law.robust=worst"]
        done = subprocess.run([gaitcam, "cover", place, "--cams", "1:6", "--out", folder / "try", *settings], capture_output=True, text=True)
        left += re.findall(r"([\w.-]+\.[a-z0-9]{2,5})(?: line \d+)?: ", "".join(re.findall(r"Files without a cycle: (.*)", done.stderr)))
        names = re.findall(r"(?:the weight:|of force:|mixed:|movement:) (.*?)\.(?= |;)", done.stderr)
        if done.returncode in (0, 3):
            break
        for name in filter(None, re.split(r", ", ", ".join(names))):
            left.append(re.sub(r" \(\d+ %\)$", "", name.strip()))
    text = cover(gaitcam, folder, place, "recordings", *settings)
    return f"{len(left)} files are excluded: {', '.join(f'`{n}`' for n in left)}.\n\n{text}"


def main():
    gaitcam = str(Path(sys.argv[1]).resolve())
    before = REPORT.read_text(encoding="utf-8") if REPORT.exists() else ""
    kept = re.search(r"(?ms)^## Recordings\n\n.*?\n\n(.*?)(?=^## |\Z)", before)
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        for phases in ("uniform", "ordered"):
            population(folder / f"{phases}.csv", phases)
        robust = ("--set", "law.robust=worst", "--set", "law.spans=24", *LIMITS)
        uniform = cover(gaitcam, folder, folder / "uniform.csv", "uniform", *robust)
        ordered = cover(gaitcam, folder, folder / "ordered.csv", "ordered", *robust)
        bridges = one_cam_for_every_bridge(gaitcam, folder)
        if len(sys.argv) > 2:
            measured = recordings(gaitcam, folder, Path(sys.argv[2]).resolve())
        else:
            measured = kept.group(1) if kept else ""
    report = TEXT.format(bridges=bridges, uniform=uniform, ordered=ordered, recordings=measured.strip())
    REPORT.write_text(report, encoding="utf-8")


main()
