"""Recomputation of a corrected cam: logs of a machine that is heavier and has viscous and Coulomb friction, and force of the new cam."""

import math
import subprocess

import numpy as np

from referee import judge as judge_fields
from referee import judge_rows
from result import Result, model_of

GRAVITY = 9.81
MASS, DAMPING, FRICTION, NOISE = 73.0, 20.0, 6.0, 2.0
CYCLES, RATE, ANGLES, LOGS = 30, 500, 2880, 3
# The noise of the cycles limits the accuracy of each harmonic; the forecast includes this noise.
BEFORE, PREDICTED = 0.01, 0.06


def pressed(law, speed, theta):
    """Force of the machine that the program does not model."""
    v, a = law(theta, 1), law(theta, 2)
    return MASS * (GRAVITY + speed**2 * a) + DAMPING * speed * v + FRICTION * np.sign(v)


def spread(values):
    return math.sqrt(float(np.mean((values - np.mean(values)) ** 2)))


def judge(gaitcam, folder):
    """Numbers of values and changes, and the differing lines."""
    first = Result(folder)
    speed = first.drive.speed
    theta = 2 * math.pi * (np.arange(ANGLES) + 0.5) / ANGLES
    target = model_of(first)(theta)
    numbers, changes, faults = 0, 0, []
    for seed in range(LOGS):
        time = np.arange(round(CYCLES * 2 * math.pi / speed * RATE)) / RATE
        angle = 0.7 + speed * time
        force = pressed(first.law, speed, angle) + np.random.default_rng(seed).normal(0, NOISE, len(time))
        path, out = folder / f"run_{seed}.csv", folder / f"recut_{seed}"
        path.write_text("time_s,theta_rad,force_n\n" + "".join(f"{t:.4f},{x % math.tau:.9f},{f:.6f}\n" for t, x, f in zip(time, angle, force)))
        subprocess.run([gaitcam, "recut", str(folder), str(path), "--out", str(out), "--no-png"], check=True, capture_output=True)
        result = Result(out)
        rows = [row for row in judge_fields(result)[0] + judge_rows(result)[0] if not row[0].startswith("recut.")]
        faults += [f"log {seed}: {field}: stated {stated}, recomputed {own}: {note}" for field, stated, own, note in rows if note]
        numbers += len(rows)
        for name, law, part in (("before_rms_n", first.law, BEFORE), ("predicted_rms_n", result.law, PREDICTED)):
            stated, own = result.summary["recut"][name], spread(pressed(law, speed, theta) - target)
            numbers, changes = numbers + 1, changes + 1
            if abs(stated - own) > part * own:
                faults.append(f"log {seed}: {name} stated {stated}, on the machine {own}")
            if abs(stated * (1 + 2.5 * part) - own) <= part * own:
                faults.append(f"log {seed}: a change of {name} is not noticed")
    return numbers, changes, faults
