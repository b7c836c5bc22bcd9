#!/usr/bin/env python3
"""Recorded walks against cams at resonance: at constant speed, with a speed programme, with some strides repeated, and across halves of a recording.

    python3 lab/walking.py GAITCAM RECORDING ... > reports/walking.md

Each recording needs eight or more consecutive strides. A text recording with sixteen or more is also cut into halves: the cam is designed from one half
and follows the other one.
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "tests" / "referee"))
from walking import DAMPING, HARMONICS, OF_STRIDE  # noqa: E402

STRIDES = (8, 16, 32)


def run(binary, *words):
    done = subprocess.run([binary, *map(str, words), "--json"], capture_output=True, text=True)
    return json.loads(done.stdout) if done.returncode in (0, 3) else None


def designed(binary, recording, out):
    run(binary, "synth", "measured_walk", "--set", f"gait.file={recording}", "--set", "gait.accept=mass", "--no-png", "--out", out)
    summary = json.loads((out / "summary.json").read_text())
    return summary.get("walker")


def response(folder):
    """RMS response to strides.csv relative to its mean force, at the tunings about its own step frequency, for each damping ratio."""
    time, force = np.loadtxt(folder / "strides.csv", delimiter=",", skiprows=1).T
    count, duration = len(time) // OF_STRIDE, len(time) * time[1]
    power = np.abs(np.fft.rfft(force / force.mean())[1 : HARMONICS * count + 1] / len(force)) ** 2
    ratio = np.arange(1, len(power) + 1) / (2 * count) / np.linspace(0.9, 1.1, 401)[:, None]
    of = lambda z: np.sqrt(2 * (ratio**4 / ((1 - ratio**2) ** 2 + (2 * z * ratio) ** 2)) @ power)
    return np.array([of(z) for z in DAMPING])


def halves(recording, folder):
    """The recording cut in the middle, as two files; `None` for a file that is not a table of numbers."""
    try:
        lines = [line for line in recording.read_text().splitlines() if line.strip()]
    except UnicodeDecodeError:
        return None
    head = next((i for i, line in enumerate(lines) if line.replace("\t", ",").split(",")[0].strip().replace(".", "", 1).isdigit()), None)
    if head is None or head > 3:
        return None
    middle, files = (len(lines) + head) // 2, []
    for name, part in (("first", lines[head:middle]), ("second", lines[middle:])):
        files.append(folder / f"{recording.stem}_{name}{recording.suffix}")
        files[-1].write_text("\n".join(lines[:head] + part) + "\n")
    return files


def row(*cells):
    print("| " + " | ".join(str(cell) for cell in cells) + " |")


def three(values):
    return " ".join(f"{value:.3f}" for value in values)


def main(binary, recordings):
    print("# Recorded walks and cams at resonance\n\nWritten by `lab/walking.py`. Three numbers are for damping ratios of 0.3, 0.5 and 1 %. The misfit is the mean of\n"
          "|ln(response ratio)| over 0.9 to 1.1 of the step frequency, the peak is relative to that of the recorded walk.\n")
    row("recording", "strides", "step time ± %", "peak, constant speed", "misfit, constant speed", "peak, programme", "misfit, programme", "amplitude ± %, recorded / programme")
    row(*["---"] * 8)
    with tempfile.TemporaryDirectory() as name:
        folder, cut, repeated = Path(name), [], []
        for recording in recordings:
            out = folder / recording.stem
            if not designed(binary, recording, out):
                continue
            walk = run(binary, "walk", out, "--out", folder / "speed.csv")
            of, fit, even = walk["variability"], walk["misfit"], walk["constant_speed"]
            pick = lambda rows, key: three(row[key] for row in rows)
            row(recording.name, of["strides"], f"{100 * of['step_time_cv']:.1f}", pick(even, "peak_ratio"), pick(even, "misfit"), pick(fit, "peak_ratio"),
                pick(fit, "misfit"), f"{100 * of['amplitude_cv']:.1f} / {100 * walk['amplitude_cv']:.1f}")
            for strides in STRIDES:
                part = run(binary, "ecam", out, "--dialect", "csv", "--strides", strides)
                if part:
                    repeated.append((recording.name, strides, pick(part["strides"]["misfit"], "misfit"), pick(part["strides"]["misfit"], "peak_ratio")))
            parts = halves(recording, folder) if of["strides"] >= 16 else None
            designs = [folder / part.stem for part in parts or ()]
            if designs and all([designed(binary, part, design) for part, design in zip(parts, designs)]):
                between = [np.abs(np.log(a / b)).mean() for a, b in zip(*map(response, designs))]
                for design, other in zip(designs, reversed(parts)):
                    own = run(binary, "walk", design, other, "--out", folder / "speed.csv")
                    cut.append((design.name, other.stem, pick(own["misfit"], "misfit"), pick(own["misfit"], "peak_ratio"), three(between)))
    print("\nAcross halves: the cam is designed from one half of the recording and follows the other one.\n")
    row("cam of", "walk of", "misfit", "peak", "misfit between the halves themselves")
    row(*["---"] * 5)
    for cells in cut:
        row(*cells)
    print("\nConsecutive recorded strides, repeated (`gaitcam ecam --strides`).\n")
    row("recording", "strides", "misfit", "peak")
    row(*["---"] * 4)
    for cells in repeated:
        row(*cells)


if __name__ == "__main__":
    main(str(Path(sys.argv[1]).resolve()), [Path(path).resolve() for path in sys.argv[2:]])
