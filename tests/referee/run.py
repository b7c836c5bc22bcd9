#!/usr/bin/env python3
"""Designs the built-in scenes and lets the referee recompute every number, with its self-test on some of them.

    python3 tests/referee/run.py GAITCAM
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from referee import Result, judge, judge_rows, self_test

# Fields that have no recomputation yet, by scene. This list only becomes shorter.
OPEN = {
    "heel_tester": {"rows.target_n"},
    "heel_tester_fitted": {"rows.target_n", "solver.doubt", "solver.certified", "binding", "easing"},
}
NEEDS_A_FILE = {"measured_walk"}
SIMULATED = {"footbridge", "footbridge_thesis_scale", "heel_tester", "thesis_iteration_1", "thesis_iteration_4"}
SELF_TESTED = ["footbridge_thesis_scale", "heel_tester", "camdas_07_conjugate_roller", "camdas_12_oscillating_flat", "thesis_barrel"]


def faults_of(folder):
    result = Result(folder)
    rows = judge(result)[0] + (judge_rows(result)[0] if result.is_built else [])
    return len(rows), [(path, stated, own, note) for path, stated, own, note in rows if note]


def is_open(scene, path):
    return any(path == field or path.startswith(field + "[") for field in OPEN.get(scene, ()))


def main():
    gaitcam = str(Path(sys.argv[1]).resolve())
    scenes = [row["name"] for row in json.loads(subprocess.run([gaitcam, "scenes", "--json"], capture_output=True, check=True).stdout)]
    wrong = fields = 0
    with tempfile.TemporaryDirectory() as folder:
        for scene in scenes:
            if scene in NEEDS_A_FILE:
                continue
            out = Path(folder) / scene
            subprocess.run([gaitcam, "synth", scene, "--out", str(out), "--no-png"], check=True, stdout=subprocess.DEVNULL)
            if scene in SIMULATED:
                run = Path(folder) / "run"
                subprocess.run([gaitcam, "simulate", scene, "--model", "rigid", "--out", str(run)], check=True, stdout=subprocess.DEVNULL)
                for name in ("simulation.json", "dynamics.csv"):
                    (run / name).replace(out / name)
            count, faults = faults_of(out)
            fields += count
            for path, stated, own, note in faults:
                if not is_open(scene, path):
                    print(f"{scene}: {path}: stated {stated}, recomputed {own}: {note}")
                    wrong += 1
        changes = 0
        for scene in SELF_TESTED:
            missed, count = self_test(Path(folder) / scene)
            changes += count
            for path in missed:
                print(f"{scene}: a change of {path} is not noticed")
                wrong += 1
    left_out = sum(len(fields) for fields in OPEN.values())
    print(f"{len(scenes) - len(NEEDS_A_FILE)} scenes, {fields} numbers recomputed, {changes} changes tried, {left_out} kinds of field left open, {wrong} faults")
    return bool(wrong or not fields or not changes)


if __name__ == "__main__":
    sys.exit(main())
