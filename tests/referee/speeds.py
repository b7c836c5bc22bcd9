"""Recomputation of `simulate --speeds`: one cam at several shaft speeds, compared with the load model at each step frequency."""

import copy
import csv
import math
import subprocess

import numpy as np

from machine import TURN, Floor, Motion
from on_shaft import error_over_time
from result import Result, model_of
from units import quantity

RANGE = "1.4 Hz:2.3 Hz:4"
# Relative accuracy at constant speed, and where shaft or floor move.
EXACT, MOVED = 2e-6, 2e-4
COLUMNS = ("rms_error_n", "dlf_1", "dlf_2", "dlf_3", "dlf_4", "torque_max_n_m", "ripple")


def at_speed(r, speed):
    """Recomputed row of the table."""
    run = copy.copy(r)
    run.drive = copy.copy(r.drive)
    run.drive.speed, run.drive.motion, run.motion = speed, None, None
    run.scene = dict(r.scene, gait=dict(r.scene["gait"], step_frequency=speed / TURN))
    run.friction = quantity(r.machine.get("friction", 0.0)) or 0.0
    target = model_of(run)
    lever = lambda *motion: run.cam.lever(*motion, run.friction)
    floor = Floor(r.scene) if "floor" in r.machine else None
    if floor or "motor" in r.machine:
        run.motion = Motion(r.law, copy.copy(run.drive), r.motor(), floor, lever, target)
        run.drive.motion = run.motion
    shaft = run.motion.shaft if run.motion is not None else None
    phase = run.motion.phase if run.motion is not None else lambda theta: theta
    weight = quantity(r.scene["gait"].get("body_weight", 700.0)) or 700.0
    if shaft is not None:
        rms = error_over_time(run, run.motion)[0]
    else:
        rms = math.sqrt(run.law.mean(lambda theta, *x: (run.force(theta, *x) - target(theta)) ** 2))
    own = {"rms_error_n": rms, "torque_max_n_m": run.law.extreme(lambda *x: np.abs(run.torque(*x)))[0]}
    for n in range(1, 5):
        cos, sin = (2 * run.time_mean(lambda theta, *x: run.force(theta, *x) * f(n * phase(theta))) for f in (np.cos, np.sin))
        own[f"dlf_{n}"] = math.hypot(cos, sin) / weight
    speeds = lambda theta, *_: shaft.speed(theta)
    own["ripple"] = (run.law.extreme(speeds)[0] - run.law.extreme(speeds, False)[0]) / speed if shaft is not None else 0.0
    own["contact_lost"] = run.law.extreme(run.force, False)[0] < 0
    return own


def judge(gaitcam, folder):
    """Numbers of values and changes, and the differing lines."""
    out, r = folder / "speeds", Result(folder)
    subprocess.run([gaitcam, "simulate", str(folder), "--speeds", RANGE, "--out", str(out)], check=True, capture_output=True)
    with open(out / "speeds.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    first, last, count = RANGE.split(":")
    speeds = TURN * np.linspace(quantity(first), quantity(last), int(count))
    accuracy = MOVED if {"motor", "floor"} & set(r.machine) else EXACT
    numbers, changes, faults = 0, 0, []
    if len(rows) != len(speeds):
        faults.append(f"{len(rows)} speeds in place of {len(speeds)}")
    for row, speed in zip(rows, speeds):
        own = at_speed(r, speed)
        numbers += 2 + len(COLUMNS)
        if abs(float(row["speed_rad_per_s"]) - speed) > 1e-9 * speed or row["contact_lost"] != str(bool(own["contact_lost"])).lower():
            faults.append(f"speed {row['speed_rad_per_s']}, contact lost {row['contact_lost']}: recomputed {speed}, {own['contact_lost']}")
        for name in COLUMNS:
            right = lambda stated: abs(stated - own[name]) <= accuracy * max(abs(own[name]), 1e-9)
            if not right(float(row[name])):
                faults.append(f"{name} at {speed:.4f} rad/s: stated {row[name]}, recomputed {own[name]}")
            changes += 1
            if right(1.001 * float(row[name]) if float(row[name]) else 1e-3):
                faults.append(f"a change of {name} at {speed:.4f} rad/s is not noticed")
    return numbers, changes, faults
