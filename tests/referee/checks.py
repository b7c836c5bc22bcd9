"""Recomputation of the checks, their limits, and the verdict."""

import copy
import math
import re
import tomllib

import numpy as np

from figures import Second, continuity, distance, force, mean_target, moved, presses, rho_min, second_cam
from materials import allowable
from result import Unknown, close, field, place, size_of
from units import quantity
from walkers import population as field_of_population, walkers_of


def by_motion(r, rising):
    """|pressure angle| at the angles where the follower rises, or falls."""
    def value(theta, s, v, a, j=None):
        moves = v > 0 if rising else v < 0
        return np.where(moves, np.abs(r.pressure_angle(theta, s, v, a)), 0.0)
    return value


def concave(r):
    def value(theta, s, v, a, j=None):
        rho = r.cam.at(theta, s, v, a)[2]
        return np.where(rho < -r.cam.roller, -rho, np.inf)
    return value


def pressure(r):
    """Hertz pressure. It is infinite where the convex radius of curvature is zero or negative."""
    def value(theta, s, v, a, j=None):
        sharp = presses(r) & (r.radius(theta, s, v, a) <= 1e-9 * size_of(r))
        return np.where(sharp, np.inf, r.hertz(theta, s, v, a))
    return value


def in_time(order):
    return lambda r: (lambda *x: np.abs(x[1 + order]) * r.drive.speed**order)


FOR_EACH = ("velocity", "acceleration", "jerk", "force_min", "force_max", "torque", "power", "power_mean", "torque_rate", "hertz_pressure")

CHECKS = {
    "stroke": (lambda r: (lambda *x: x[1]), True),
    "velocity": (in_time(1), True),
    "acceleration": (in_time(2), True),
    "jerk": (in_time(3), True),
    "force_min": (lambda r: r.force, False),
    "force_max": (lambda r: r.force, True),
    "curvature": (lambda r: r.radius, False),
    "concave": (concave, False),
    "pressure_angle_rise": (lambda r: by_motion(r, True), True),
    "pressure_angle_fall": (lambda r: by_motion(r, False), True),
    "torque": (lambda r: (lambda *x: np.abs(r.torque(*x))), True),
    "power": (lambda r: (lambda *x: np.abs(r.torque(*x)) * r.drive.speed), True),
    "power_mean": (lambda r: (lambda *x: 0.0 * x[1] + r.law.mean(r.torque) * r.drive.speed), True),
    "torque_rate": (lambda r: (lambda t, s, v, a, j: np.abs((r.drive.stiffness * v + r.drive.damping * r.drive.speed * a
                    + r.drive.inertia * r.drive.speed**2 * j) * v + r.drive.force(t, s, v, a) * a)), True),
    "hertz_pressure": (pressure, True),
    "diameter": (lambda r: (lambda *x: 2 * distance(r)(*x)), True),
    "second_diameter": (lambda r: (lambda t, s, v, a, j=None: 2 * np.hypot(*Second(r).at(t, s, v, a)[0])), True),
    "second_curvature": (second_cam, False),
    "second_concave": (lambda r: Second(r).concave, False),
    "second_pressure_angle_rise": (lambda r: Second(r).by_motion(True), True),
    "second_pressure_angle_fall": (lambda r: Second(r).by_motion(False), True),
    "upper_wall": (lambda r: wall(r, 1.0), False),
    "lower_wall": (lambda r: wall(r, -1.0), False),
}


def wall(r, side):
    """Radius of curvature of a wall of the groove at its bottom, where the groove curves towards the wall."""
    floor = r.cam.size["base"] - r.cam.size["depth"]

    def value(theta, s, v, a, j=None):
        with np.errstate(divide="ignore"):
            middle = np.hypot(1.0, v / floor) ** 3 / (a / floor**2)
        return np.where(side * a > 0, side * middle - r.cam.roller, np.inf)

    return value


@field(r"checks\[(\d+)\]\.(.*)")
def check(r, m):
    row, what = r.summary["checks"][int(m[1])], m[2]
    name = row["name"]
    if what == "name":
        known = name in CHECKS or name in ("rms_error", "base_outside_bore", "interference", "second_interference")
        return (name if known else math.nan), 0, 0
    largest = name in ("interference", "second_interference", "rms_error") or CHECKS.get(name, (None, name not in ("base_outside_bore", "upper_wall", "lower_wall")))[1]
    if what == "pass":
        worst, limit = float(row["worst"]), float(row["limit"])  # infinite ones are texts
        margin = limit - worst if largest else worst - limit
        return bool(margin >= -max(1e-9 * abs(limit), 1e-12)), 0, 0
    if what == "limit":
        return check_limit(r, name, row)
    if name == "rms_error":
        if "population" in r.summary and what == "worst":
            percent, relative, absolute = field_of_population(r, [None, "objective_percent"])
            return percent / 100 * mean_target(r), relative, absolute
        return force(r, [None, "rms_error_n"]) if what == "worst" else (0.0, 0, 0)
    if name == "base_outside_bore":
        return close(r.cam.size["base"], 1e-9) if what == "worst" else (0.0, 0, 0)
    if name.endswith("interference"):
        return (interference(r, name.startswith("second")), 0, 1e-7 * size_of(r)) if what == "worst" else (0.0 if row["worst"] == 0 else row["at_rad"], 0, 0)
    if name not in CHECKS:
        raise Unknown(f"check {name}")
    value, _ = CHECKS[name]
    if "population" in r.summary and name in FOR_EACH:
        # The walker with the largest value.
        runs = []
        for _, _, drive in walkers_of(r):
            run = copy.copy(r)
            run.drive = drive
            runs.append((run.law.extreme(value(run), largest)[0], run))
        worst, run = max(runs, key=lambda pair: pair[0] if largest else -pair[0])
        return close(worst, 1e-6, 1e-9) if what == "worst" else place(run, value(run), row["at_rad"], worst)
    worst = r.law.extreme(value(r), largest)[0]
    if what == "at_rad":
        return place(r, value(r), row["at_rad"], worst)
    if name == "stroke":
        worst -= r.law.extreme(lambda *x: x[1], False)[0]
    # The force on a shaft with a settling speed is known relative to the mean force, not to a force near zero.
    known = moved(r) * mean_target(r) if name.startswith("force_") and r.target is not None and r.motion else 1e-9
    return close(worst, 1e-6, known)


# DIN 6885-1: bores up to this diameter, mm, with width and depth of the keyway in the hub, mm.
KEYWAYS = ((8, 2, 1.0), (10, 3, 1.4), (12, 4, 1.8), (17, 5, 2.3), (22, 6, 2.8), (30, 8, 3.3), (38, 10, 3.3), (44, 12, 3.3), (50, 14, 3.8), (58, 16, 4.3),
           (65, 18, 4.4), (75, 20, 4.9), (85, 22, 5.4), (95, 25, 5.4), (110, 28, 6.4))
DEFAULT_ANGLE = {"translating": math.radians(30), "oscillating": math.radians(35), "outer": math.radians(45)}


def check_limit(r, name, row):
    limits = r.scene.get("limits", {})
    on_first = name.removeprefix("second_")
    key = name if name in limits else on_first
    given = quantity(limits.get(key, limits.get("pressure_angle") if name.startswith("pressure_angle") else None))
    if given is not None:
        return close(given, 1e-12)
    second = name.startswith("second_")
    name = name.removeprefix("second_")
    if name == "hertz_pressure":
        return close(allowable(r.scene), 1e-9)
    if name.startswith("pressure_angle"):
        return close(DEFAULT_ANGLE["outer"], 1e-12)
    if name in ("curvature", "force_min", "upper_wall", "lower_wall"):
        return close(0.0)
    if name == "concave":
        return close(Second(r).cam.roller if second else r.cam.roller, 1e-12)
    if name == "interference":
        return close(1e-6 * (Second(r).cam.size if second else r.cam.size)["prime"], 1e-9)
    if name == "base_outside_bore":
        bore, half = quantity(r.scene["cam"]["bore"]), quantity(r.scene["cam"]["bore"]) / 2
        if r.scene["cam"].get("keyway") == "auto":
            width, depth = next(row[1:] for row in KEYWAYS if 1e3 * bore <= row[0])
            return close(math.hypot(half + 1e-3 * depth, 5e-4 * width), 1e-9)
        return close(half, 1e-12)
    if name == "rms_error":
        share = quantity(r.scene.get("accuracy", {}).get("rms", "auto"))
        return close((0.005 if share is None else share) * mean_target(r), 2e-4)
    raise Unknown(f"limit of {name}")


def interference(r, second=False):
    """Maximum penetration of the follower into the profile."""
    if r.cam.kind in ("translating-cam", "barrel"):
        return 0.0
    motion = [r.law(r.theta, k) for k in range(3)]
    if second:
        contact, pitch, _, _ = Second(r).at(r.theta, *motion)
        x, y = r.cam.on_cam(contact, r.theta)
    else:
        contact, pitch, _, _ = r.cam.at(r.theta, *motion)
        x, y = r.profile["x_m"], r.profile["y_m"]
    worst = 0.0
    for i in range(0, len(r.theta), 4):
        theta = r.theta[i]
        cos, sin = math.cos(theta), math.sin(theta)
        u, w = cos * x - sin * y, sin * x + cos * y
        if r.cam.kind == "flat-translating":
            worst = max(worst, float(np.max(w)) - contact[1][i])
        elif r.cam.kind == "flat-oscillating":
            pivot = r.cam.size["pivot"]
            side = math.copysign(1.0, pivot)
            xi = math.asin((r.cam.size["base"] - r.cam.size["face_offset"]) / abs(pivot)) + float(r.law(theta)[0])
            height = r.cam.size["face_offset"] + abs(pivot) * math.sin(xi)
            worst = max(worst, float(np.max(side * math.sin(xi) * u + math.cos(xi) * w)) - height)
        else:
            worst = max(worst, r.cam.roller - float(np.min(np.hypot(u - pitch[0][i], w - pitch[1][i]))))
    return max(worst, 0.0)


@field(r"cam_das")
def cam_das(r, m):
    smooth = {name: continuity(r, [None, name])[0] for name in "svaj"}
    constant = "breadth" in r.scene["cam"]
    if smooth["s"] and smooth["v"] and smooth["a"] and smooth["j"]:
        return "acceptable", 0, 0
    if smooth["s"] and smooth["v"] and smooth["a"]:
        return "not-for-high-speed", 0, 0
    return ("acceptable" if constant and smooth["s"] and smooth["v"] else "unacceptable"), 0, 0


@field(r"outcome")
def outcome(r, m):
    if "infeasible" in r.summary or not r.is_built:
        return "infeasible", 0, 0
    return ("out-of-time" if r.summary.get("out_of_time") else "built"), 0, 0


@field(r"verdict")
def verdict(r, m):
    if not r.is_built:
        return "unacceptable", 0, 0
    smooth = {name: continuity(r, [None, name])[0] for name in "svaj"}
    failed = [row for row in r.summary["checks"] if not row["pass"]]
    if not smooth["s"] or not smooth["v"] or failed or "infeasible" in r.summary:
        return "unacceptable", 0, 0
    usual = DEFAULT_ANGLE["oscillating" if "oscillating" in r.cam.kind else "translating"]
    angles = [row for row in r.summary["checks"] if row["name"].removeprefix("second_").startswith("pressure_angle")]
    limits = r.scene.get("limits", {})
    steep = any(row["worst"] > usual + 1e-9 for row in angles
                if row["name"].removeprefix("second_") not in limits and "pressure_angle" not in limits)
    cusp = abs(rho_min(r, None)[0]) <= 1e-9 * size_of(r)
    return ("not-for-high-speed" if steep or cusp or not smooth["a"] else "acceptable"), 0, 0


@field(r"out_of_time")
def out_of_time(r, m):
    return False, 0, 0


@field(r"scene\..*")
def scene_value(r, m):
    """Checks that the scene of the summary equals scene.toml."""
    value = tomllib.loads((r.folder / "scene.toml").read_text())
    for key in re.findall(r"[^.\[\]]+", m[0])[1:]:
        value = value[int(key) if isinstance(value, list) else key]
    return value, 0, 0
