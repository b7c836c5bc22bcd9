"""Recomputation of an identification: logs of machines with known parameters, and a least-squares fit of their samples."""

import functools
import json
import math
import subprocess

import numpy as np

GRAVITY = 9.81
# The machine, in the order of the columns: load cell N, mass kg, damping N s/m, friction N.
KEYS = ("log.bias", "drive.mass", "guide.damping", "guide.friction")
TRUTH = np.array([4.0, 73.0, 20.0, 3.0])
CYCLES, RATE, NOISE, DELAY = 30, 500, 2.0, 0.001
LOGS = 6
# Time shifts of the load cell, rad, that are tried around the best of the coarser ones.
SHIFTS = 61


def columns(law, speed, theta):
    v, a = law(theta, 1), law(theta, 2)
    return np.stack([np.ones_like(theta), GRAVITY + speed**2 * a, speed * v, np.sign(v)], axis=1)


def not_negative(matrix, y):
    """Least squares with non-negative damping and friction: the best of all choices of zero parameters."""
    best = None
    for left_out in ((), (2,), (3,), (2, 3)):
        kept = [k for k in range(len(KEYS)) if k not in left_out]
        found = np.zeros(len(KEYS))
        found[kept] = np.linalg.lstsq(matrix[:, kept], y, rcond=None)[0]
        rest = float(np.sum((matrix @ found - y) ** 2))
        if found[2:].min() >= 0 and (best is None or rest < best[1]):
            best = found, rest
    return best


def fit(law, speed, theta, y):
    """Parameters, and delay in s, with the best fit of all samples."""
    centre, width = 0.0, 0.2
    while width > 1e-7:
        shifts = centre + width * np.linspace(-1, 1, SHIFTS)
        fits = [not_negative(columns(law, speed, theta - max(shift, 0.0)), y) for shift in shifts]
        best = min(range(SHIFTS), key=lambda i: fits[i][1])
        centre, width = max(shifts[best], 0.0), 4 * width / SHIFTS
    return fits[best][0], centre / speed


def logged(law, speed, seed):
    """Time, cam angle and force of a run."""
    scatter = np.random.default_rng(seed)
    time = np.arange(round(CYCLES * 2 * math.pi / speed * RATE)) / RATE
    theta = 0.7 + speed * time
    force = columns(law, speed, theta - DELAY * speed) @ TRUTH
    return time, theta, force + scatter.normal(0, NOISE, len(time))


@functools.cache
def both(gaitcam, result, folder, seed):
    """Output of gaitcam for a log, and parameters and delay of the independent fit."""
    speed = result.drive.speed
    time, theta, force = logged(result.law, speed, seed)
    path = folder / f"log_{seed}.csv"
    path.write_text("time_s,theta_rad,force_n\n" + "".join(f"{t:.4f},{a % math.tau:.9f},{f:.6f}\n" for t, a, f in zip(time, theta, force)))
    run = subprocess.run([gaitcam, "identify", str(result.folder), str(path), "--json"], capture_output=True, check=True, text=True)
    return json.loads(run.stdout), *fit(result.law, speed, theta, force)


def judge(gaitcam, result, folder, change=None):
    """Numbers of values and differing lines. `change` alters the value of one parameter in the output of the program."""
    speed, faults, count, missed, intervals = result.drive.speed, [], 0, 0, 0
    for seed in range(LOGS):
        stated, own, delay = both(gaitcam, result, folder, seed)
        found = {row["key"]: dict(row) for row in stated["parameters"]}
        if change:
            found[change]["value"] += 0.3 * (found[change]["high"] - found[change]["low"])
        values = dict(zip(KEYS, own), **{"log.delay": delay})
        truths = dict(zip(KEYS, TRUTH), **{"log.delay": DELAY})
        for key, value in values.items():
            row, count = found[key], count + 3
            # Means of cycles are compared with all samples. They differ by a fraction of the uncertainty.
            if abs(row["value"] - value) > 0.2 * (row["high"] - row["low"]):
                faults.append(f"log {seed}: {key} stated {row['value']}, recomputed {value}")
            intervals, missed = intervals + 1, missed + (not row["low"] <= truths[key] <= row["high"])
        for key, value, part in (("noise_rms_n", NOISE, 0.05), ("speed_rad_per_s", speed, 1e-4), ("cycles", CYCLES, 1 / CYCLES)):
            count += 1
            if abs(stated[key] - value) > part * value:
                faults.append(f"log {seed}: {key} stated {stated[key]}, in the log {value}")
    if missed > max(2, 0.1 * intervals):
        faults.append(f"{missed} of {intervals} intervals of 95 % do not hold the truth")
    return count, faults


def self_test(gaitcam, result, folder):
    """Parameters whose change is not detected, and the number of changed ones."""
    keys = (*KEYS, "log.delay")
    return [key for key in keys if not judge(gaitcam, result, folder, key)[1]], len(keys)
