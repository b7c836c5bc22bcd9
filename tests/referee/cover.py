#!/usr/bin/env python3
"""Recomputes the tables of `gaitcam cover` for a load model over a range of step frequencies on a moving axis without active limits.

    python3 tests/referee/cover.py DIR FREQUENCIES      (as the scene has them: '1.5 Hz:2.3 Hz:6')
"""

import csv
import itertools
import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import referee  # noqa: F401 (threads of the linear algebra)
import numpy as np

import law as laws
from force import model
from optimum import design_matrix
from units import quantity

ANGLES, GRAVITY, WEIGHT, DEGREE = 720, 9.81, 700.0, 5
THETA = 2 * math.pi * (np.arange(ANGLES) + 0.5) / ANGLES
SPANS = range(DEGREE + 1, 33)
BASES = {}


def read(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


class Walkers:
    """Target force and force at rest of each walker relative to the weight. It is linear in the second derivative of the lift."""

    def __init__(self, frequencies):
        low, high, count = frequencies.split(":")
        found = np.linspace(quantity(low), quantity(high), int(count))
        self.wanted = np.array([model("young", f, WEIGHT, THETA) / WEIGHT - 1 for f in found])
        self.gain = (2 * math.pi * found) ** 2 / GRAVITY

    def basis(self, spans):
        if spans not in BASES:
            knots = 2 * math.pi * np.arange(spans) / spans
            BASES[spans] = design_matrix(lambda c: laws.spline(knots, DEGREE, c), spans, THETA)[2]
        return BASES[spans]

    def best(self, group, basis=None):
        """Second derivative of the law with the smallest mean square error for a group: of all laws, or of a basis."""
        gain = self.gain[group]
        aim = gain @ self.wanted[group] / (gain @ gain)
        if basis is None:
            return aim
        return basis @ np.linalg.lstsq(basis, aim, rcond=1e-11)[0]

    def square(self, group, bend):
        return float(np.sum(np.mean((np.outer(self.gain[group], bend) - self.wanted[group]) ** 2, axis=1)))

    def least(self, cams):
        """Smallest root mean square error of all partitions into `cams` groups, by brute force, in per cent."""
        count = len(self.gain)
        best = math.inf
        for labels in itertools.product(range(cams), repeat=count):
            if labels[0] == 0 and len(set(labels)) == cams:
                groups = [[i for i in range(count) if labels[i] == k] for k in range(cams)]
                best = min(best, sum(self.square(g, self.best(g)) for g in groups))
        return 100 * math.sqrt(best / count)


def parts(error, force):
    """Components of the error in per cent: the mean, the component along the varying force of the cam, and the rest."""
    along = float(np.mean(error * force)) / math.sqrt(float(np.mean(force**2)))
    level = float(np.mean(error))
    return [100 * math.sqrt(x) for x in (np.mean(error**2), level**2, along**2, max(np.mean(error**2) - level**2 - along**2, 0.0))]


def judge(folder, frequencies, change=None):
    """Differing lines. `change` is a (file, row, column) whose number is changed by 0.1 %."""
    tables = {name: read(Path(folder) / f"{name}.csv") for name in ("cover", "assignment")}
    if change:
        name, row, column = change
        tables[name][row][column] = str(1.001 * float(tables[name][row][column]))
    walkers, faults, count = Walkers(frequencies), [], 0
    names = list(dict.fromkeys(row["walker"] for row in tables["assignment"]))
    for row in tables["cover"]:
        cams = int(row["cams"])
        served = [a for a in tables["assignment"] if int(a["cams"]) == cams]
        stated = np.array([[float(a[c]) for c in ("rms_error_percent", "weight_percent", "speed_percent", "shape_percent")] for a in served])
        for label, own in (("mean_percent", np.mean(stated[:, 0])), ("worst_percent", np.max(stated[:, 0]))):
            count += 1
            if abs(float(row[label]) - own) > 1e-6 * own:
                faults.append(f"{cams} cams: {label} {row[label]}, recomputed {own}")
        count += 1
        least, bound = walkers.least(cams), float(row["bound_percent"])
        if cams == 1:  # of splines with the spans of the cam, which are not stated
            every = list(range(len(names)))
            own = [100 * math.sqrt(walkers.square(every, walkers.best(every, walkers.basis(spans))) / len(every)) for spans in SPANS]
            least = min(own, key=lambda value: abs(value - bound))
        if bound > least * (1 + 3e-4) or cams == 1 and bound < least * (1 - 3e-4):
            faults.append(f"{cams} cams: bound_percent {bound}, optimum {least}")
        for cam in range(1, cams + 1):
            group = [names.index(a["walker"]) for a in served if int(a["cam"]) == cam]
            mine = [i for i, a in enumerate(served) if int(a["cam"]) == cam]
            off = math.inf
            for spans in SPANS:
                bend = walkers.best(group, walkers.basis(spans))
                own = np.array([parts(walkers.gain[i] * bend - walkers.wanted[i], bend) for i in group])
                off = min(off, float(np.max(np.abs(own - stated[mine]) / np.maximum(own, 1e-3))))
            count += 4 * len(group)
            if off > 3e-4:
                faults.append(f"{cams} cams: the errors of cam {cam} differ by {off:.1e} of themselves from those of its best law")
    return count, faults


def self_test(folder, frequencies):
    """Numbers whose change is not detected. A bound may be lower."""
    missed, count = [], 0
    for row, column in [(i, c) for i in range(3) for c in ("mean_percent", "worst_percent")]:
        count += 1
        if not judge(folder, frequencies, ("cover", row, column))[1]:
            missed.append(f"cover.csv row {row} {column}")
    for row, column in [(2, "rms_error_percent"), (5, "shape_percent"), (9, "rms_error_percent"), (9, "speed_percent")]:
        count += 1
        if not judge(folder, frequencies, ("assignment", row, column))[1]:
            missed.append(f"assignment.csv row {row} {column}")
    return missed, count


if __name__ == "__main__":
    count, faults = judge(*sys.argv[1:3])
    print("\n".join(faults + [f"{count} numbers, {len(faults)} faults"]))
    sys.exit(bool(faults))
