"""Recomputation of a population: force error of every walker, and derived values."""

import copy
import csv
import math

import numpy as np

from force import model
from result import Unknown, close, field
from units import quantity

ANGLES = 2880


def column(r, name):
    with open(r.folder / "walkers.csv", newline="") as file:
        return [row[name] for row in csv.DictReader(file)]


def walkers_of(r):
    """Name, target over the phase of the cycle, and drive of each walker of a load model over a range of step frequencies."""
    gait = r.scene["gait"]
    parts = str(gait.get("step_frequency", "")).split(":")
    if len(parts) != 3 or "model" not in gait or gait.get("feet", "both") != "both":
        raise Unknown("walkers from files")
    weight = quantity(gait.get("body_weight", 700.0)) or 700.0
    adjusted = gait.get("adjust", "auto")
    given = {key: quantity(r.scene["drive"].get(key)) is not None for key in ("mass", "speed")}
    sets = {key: not given[key] if adjusted == "auto" else key in adjusted for key in ("mass", "speed")}
    phases = [float(phase) for phase in column(r, "phase_rad")]
    if any(phases) and "phase" not in adjusted:
        raise Unknown("walkers with phases")
    found = []
    for frequency, phase in zip(np.linspace(quantity(parts[0]), quantity(parts[1]), int(parts[2])), phases):
        if model(gait["model"], frequency, weight, np.zeros(1)) is None:
            raise Unknown(f"load model {gait['model']}")
        target = lambda x, f=frequency, p=phase: model(gait["model"], f, weight, x + p)
        drive = copy.copy(r.drive)
        if sets["speed"]:
            drive.speed = 2 * math.pi * frequency
        if sets["mass"] and drive.kind == "moving-axis":
            drive.inertia = drive.mass = weight / drive.gravity
            drive.rest = weight
        found.append((frequency, target, drive))
    return found


def errors(r):
    """RMS force error and mean of the target of each walker."""
    theta = r.law.start + 2 * math.pi * (np.arange(ANGLES) + 0.5) / ANGLES
    motion = [r.law(theta, k) for k in range(3)]
    found = []
    for _, target, drive in walkers_of(r):
        wanted = target(theta)
        off = drive.force(theta, *motion) / drive.lever - wanted
        found.append((math.sqrt(float(np.mean(off**2))), float(np.mean(wanted))))
    return np.array(found)


def tail(values, level):
    """Mean of the largest fraction 1 − level of values of equal weight."""
    values, left, total = np.sort(values)[::-1], (1 - level) * len(values), 0.0
    for value in values:
        total += min(left, 1.0) * value
        left -= min(left, 1.0)
    return total / ((1 - level) * len(values))


@field(r"population\.(.*)")
def population(r, m):
    name, law = m[1], r.scene["law"]
    robust = str(law.get("robust", "mean"))
    level = float(robust.split()[1]) if robust.startswith("cvar") else 0.9
    if name in ("walkers", "cycles"):
        return len(walkers_of(r)), 0, 0
    if name in ("robust", "error"):
        return law.get(name, {"robust": "mean", "error": "relative"}[name]), 0, 0
    found = r.kept("walkers", lambda: errors(r))
    newtons, percent = found[:, 0], 100 * found[:, 0] / found[:, 1]
    if name == "worst_walker":
        own = newtons if law.get("error") == "absolute" else percent
        worst = [walker for walker, value in zip(column(r, "walker"), own) if value >= np.max(own) * (1 - 1e-5)]
        return (r.summary["population"][name] if r.summary["population"][name] in worst else worst[0]), 0, 0
    if name == "bound_percent":
        if r.summary["population"][name] is None and "phase" not in r.scene["gait"].get("adjust", "auto"):
            return None, 0, 0
        raise Unknown("bound over phases")
    if name == "objective_percent":
        own = 100 * newtons / np.mean(found[:, 1]) if law.get("error") == "absolute" else percent
        square = {"m": np.mean, "w": np.max, "c": lambda x: tail(x, level)}[robust[0]](own**2)
        return close(math.sqrt(square), 4e-4)
    values = newtons if name.endswith("_n") else percent
    kind = name.split("_")[0]
    return close({"worst": np.max, "mean": np.mean, "cvar": lambda x: tail(x, level)}[kind](values), 4e-4)


def rows(r):
    """Recomputed columns of walkers.csv."""
    found = r.kept("walkers", lambda: errors(r))
    drives = [drive for _, _, drive in walkers_of(r)]
    return {
        "mass_kg": np.array([drive.mass for drive in drives]), "speed_rad_per_s": np.array([drive.speed for drive in drives]),
        "rms_error_percent": 100 * found[:, 0] / found[:, 1], "rms_error_n": found[:, 0],
    }
