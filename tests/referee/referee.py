#!/usr/bin/env python3
"""Recomputes every number of a result folder independently, with numpy only.

    python3 tests/referee/referee.py DIR                 prints field, stated, recomputed, difference
    python3 tests/referee/referee.py DIR --self-test     changes each number in turn and fails if a change is not detected

Reads summary.json, scene.toml, law.csv and profile.csv. The exit code is 1 if a number differs or has no recomputation.
"""

import argparse
import copy
import math
import os
import re
import sys
from pathlib import Path

# The matrices are small: threads of the linear algebra would make it slower.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent))
import checks  # noqa: F401 (registers its fields)
import figures  # noqa: F401
import on_shaft  # noqa: F401
import proof  # noqa: F401
import simulated  # noqa: F401
import walkers
import walking  # noqa: F401
from result import FIELDS, Result, Unknown, model_of, size_of

# Records of the run itself. They do not follow from the design.
# The digits of the certificate are those of the solver. The field solver.certified, which they support, is recomputed.
RECORDS = re.compile(r"(population\.(gap|rounds)|shaft_design\.(rounds|contraction)|simulation\.details\.(profile|law)_mismatch_m|solver\.(tier|iterations|solve_s|certificate.*)|time\.total_s)$")
# Texts. Their numbers are those of the fields.
TEXTS = re.compile(r"(name|simulation\.(why|details\.(notes|next|impacts).*)|reason|remarks.*|verdict_text\..*|solver\.status|reasons\[\d+\]\..*|relax.*\.(key|limit)|infeasible\..*words)$")


def leaves(value, path=""):
    if isinstance(value, dict):
        for key, inner in value.items():
            yield from leaves(inner, f"{path}.{key}" if path else key)
    elif isinstance(value, list):
        for i, inner in enumerate(value):
            yield from leaves(inner, f"{path}[{i}]")
    else:
        yield path, value


def number(value):
    return {"inf": math.inf, "-inf": -math.inf}.get(value, value) if isinstance(value, str) else value


def agrees(stated, own, relative, absolute):
    stated = number(stated)
    if isinstance(stated, bool) or isinstance(own, bool) or not isinstance(stated, (int, float)) or not isinstance(own, (int, float)):
        return stated == own
    if math.isinf(stated) or math.isinf(own):
        return stated == own
    return abs(stated - own) <= max(relative * abs(own), absolute)


def statements(result):
    """All stated values of the result: the summary, and the run below the key `simulation`."""
    return {**result.summary, **({"simulation": result.simulation} if result.simulation else {})}


def judge(result, only=None):
    """Rows (field, stated, recomputed, difference or reason), and the number of faults."""
    rows, faults = [], 0
    for path, stated in leaves(statements(result)):
        if only is not None and path != only:
            continue
        if TEXTS.match(path) or RECORDS.search(path):
            continue
        for pattern, function in FIELDS:
            match = pattern.match(path)
            if match:
                try:
                    own, relative, absolute = function(result, match)
                except Unknown as unknown:
                    rows.append((path, stated, None, f"no recomputation: {unknown}"))
                    faults += 1
                    break
                right = agrees(stated, own, relative, absolute)
                faults += not right
                rows.append((path, stated, own, "" if right else "DIFFERS"))
                break
        else:
            rows.append((path, stated, None, "no recomputation"))
            faults += 1
    return rows, faults


def judge_rows(r):
    """Faults of the columns of law.csv and profile.csv, each compared with its recomputation."""
    motion = [r.law(r.theta, k) for k in range(4)]
    own = dict(zip(r.columns[1:5], motion))
    own["force_n"] = r.force(r.theta, *motion[:3])
    shaft = r.motion.shaft if r.motion is not None else None
    own["speed_rad_per_s"] = np.full_like(r.theta, r.drive.speed) if shaft is None else shaft.speed(r.theta)
    own["time_s"] = (r.theta - r.theta[0]) / r.drive.speed if shaft is None else shaft.clock(r.theta)
    own["target_n"] = target_of(r)
    contact, pitch, rho, angle = r.cam.at(r.theta, *motion[:3])
    for point, names in ((contact, ("x_m", "y_m")), (pitch, ("pitch_x_m", "pitch_y_m"))):
        own.update(zip(names, r.cam.on_cam(point, r.theta)))
    own["pressure_angle_rad"] = angle
    with np.errstate(divide="ignore"):
        own["1/rho_m"] = 1 / rho
        stated = {**r.rows, **r.profile, "1/rho_m": 1 / r.profile["rho_m"]}
    rows, faults = [], 0
    for name in [*r.columns[1:], *list(r.profile)[1:]]:
        name = "1/rho_m" if name == "rho_m" else name
        if own.get(name) is None:
            if np.isfinite(stated[name]).any():
                rows.append((f"rows.{name}", "", "", "no recomputation"))
                faults += 1
            continue
        wrong = np.abs(stated[name] - own[name])
        wrong[~np.isfinite(stated[name]) & ~np.isfinite(own[name])] = 0.0
        if name == "1/rho_m":  # near a cusp an error of the radius counts
            wrong = wrong / (1 + (size_of(r) * np.nan_to_num(own[name], posinf=0.0, neginf=0.0)) ** 2)
        # At a jump between segments a row may have the value of either side.
        if name.startswith(("a_", "j_")) or name in ("force_n", "1/rho_m"):
            wrong = np.delete(wrong, np.argsort(wrong)[-2 * len(r.law.pieces):]) if r.summary["law"]["functions"] == "segments" else wrong
        worst = float(np.max(wrong)) if wrong.size else 0.0
        size = float(np.nanmax(np.abs(np.where(np.isfinite(own[name]), own[name], 0.0))))
        right = worst <= max(accuracy_of_row(r, name) * size, 1e-12)
        faults += not right
        rows.append((f"rows.{name}", f"differs by {worst:.1e}", f"of {size:.3g}", "" if right else "DIFFERS"))
    if "population" in r.summary:
        for name, value in walkers.rows(r).items():
            worst = float(np.max(np.abs(np.array([float(x) for x in walkers.column(r, name)]) - value) / np.abs(value)))
            faults += worst > 4e-4
            rows.append((f"walkers.{name}", f"differs by {worst:.1e}", "of itself", "DIFFERS" if worst > 4e-4 else ""))
    if r.simulation:
        for name, value in simulated.columns(r).items():
            stated, size = r.run_columns[name], max(float(np.max(np.abs(value))), 1e-9)
            worst = float(np.max(np.abs(stated - value)))
            right = worst <= max(1e-6, simulated.accuracy(r)) * size
            faults += not right
            rows.append((f"rows.{name}", f"differs by {worst:.1e}", f"of {size:.3g}", "" if right else "DIFFERS"))
    return rows, faults


def accuracy_of_row(r, name):
    """Tolerance for a varying speed, which the steps of the program resolve. For a target with kinks it has a cubic between 1024 samples."""
    if name == "target_n" and (r.is_recorded or r.scene["gait"].get("model") in figures.STANCES):
        return 1e-5 if r.is_recorded else 1e-3
    if name == "force_n" and r.drive.learned:  # a cubic between samples of its harmonics
        return 2e-6
    if name not in ("force_n", "target_n", "time_s", "speed_rad_per_s") or r.motion is None:
        return 1e-9
    return 2e-6 if r.motion.shaft is None else 2e-4 if name == "force_n" else 5e-5


def target_of(r):
    """Target of the load model in the scene, at the rows; `None` for a recording."""
    own = model_of(r)
    return None if own is None else own(r.motion.phase(r.theta) if r.motion is not None and r.is_timed else r.theta)


# Estimates, and numbers found by a search to 1 %. The self-test changes them by 5 %.
COARSE = re.compile(r"((simulation\.)?shaft\.least_inertia_kg_m2|shaft_design\.(sensitivity|forecast).*)$")

# A phase of 1e-5 cannot be distinguished from 0, nor 1e-4 W from a mean power of hundreds. These are changed by 1 mrad and 50 mW.
SIGNED = re.compile(r"(_phase_rad|machine\.power_mean_w|simulation\.torque\.mean)$")


def changed(value, path=""):
    if isinstance(value, bool):
        return not value
    if isinstance(value, (int, float)) and SIGNED.search(path):
        return value + 1e-3 * max(1.0, abs(value)) if path.endswith("rad") else value + 0.05
    if isinstance(value, (int, float)):
        return value * (1.05 if COARSE.match(path) else 1.001) if abs(value) > 1e-7 else 1e-3
    return value + "x" if isinstance(value, str) else 1.0


def put(summary, path, value):
    keys = [int(k[1:-1]) if k.startswith("[") else k for k in re.findall(r"[^.\[\]]+|\[\d+\]", path)]
    for key in keys[:-1]:
        summary = summary[key]
    summary[keys[-1]] = value


def self_test(folder, fields=""):
    """Fields that match a pattern and whose change by 0.1 % is not detected."""
    whole = Result(folder)
    missed, count = [], 0
    for path, stated in list(leaves(statements(whole))):
        if TEXTS.match(path) or RECORDS.search(path) or not re.match(fields, path):
            continue
        summary = copy.deepcopy(statements(whole))
        put(summary, path, changed(number(stated), path))
        simulation = summary.pop("simulation", None)
        count += 1
        try:
            faults = judge(Result(folder, summary, simulation), path)[1]
        except Exception:  # a changed number that no longer makes a law is noticed
            faults = 1
        if not faults:
            missed.append(path)
    return missed, count


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder")
    parser.add_argument("--self-test", action="store_true")
    parser.add_argument("--all", action="store_true", help="print fields that agree too")
    asked = parser.parse_args()
    if asked.self_test:
        missed, count = self_test(asked.folder)
        print(f"{count} fields changed in turn, {len(missed)} changes not noticed")
        for path in missed:
            print("  " + path)
        return bool(missed)
    result = Result(asked.folder)
    rows, faults = judge(result)
    if result.is_built:
        more, worse = judge_rows(result)
        rows, faults = rows + more, faults + worse
    for path, stated, own, note in rows:
        if note or asked.all:
            print(f"{path:45} {stated!s:24} {own!s:24} {note}")
    print(f"{len(rows)} fields, {faults} faults")
    return bool(faults)


if __name__ == "__main__":
    sys.exit(main())
