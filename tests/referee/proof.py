"""The optimum: what is proved, what binds, what relaxing it buys."""

import math

import numpy as np

import law as laws
from figures import force, mean_target
from on_shaft import inertia, share_of
from optimum import Program
from result import Unknown, close, field
from units import quantity
from walkers import walkers_of


def program_of(r, relaxed=None):
    """The convex program of a law without other demands than limits that are linear in it; `Unknown` elsewhere."""
    law, scene = r.summary["law"], r.scene
    if isinstance(law["functions"], str) and law["functions"] != "fourier" or "monomial" in law["functions"]:
        raise Unknown("certificate of this family")
    # Harmonics are those of the force: the key has no effect there.
    minimised = "force-error" if law["functions"] == "fourier" else scene["law"].get("minimise", "force-error")
    if minimised not in ("force-error", "acceleration", "jerk") or r.target is None:
        raise Unknown("certificate of this objective")
    if any(key in scene["law"] for key in ("monotone", "polydyne")) or "weight" in scene.get("gait", {}):
        raise Unknown("certificate with such demands")
    if r.motion is not None and r.motion.shaft is not None and r.is_timed:
        raise Unknown("certificate under a motor")
    if "population" in r.summary and (scene["law"].get("robust", "mean") != "mean" or set(scene["limits"]) - {"stroke", "curvature"}):
        raise Unknown("certificate of such a population")
    if "learned_force" in r.machine or "natural_frequency" in r.machine or "stiffness" in r.machine:
        raise Unknown("certificate of such a machine")
    count, degree = len(law["coefficients"]), law["degree"]
    if law["functions"] == "fourier":
        law_of = laws.fourier
    else:
        knots = law["functions"]["b-spline"]["knots_rad"]
        law_of = lambda c: laws.spline(knots, degree, c)
    program = Program(law_of, count, r.drive, (r.theta, r.target))
    for point in scene["law"].get("point", []):
        for order, key in enumerate(("lift", "velocity", "acceleration", "jerk")):
            if key in point:
                program.demand(order, [quantity(point["angle"])], quantity(point[key]))
    for dwell in scene["law"].get("dwell", []):
        if "lift" not in dwell:
            raise Unknown("certificate with a dwell of free lift")
        program.demand(0, np.linspace(quantity(dwell["from"]), quantity(dwell["to"]), 41), quantity(dwell["lift"]))
    w = r.drive.speed
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
            program.add(name, sign * program.force, sign * (bound - program.rest))
        elif name in ("curvature", "bore") and r.cam.kind == "flat-translating" and r.scene["cam"].get("base_radius", "auto") == "auto":
            continue  # the base circle grows until the limit holds
        else:
            raise Unknown(f"certificate under limits.{name}")
    if "population" in r.summary:
        for_walkers(r, program)
    order = {"acceleration": 2, "jerk": 3}.get(minimised)
    if order is not None:
        program.objective = (program.basis[order], np.zeros(len(program.theta)))
    elif r.drive.kind == "moving-axis" and "force_min" not in scene.get("limits", {}):
        program.add("force_min", -program.force, program.rest)
    return program


def for_walkers(r, program):
    """The mean square of the force errors of all walkers as objective."""
    rows, aims = [], []
    for _, target, drive in walkers_of(r):
        w, wanted = drive.speed, target(program.theta)
        size = 1.0 if r.scene["law"].get("error") == "absolute" else float(np.mean(wanted))
        rows.append((drive.stiffness * program.basis[0] + drive.damping * w * program.basis[1] + drive.inertia * w * w * program.basis[2]) / size)
        aims.append((wanted - drive.rest) / size)
    program.objective = (np.vstack(rows), np.concatenate(aims))


def best_of(r, relaxed=None):
    """Program and its optimum."""
    def solve():
        program = program_of(r, relaxed)
        return (program, *program.best())
    return r.kept(f"best of {relaxed}", solve)


def holds_motion(r):
    """Whether the law was found for one motion of shaft or floor, so that no law with another one is excluded."""
    shaft = r.summary.get("shaft_design")
    turned = shaft is not None and (shaft["rounds"] > 0 or r.scene["law"].get("shaft") == "constant")
    return turned or "floor" in r.summary


@field(r"solver\.doubt|solver\.certificate\.scope")
def doubt(r, m):
    if r.summary["law"]["functions"] == "double-harmonic":
        return "local", 0, 0
    if not holds_motion(r):
        raise Unknown("why there is no proof")
    return "fixed-motion", 0, 0


@field(r"solver\.certified")
def certified(r, m):
    """Prescribed laws have nothing to prove; otherwise no law of the family is better than the stated one."""
    if holds_motion(r) or r.summary["law"]["functions"] == "double-harmonic":
        return False, 0, 0
    if isinstance(r.summary["law"]["functions"], str) and r.summary["law"]["functions"] != "fourier" or "monomial" in r.summary["law"]["functions"]:
        return True, 0, 0
    program, _, least, _ = best_of(r)
    stated = program.value(r.summary["law"]["coefficients"])
    return bool(stated <= least * (1 + 2e-5) + 1e-12 * program.size()), 0, 0


@field(r"binding\[(\d+)\]\.(.*)")
def binding(r, m):
    row = r.summary["binding"][int(m[1])]
    program, _, _, dual = best_of(r)
    names = np.array(program.names)
    if m[2] == "limit":
        return (row["limit"] if row["limit"] in names else math.nan), 0, 0
    if m[2] == "multiplier":
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


def round_step(value):
    """The distance between numbers of four digits."""
    return 10 ** (math.floor(math.log10(abs(value))) - 3)


@field(r"relaxations\[(\d+)\]\.(from|to)")
def relaxed(r, m):
    """The least change of four digits: with it the optimum reaches the accuracy, with the round value before it does not."""
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
        error = next(check for check in r.summary["checks"] if check["name"] == "rms_error")
        own = error["worst"] / mean_target(r)
        return (row["to"] if own <= row["to"] <= own + 1.001 * round_step(own) else math.nan), 1e-12, 0
    if section != "limits":
        raise Unknown(f"change of {row['key']}")
    part = row["to"] / row["from"]
    reaches = lambda factor, slack: best_of(r, (name, factor))[2] <= (allowed * mean_target(r)) ** 2 * (1 + slack)
    before = (row["to"] - math.copysign(1.001 * round_step(row["to"]), row["to"] - row["from"])) / row["from"]
    return (row["to"] if reaches(part, 1e-4) and not reaches(before, -1e-4) else math.nan), 1e-12, 0
