"""One cam for 200 walkers, compared with a conic program in cvxpy. Only the table of cycles is shared. The force error of a walker
is ‖ω² a − y‖ over the harmonics of the law with y = F/mean − 1; the limits hold at 200 000 angles."""

import csv
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import cvxpy as cp
import numpy as np

GAITCAM = os.environ["GAITCAM"]
G, WALKERS, SAMPLES, HARMONICS, ANGLES = 9.81, 200, 1000, 5, 200_000
LIMITS = {"stroke": 0.041, "acceleration": 5.0, "jerk": 95.0}
LARGEST = 1e-6


def population(rng):
    """Step frequencies, Hz, and (sine, cosine) load factors of eight harmonics of each walker."""
    f = np.clip(rng.normal(1.87, 0.186, WALKERS), 1.4, 2.4)
    mean = np.array([0.37 * (f - 0.95), 0.054 + 0.0088 * f, 0.026 + 0.015 * f, 0.010 + 0.0204 * f] + [0.008 + 0 * f] * 4)
    a = mean * (1 + 0.08 * rng.normal(size=mean.shape))
    phase = 0.15 * rng.normal(size=mean.shape)
    phase[0] = 0
    return f, a * np.cos(phase), a * np.sin(phase)


def write(path, f, sine, cosine, weights):
    x = 2 * np.pi * np.arange(SAMPLES + 1) / SAMPLES
    n = np.arange(1, 9)[:, None]
    with open(path, "w") as table:
        print("walker,period_s," + ",".join(f"f_{i:03d}" for i in range(SAMPLES + 1)), file=table)
        for w in range(len(f)):
            force = weights[w] * (1 + sine[:, w] @ np.sin(n * x) + cosine[:, w] @ np.cos(n * x))
            force[-1] = force[0]
            print(f"W{w:03d},{float(1 / f[w])!r}," + ",".join(repr(float(v)) for v in force), file=table)


def by_cones(f, sine, cosine, tail):
    """Objective of cvxpy's law. The coefficients of a(θ) are in units of G/100, with one column each for sine and cosine. Angles at
    which a limit is violated are added until there is none."""
    n = np.arange(1, HARMONICS + 1)

    def rows(order, x):
        """Matrix of a derivative of the law in the coefficients of a: s = −a/n²."""
        k = (1.0 * n) ** (order - 2) * G / 100
        sin, cos = np.sin(np.outer(x, n)) * k, np.cos(np.outer(x, n)) * k
        return {0: np.hstack([-sin, -cos]), 2: np.hstack([sin, cos]), 3: np.hstack([cos, -sin])}[order]

    fastest = 2 * np.pi * f.max()
    bounds = {2: LIMITS["acceleration"] / fastest**2, 3: LIMITS["jerk"] / fastest**3}
    c, t, level = cp.Variable(2 * HARMONICS), cp.Variable(), cp.Variable()
    fixed, errors = [], []
    for w in range(len(f)):
        y = np.concatenate([sine[:HARMONICS, w], cosine[:HARMONICS, w]])
        rest = np.sqrt((sine[HARMONICS:, w] ** 2).sum() + (cosine[HARMONICS:, w] ** 2).sum())
        errors.append(cp.hstack([(2 * np.pi * f[w]) ** 2 / 100 * c - y, rest]) / np.sqrt(2))
    if tail is None:
        fixed += [cp.norm(e) <= t for e in errors]
        objective = t
    else:
        over = cp.Variable(len(f), nonneg=True)
        fixed += [cp.sum_squares(e) <= t + o for e, o in zip(errors, over)]
        objective = t + cp.sum(over) / len(f) / (1 - tail)
    fine = 2 * np.pi * np.arange(ANGLES) / ANGLES
    used = fine[:: ANGLES // 50]
    while True:
        lift = (rows(0, used) / LIMITS["stroke"]) @ c + level
        limits = [lift >= 0, lift <= 1]
        limits += [cp.abs((rows(order, used) / bound) @ c) <= 1 for order, bound in bounds.items()]
        problem = cp.Problem(cp.Minimize(objective), fixed + limits)
        problem.solve(solver=cp.CLARABEL, tol_gap_abs=1e-9, tol_gap_rel=1e-9, tol_feas=1e-9)
        lift = rows(0, fine) @ c.value / LIMITS["stroke"] + level.value
        curves = [-lift, lift - 1]
        for order, bound in bounds.items():
            curves += [sign * rows(order, fine) @ c.value / bound - 1 for sign in (1, -1)]
        broken = [fine[y.argmax()] for y in curves if y.max() > 1e-8]
        if len(new := np.setdiff1d(broken, used)) == 0:
            squares = np.array([(e.value**2).sum() for e in errors])
            return 100 * np.sqrt(squares.max() if tail is None else np.sort(squares)[-round(len(f) * (1 - tail)) :].mean())
        used = np.concatenate([used, new])


def by_gaitcam(folder, robust):
    settings = {
        "gait.file": folder / "walkers.csv",
        "law.robust": robust,
        "law.family": "harmonic",
        "law.harmonics": HARMONICS,
        "accuracy.rms": "none",
        "limits.stroke": f"{LIMITS['stroke']} m",
        "limits.acceleration": f"{LIMITS['acceleration']} m/s^2",
        "limits.jerk": f"{LIMITS['jerk']} m/s^3",
    }
    command = [GAITCAM, "synth", "--json", "--no-png", "--out", folder / "out"]
    for key, value in settings.items():
        command += ["--set", f"{key}={value}"]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    summary = json.loads(done.stdout)
    with open(folder / "out" / "walkers.csv") as table:
        errors = np.array([float(row["rms_error_percent"]) for row in csv.DictReader(table)])
    active = sorted({limit["limit"] for limit in summary["binding"]})
    return summary["population"], errors, active


def main():
    rng = np.random.default_rng(5)
    f, sine, cosine = population(rng)
    weights = G * np.clip(rng.normal(75, 15, WALKERS), 45, 110)
    largest = 0.0
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        write(folder / "walkers.csv", f, sine, cosine, weights)
        for robust, tail in (("worst", None), ("cvar 0.9", 0.9)):
            own, errors, active = by_gaitcam(folder, robust)
            count = WALKERS // 10
            measure = errors.max() if tail is None else np.sqrt((np.sort(errors)[-count:] ** 2).mean())
            other = by_cones(f, sine, cosine, tail)
            difference = abs(measure / other - 1)
            largest = max(largest, difference)
            print(f"{robust}: gaitcam {measure:.9f} %, cvxpy {other:.9f} %, difference {difference:.1e}, gap {own['gap']:.1e}, active {active}")
    print(f"walkers: {'OK' if largest <= LARGEST else 'DIFFERENT'}, {WALKERS} walkers, largest difference {largest:.1e} (allowed {LARGEST:.0e})")
    sys.exit(largest > LARGEST)


main()
