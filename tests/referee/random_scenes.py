#!/usr/bin/env python3
"""Random scenes over all keys of the program. Each is rejected with a message, or the referee recomputes its numbers.

    python3 tests/referee/random_scenes.py GAITCAM [COUNT [SEED]]      (in two processes; default 200 scenes, seed 1)

The keys, their ranges and choices are those of `gaitcam keys --json`, so that new keys are included automatically.
"""

import json
import math
import random
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from referee import Result, judge, judge_rows
from result import Unknown

WORKERS = 2
# Time limit of a design, s. A design that needs longer is checked in its state at that time.
TIME_LIMIT = "2"

SCENES = ["footbridge", "footbridge_thesis_scale", "thesis_iteration_3", "camdas_01_roller", "camdas_03_flat", "mushroom"]
# Typical sizes of a quantity by its unit.
SIZES = {
    "m": (2e-3, 0.2), "kg": (0.5, 100), "N": (5, 2000), "Hz": (1.4, 2.4), "rad": (0.1, 6.0), "s": (0.2, 2), "rad/s": (5, 20), "%": (0.1, 10),
    "m/s": (0.05, 1), "m/s^2": (1, 20), "m/s^3": (20, 500), "N m": (1, 50), "W": (10, 500), "N m/rad": (5, 100), "Pa": (1e8, 1e9),
    "N/m": (1e3, 1e5), "N s/m": (1, 100), "kg m^2": (0.05, 20), "N m s/rad": (1, 20), "m/s²": (1, 20),
}
# With a motor, law.csv interpolates the speed linearly between 240 angles.
OPEN_UNDER_A_MOTOR = re.compile(r"rows\.speed_rad_per_s")
NUMBERED = ("point", "dwell", "segment", "weight", "mode")


def value(key, draw):
    """Random value of a key, as in a scene file."""
    if key["choices"]:
        return draw.choice(key["choices"])
    kind, limits = key["kind"], key["range"] or {}
    if kind in ("flag", "bool", "boolean"):
        return draw.choice(["true", "false"])
    if kind in ("text", "texts"):
        return draw.choice(["1", "none", "0.4", "free"])
    unit = (key["units"] or {}).get("translating") or key["unit"]
    low, high = SIZES.get(unit, (0.1, 10.0))
    least, most = (next((limits[k] for k in names if k in limits), None) for names in (("from", "above", "min"), ("to", "below", "max")))
    low = low if least is None else max(low, least)
    high = high if most is None else min(high, most)
    number = math.exp(draw.uniform(math.log(max(low, 1e-9)), math.log(max(high, low, 1e-9))))
    if kind in ("count", "integer", "whole"):
        return str(max(1, round(number)))
    return f"{number:.4g} {unit}".strip() if unit else f"{number:.4g}"


def scene(keys, draw):
    """A built-in scene with some of its keys set."""
    own = [key for key in keys if key["section"] and not any(part in key["key"].split(".") for part in NUMBERED)]
    given = [(key["key"], value(key, draw)) for key in draw.sample(own, draw.randint(1, 4))]
    if any(name.startswith("machine.motor") for name, _ in given):
        given += [("machine.motor.slope", "10 N m s/rad"), ("machine.inertia", "2 kg m^2")]
    if any(name.startswith("machine.floor") for name, _ in given):
        given += [("machine.floor.mass", "20000 kg"), ("machine.floor.frequency", "3 Hz"), ("machine.floor.damping", "0.02")]
    return draw.choice(SCENES), dict(given)


def check(gaitcam, name, given):
    """Result of a scene, its faults, and the fields without recomputation."""
    words = [word for key, text in given.items() for word in ("--set", f"{key}={text}")]
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "result"
        run = subprocess.run([gaitcam, "synth", name, *words, "--out", str(out), "--no-png", "--time-limit", TIME_LIMIT], capture_output=True, text=True)
        if run.returncode == 2:
            return "refused", [] if run.stderr.strip() else ["refused without a message"], []
        if run.returncode not in (0, 3):
            return "failed", [f"exit code {run.returncode}: {run.stderr.strip()[:200]}"], []
        return judged(out)


def judged(folder):
    try:
        result = Result(folder)
        if result.summary.get("out_of_time"):  # a search that was cut short
            return "out of time", [], []
        if not (result.summary.get("solver") or {}).get("certified", True):  # a proof that was not found is no claim
            result.summary["solver"] = {}
        rows = judge(result)[0] + (judge_rows(result)[0] if result.is_built else [])
    except Unknown as unknown:
        return "open", [], [f"all: no recomputation: {unknown}"]
    except Exception as fault:
        return "failed", [f"the referee fails: {fault!r}"], []
    if "motor" in result.scene.get("machine", {}):
        rows = [row for row in rows if not OPEN_UNDER_A_MOTOR.match(row[0])]
    wrong = [f"{path}: stated {stated}, recomputed {own}" for path, stated, own, note in rows if note == "DIFFERS"]
    return "checked", wrong, [f"{path}: {note}" for path, _, _, note in rows if note and note != "DIFFERS"]


def sample(gaitcam, count, seed):
    """Counts of the results of the scenes, lines of their faults, and fields without recomputation."""
    keys = json.loads(subprocess.run([gaitcam, "keys", "--json"], capture_output=True, check=True).stdout)
    draw, counts, lines, unknown = random.Random(seed), {}, [], []
    scenes = [scene(keys, draw) for _ in range(count)]
    with ProcessPoolExecutor(WORKERS) as pool:
        found = pool.map(check, [gaitcam] * count, *zip(*scenes))
        for (name, given), (became, faults, left_open) in zip(scenes, found):
            counts[became] = counts.get(became, 0) + 1
            settings = name + "".join(f" --set '{key}={text}'" for key, text in given.items())
            lines += [f"{settings}: {fault}" for fault in faults]
            unknown += [f"{settings}: {field}" for field in left_open]
            if faults:
                print("\n".join(lines[-len(faults):]), flush=True)
    return counts, lines, unknown


def main():
    count, seed = (int(word) for word in (sys.argv[2:4] + ["200", "1"][len(sys.argv) - 2 :]))
    counts, lines, unknown = sample(str(Path(sys.argv[1]).resolve()), count, seed)
    kinds = {}
    for line in unknown:
        settings, field, reason = re.fullmatch(r"(.*): ([\w.\[\]]+): (.*)", line).groups()
        kinds.setdefault((re.sub(r"\[\d+\].*", "", field), reason), []).append(settings)
    for (field, reason), scenes in kinds.items():
        print(f"left open, {len(scenes)} times: {field}: {reason}; first in {scenes[0]}")
    print(f"{count} random scenes: {counts}, {len(unknown)} fields without recomputation, {len(lines)} faults")
    return bool(lines)


if __name__ == "__main__":
    sys.exit(main())
