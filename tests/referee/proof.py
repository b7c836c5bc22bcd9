"""Recomputation of the optimum: certificate, active limits, effect of relaxing them."""

import math

import numpy as np

import law as laws
import sized
from figures import force, mean_target
from on_shaft import inertia, share_of
from optimum import ANGLES, Program, interior_point
from result import Unknown, close, field
from units import quantity
from walkers import population as number_of_population
from walkers import walkers_of


FINE = 4 * ANGLES


def program_of(r, relaxed=None, weights=None, angles=ANGLES, spans=None):
    """Convex program of a law whose only demands are limits that are linear in it, with its own spans or others of equal length; `Unknown` for
    other laws."""
    law, scene = r.summary["law"], r.scene
    if isinstance(law["functions"], str) and law["functions"] != "fourier" or "monomial" in law["functions"]:
        raise Unknown("certificate of this family")
    # The harmonics are those of the force, so that the key has no effect there.
    minimised = "force-error" if law["functions"] == "fourier" else scene["law"].get("minimise", "force-error")
    if minimised not in ("force-error", "acceleration", "jerk") or r.target is None:
        raise Unknown("certificate of this objective")
    if any(row["limit"] == "accuracy.rms" for row in r.summary["binding"]):
        raise Unknown("certificate under a limit on the force error")
    if scene["law"].get("monotone") is True or scene["law"].get("polydyne") is True or "weight" in scene.get("gait", {}):
        raise Unknown("certificate with such demands")
    if r.motion is not None and r.motion.shaft is not None and r.is_timed:
        raise Unknown("certificate under a motor")
    count, degree = len(law["coefficients"]), law["degree"]
    if law["functions"] == "fourier":
        law_of = laws.fourier
    else:
        knots = law["functions"]["b-spline"]["knots_rad"] if spans is None else 2 * math.pi * np.arange(spans) / spans
        count = len(knots)
        law_of = lambda c: laws.spline(knots, degree, c)
    program = Program(law_of, count, r.drive, (r.theta, r.target), angles=angles)
    for point in scene["law"].get("point", []):
        for order, key in enumerate(("lift", "velocity", "acceleration", "jerk")):
            if key in point:
                program.demand(order, [quantity(point["angle"])], quantity(point[key]))
    for dwell in scene["law"].get("dwell", []):
        if "lift" not in dwell:
            raise Unknown("certificate with a dwell of free lift")
        program.demand(0, np.linspace(quantity(dwell["from"]), quantity(dwell["to"]), 41), quantity(dwell["lift"]))
    drives = [drive for _, _, drive in walkers_of(r)] if "population" in r.summary else [r.drive]
    w = max(abs(drive.speed) for drive in drives)
    for name, value in scene.get("limits", {}).items():
        bound = quantity(value)
        if bound is None:
            continue
        bound *= relaxed[1] if relaxed and name == relaxed[0] else 1.0
        if name == "stroke":
            program.add(name, program.basis[0], bound)
        elif name in ("velocity", "acceleration", "jerk"):
            k = {"velocity": 1, "acceleration": 2, "jerk": 3}[name]
            for sign in (1, -1):
                program.add(name, sign * w**k * program.basis[k], bound)
        elif name in ("force_min", "force_max"):
            sign = 1 if name == "force_max" else -1
            for force, rest in forces_of(program, drives):
                program.add(name, sign * force, sign * (bound - rest))
        elif name in ("curvature", "bore") and r.cam.kind == "flat-translating" and r.scene["cam"].get("base_radius", "auto") == "auto":
            continue  # the base circle grows until the limit holds
        else:
            raise Unknown(f"certificate under limits.{name}")
    if "population" in r.summary:
        for_walkers(r, program, weights)
    order = {"acceleration": 2, "jerk": 3}.get(minimised)
    if order is not None:
        program.objective = (program.basis[order], np.zeros(len(program.theta)))
    return program


def forces_of(program, drives):
    """Force of each walker's machine, or of one machine on its floor, as rows of the law, and the force at rest."""
    if len(drives) == 1:
        return [(program.force, program.rest)]
    return [(force_rows(program, drive), drive.rest) for drive in drives]


def force_rows(program, drive):
    w = drive.speed
    return drive.stiffness * program.basis[0] + drive.damping * w * program.basis[1] + drive.inertia * w * w * program.basis[2]


def for_walkers(r, program, weights=None):
    """Objective: mean of the squared force errors of all walkers, with weights whose mean is 1."""
    rows, aims = [], []
    population = walkers_of(r)
    for (_, target, drive), weight in zip(population, np.ones(len(population)) if weights is None else weights):
        wanted = target(program.theta)
        size = 1.0 if r.scene["law"].get("error") == "absolute" else float(np.mean(wanted))
        rows.append(math.sqrt(weight) * force_rows(program, drive) / size)
        aims.append(math.sqrt(weight) * (wanted - drive.rest) / size)
    program.objective = (np.vstack(rows), np.concatenate(aims))


def best_of(r, relaxed=None, angles=ANGLES, spans=None):
    """Program and its optimum. For the worst part of a population, the weights are those of the best bound."""
    def solve():
        if str(r.scene["law"].get("robust", "mean")) != "mean" and "population" in r.summary:
            return worst_part(r, relaxed)
        program = program_of(r, relaxed, angles=angles, spans=spans)
        return (program, *program.best())
    return r.kept(f"best of {relaxed} at {angles} with {spans}", solve)


def worst_part(r, relaxed=None):
    """Program whose optimum is a lower bound for the worst part of a population, and this optimum.

    For weights λ with 0 ≤ λ ≤ p/(1 − α) and sum 1, the minimum of Σ λ e² over all laws is a lower bound (Rockafellar and Uryasev
    2000). The best weights maximise Σ λ e² − ½ |Σ λ ∇e² + Aᵀμ|² in the metric of the inverse Hessian at the law. This is a
    quadratic program.
    """
    robust = str(r.scene["law"]["robust"])
    program, count = program_of(r, relaxed), len(walkers_of(r))
    matrix, aim = program.objective
    c, size = np.asarray(r.summary["law"]["coefficients"]), len(program.theta)
    parts = [(matrix[i * size : (i + 1) * size], aim[i * size : (i + 1) * size]) for i in range(count)]
    errors = np.array([np.mean((m @ c - y) ** 2) for m, y in parts])
    slopes = np.stack([2 * m.T @ (m @ c - y) / size for m, y in parts])
    rows, bounds = np.vstack(program.rows), np.concatenate(program.bounds)
    gap = bounds - rows @ c
    near = rows[gap < 1e-5 * np.max(np.abs(rows * c), axis=1)]
    near = near[:: max(1, len(near) // 60)]
    metric = np.linalg.pinv(2 * matrix.T @ matrix / (size * count), rcond=1e-12)
    both = np.vstack([slopes, near])
    cap = 1.0 if robust == "worst" else min(1.0, 1 / count / (1 - float(robust.split()[1])))
    n, total = len(both), np.concatenate([np.ones(count), np.zeros(len(near))])
    limits = np.vstack([-np.eye(n), np.eye(n)[:count]])
    found, _ = interior_point(both @ metric @ both.T, np.concatenate([-errors, np.zeros(len(near))]), limits,
                              np.concatenate([np.zeros(n), np.full(count, cap)]), total[None, :], np.ones(1))
    weights = np.maximum(found[:count], 0.0)
    weighted = program_of(r, relaxed, count * weights / weights.sum())
    return (weighted, *weighted.best())


def holds_motion(r):
    """Whether the law was found for one motion of the shaft, or of the floor if a limit is not linear in the force."""
    shaft = r.summary.get("shaft_design")
    turned = shaft is not None and (shaft["rounds"] > 0 or r.scene["law"].get("shaft") == "constant")
    curved = any(key in r.scene.get("limits", {}) for key in ("torque", "power", "power_mean", "torque_rate", "hertz_pressure"))
    return turned or ("floor" in r.summary and curved)


@field(r"solver\.doubt|solver\.certificate\.scope")
def doubt(r, m):
    if r.summary["law"]["functions"] == "double-harmonic":
        return "local", 0, 0
    if sized.is_sized(r):  # the radius of curvature under a roller is not convex
        return "local", 0, 0
    if not holds_motion(r):
        raise Unknown("why there is no proof")
    return "fixed-motion", 0, 0


@field(r"solver\.certified")
def certified(r, m):
    """Checks that no law of the family is better than the stated one. Prescribed laws have no proof."""
    functions = r.summary["law"]["functions"]
    if functions == "segments" or "monomial" in functions:
        return True, 0, 0
    if holds_motion(r) or functions == "double-harmonic" or sized.is_sized(r):
        return False, 0, 0
    program, _, least, _ = best_of(r)
    if str(r.scene["law"].get("robust", "mean")) != "mean" and "population" in r.summary:
        size = 1.0 if r.scene["law"].get("error") != "absolute" else mean_target(r)
        stated = (number_of_population(r, [None, "objective_percent"])[0] / 100 * size) ** 2
    else:
        stated = program.value(r.summary["law"]["coefficients"])
    return bool(stated <= least * (1 + 2e-5) + 1e-12 * program.size()), 0, 0


@field(r"solver")
def no_solver(r, m):
    return (math.nan if r.is_built else None), 0, 0


@field(r"infeasible\.conflict\[(\d+)\]")
def conflict(r, m):
    """Key that is given in the scene."""
    stated = r.summary["infeasible"]["conflict"][int(m[1])]
    section, _, name = stated.partition(".")
    return (stated if name in r.scene.get(section, {}) else math.nan), 0, 0


@field(r"binding\[(\d+)\]\.(.*)")
def binding(r, m):
    row = r.summary["binding"][int(m[1])]
    if sized.is_sized(r):
        return sized.binding(r, row, m[2])
    found = contact(r, row, m[2], ANGLES)
    if found is None or not found[0] == row[m[2]] and isinstance(found[0], float) and not abs(found[0] - row[m[2]]) <= max(found[1] * abs(found[0]), found[2]):
        found = contact(r, row, m[2], FINE)  # contacts of flat laws need a finer grid
    return found


def contact(r, row, what, angles):
    """Value at a contact, from the multipliers of the limits on a grid of angles."""
    program, _, _, dual = best_of(r, angles=angles)
    names = np.array(program.names)
    if what == "limit":
        return (row["limit"] if row["limit"] in names else math.nan), 0, 0
    if what == "multiplier":
        same = [other["multiplier"] for other in r.summary["binding"] if other["limit"] == row["limit"]]
        return close(float(np.sum(dual[names == row["limit"]])) - (sum(same) - row["multiplier"]), 5e-4, 1e-9)
    theta = np.concatenate([program.theta] * (len(names) // len(program.theta)))
    away = (theta - row["at_rad"] + math.pi) % (2 * math.pi) - math.pi
    near = (names == row["limit"]) & (np.abs(away) < 6 * math.pi / len(program.theta))
    weight = float(np.sum(dual[near]))
    centre = float(np.sum(dual[near] * away[near])) / weight if weight > 1e-4 * np.max(dual) else math.nan
    return row["at_rad"] + centre, 0, 5e-4


@field(r"easing\[(\d+)\]\.(.*)")
def easing(r, m):
    row = r.summary["easing"][int(m[1])]
    limit = row["limit"]
    if sized.is_sized(r):
        return eased_size(r, row, m[2])
    program_of(r)  # a limit outside of the program is not recomputed
    if m[2] == "limit":
        return (limit if limit in r.scene.get("limits", {}) else math.nan), 0, 0
    if m[2] == "objective":
        return "rms_error_n", 0, 0
    if m[2] in ("from", "to"):
        return close(quantity(r.scene["limits"][limit]) * (1.01 if m[2] == "to" else 1.0), 1e-9)
    if m[2] == "before":
        return force(r, [None, "rms_error_n"])
    return close(math.sqrt(best_of(r, (limit, 1.01))[2]), 2e-4)


def eased_size(r, row, what):
    """Change of the smallest cam if a limit is relaxed by 1 %."""
    if what == "limit":
        names = {"pressure_angle_rise", "pressure_angle_fall", "curvature"}
        return (row["limit"] if row["limit"] in names else math.nan), 0, 0
    if what == "objective":
        return "radius_m", 0, 0
    if what in ("from", "to"):
        limit = quantity(r.scene["limits"][row["limit"].removesuffix("_rise").removesuffix("_fall")])
        return close(limit * (1.01 if what == "to" else 1.0), 1e-9)
    return close(sized.best(r, row["limit"] if what == "after" else None)[0], 2e-5)


def round_step(value):
    """Distance between neighbouring numbers of four digits."""
    return 10 ** (math.floor(math.log10(abs(value))) - 3)


@field(r"relaxations\[(\d+)\]\.(from|to)")
def relaxed(r, m):
    """Checks the smallest change of four digits: with it the optimum reaches the accuracy, with the preceding value it does not."""
    row = r.summary["relaxations"][int(m[1])]
    section, _, name = row["key"].partition(".")
    if row["key"] == "machine.inertia":
        return inertia(r, row, m[2])
    allowed = share_of(r)
    if m[2] == "from":
        own = allowed if name == "rms" else quantity(r.scene.get(section, {}).get(name))
        if own is None:
            raise Unknown(f"{row['key']} that the scene does not give")
        return close(own, 1e-9)
    if row["key"] == "accuracy.rms":
        if any(check["name"] == "force_min" and not check["pass"] for check in r.summary["checks"]):
            raise Unknown("accuracy with which the fewest spans keep the force positive")
        error = next(check for check in r.summary["checks"] if check["name"] == "rms_error")
        own = error["worst"] / mean_target(r)
        return (row["to"] if own <= row["to"] <= own + 1.001 * round_step(own) else math.nan), 1e-12, 0
    if section != "limits":
        raise Unknown(f"change of {row['key']}")
    if any(not check["pass"] and check["name"] != "rms_error" for check in r.summary["checks"]):
        raise Unknown(f"change of {row['key']} for another limit than the accuracy")
    part = row["to"] / row["from"]
    reaches = lambda factor, slack, spans=None: best_of(r, (name, factor), spans=spans)[2] <= (allowed * mean_target(r)) ** 2 * (1 + slack)
    before = (row["to"] - math.copysign(1.001 * round_step(row["to"]), row["to"] - row["from"])) / row["from"]
    # With the new value, an automatic number of spans can be larger.
    own = len(r.summary["law"]["coefficients"])
    more = range(own + 1, 2 * own + 1) if "b-spline" in r.summary["law"]["functions"] and str(r.scene["law"].get("spans", "auto")) == "auto" else []
    enough = reaches(part, 1e-4) or any(reaches(part, 1e-4, spans) for spans in more)
    return (row["to"] if enough and not reaches(before, -1e-4) else math.nan), 1e-12, 0
