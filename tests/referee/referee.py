#!/usr/bin/env python3
"""Recomputes every number of a result folder from first principles, with numpy alone.

    python3 tests/referee/referee.py DIR                 prints field, stated, recomputed, difference
    python3 tests/referee/referee.py DIR --self-test     changes each number in turn and fails where that is not noticed

Reads summary.json, scene.toml, law.csv and profile.csv. Exit 1 where a number differs or has no recomputation.
"""

import argparse
import copy
import csv
import json
import math
import re
import sys
import tomllib
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent))
import law as laws
from cam import Cam
from force import CONTACT_MODULUS, Drive, harmonics, model
from optimum import Program
from units import quantity

# Records of the run itself: nothing of the design can tell them.
# The certificate's digits are the solver's own; the claim that they support, solver.certified, is recomputed.
RECORDS = re.compile(r"(solver\.(tier|iterations|solve_s|certificate.*)|time\.total_s)$")
# Texts for people; their numbers are those of the fields.
TEXTS = re.compile(r"(name|reason|remarks.*|verdict_text\..*|solver\.status|reasons\[\d+\]\..*|relax.*\.(key|limit)|infeasible\..*words)$")


class Unknown(Exception):
    """A field without a recomputation."""


def read_rows(path):
    with open(path, newline="") as file:
        rows = list(csv.reader(file))
    columns = {name: np.array([float(row[i]) if row[i] else math.nan for row in rows[1:]]) for i, name in enumerate(rows[0])}
    return rows[0], columns


class Result:
    """A result folder with the law, cam and drive that its summary states."""

    def __init__(self, folder, summary=None):
        self.folder = Path(folder)
        self.summary = summary or json.loads((self.folder / "summary.json").read_text())
        self.scene = self.summary["scene"]
        self.is_built = "law" in self.summary
        if not self.is_built:
            return
        names, self.rows = read_rows(self.folder / "law.csv")
        self.theta = self.rows[names[0]]
        self.columns = names
        self.profile = read_rows(self.folder / "profile.csv")[1]
        self.law = self.stated_law()
        self.cam = Cam(self.summary["cam"]["follower"], self.law, self.sizes(self.summary["cam"]))
        drive = self.summary["drive"]
        lever = quantity(self.scene["drive"].get("lever")) or abs(self.cam.size["arm"] or self.cam.size["pivot"] or 1.0)
        is_arm = "oscillating" in self.cam.kind
        self.drive = Drive(self.scene, drive["mass_kg"], drive["speed_rad_per_s"], lever if is_arm else 1.0)
        self.target = self.rows["target_n"] if np.isfinite(self.rows["target_n"]).all() else None

    def stated_law(self):
        law = self.summary["law"]
        functions, coefficients = law["functions"], law["coefficients"]
        if functions == "fourier":
            return laws.fourier(coefficients)
        if functions == "segments":
            return laws.programme(self.segments())
        if "monomial" in functions:
            return laws.monomial(functions["monomial"]["range_rad"], coefficients)
        if "b-spline" in functions:
            return laws.spline(functions["b-spline"]["knots_rad"], law["degree"], coefficients)
        raise Unknown(f"law.functions {functions}")

    def segments(self):
        found = []
        for row in self.scene["law"]["segment"]:
            motion = row.get("motion", "dwell")
            if motion not in laws.MOTIONS:
                raise Unknown(f"motion {motion}")
            length = quantity(row.get("angle", row.get("length")))
            found.append((motion, quantity(row.get("lift", 0.0)) or 0.0, length))
        if "breadth" in self.scene["cam"]:
            found += [(motion, -lift, length) for motion, lift, length in found]
        return found

    def sizes(self, cam):
        own = self.scene["cam"]
        value = lambda key, default=None: quantity(own.get(key, default))
        roller = value("roller_radius", own.get("arc_radius")) or 0.0
        return {
            "prime": cam["prime_radius_m"], "base": cam["base_radius_m"], "offset": cam.get("offset_m") or 0.0, "roller": roller,
            "arm": value("arm"), "pivot": value("pivot_distance"), "face_offset": value("face_offset", 0.0),
            "depth": value("depth") or 2 * roller, "eccentricity": value("roller_eccentricity", 0.0) or 0.0,
        }

    # --- quantities over the cycle -------------------------------------------------------------

    def pressure_angle(self, theta, s, v, a, j=None):
        if self.cam.kind == "barrel":
            return np.arctan(v / (self.cam.size["base"] - self.cam.size["depth"]))
        return self.cam.at(theta, s, v, a)[3]

    def radius(self, theta, s, v, a, j=None):
        rho = self.cam.at(theta, s, v, a)[2]
        return np.where(rho >= -self.cam.roller, rho, np.inf) if not self.cam.is_face else rho

    def force(self, theta, s, v, a, j=None):
        return self.drive.force(theta, s, v, a) / self.drive.lever

    def torque(self, theta, s, v, a, j=None):
        return self.drive.force(theta, s, v, a) * v

    def hertz(self, theta, s, v, a, j=None):
        size = self.cam.size
        normal = self.drive.force(theta, s, v, a) / (size["arm"] if "oscillating" in self.cam.kind else 1.0)
        normal = normal * self.cam.normal_force_factor(theta, s, v, a)
        length = quantity(self.scene["cam"].get("thickness", 0.010))
        curvature = self.cam.curvature_sum(theta, s, v, a)
        return np.sqrt(np.maximum(normal * curvature, 0.0) * CONTACT_MODULUS / (math.pi * length))


def close(own, relative=1e-6, absolute=1e-12):
    return own, relative, absolute


# --- one function for each group of fields; each returns (own value, relative, absolute tolerance) ----

FIELDS = []


def field(pattern):
    def register(function):
        FIELDS.append((re.compile(pattern + "$"), function))
        return function
    return register


@field(r"law\.(stroke|v_max|v_min|a_max|a_min|j_max|j_min)_.*")
def extreme_of_law(r, m):
    name = m[1]
    if name == "stroke":
        return close(r.law.extreme(lambda *x: x[1])[0] - r.law.extreme(lambda *x: x[1], False)[0])
    order = "svaj".index(name[0])
    for below in range(order):
        jump, size = r.law.jumps(below)
        if below > 0 and jump > 1e-7 * max(size, 1e-12) or below == 0 and jump > 1e-7 * max(size, 1e-12):
            return (math.inf if name.endswith("max") else -math.inf), 0.0, 0.0
    return close(r.law.extreme(lambda *x: x[1 + order], name.endswith("max"))[0], 1e-6, 1e-9 * max(1e-6, r.law.jumps(order)[1]))


@field(r"continuity\.([svaj])")
def continuity(r, m):
    order = "svaj".index(m[1])
    jump, size = r.law.jumps(order)
    return bool(jump <= 1e-7 * max(size, 1e-12)), 0, 0


@field(r"law\.coefficients\[(\d+)\]")
def coefficient(r, m):
    """The law of all stated coefficients has the rows of law.csv; then every one of them is right."""
    i = int(m[1])
    stated = r.summary["law"]["coefficients"]
    if r.summary["law"]["functions"] == "segments":
        return close(r.segments()[i][1], 1e-9)
    sizes = [max(float(np.max(np.abs(r.rows[r.columns[k + 1]]))), 1e-300) for k in range(3)]
    worst = max(float(np.max(np.abs(r.law(r.theta, k) - r.rows[r.columns[k + 1]]))) / sizes[k] for k in range(3))
    return (stated[i] if worst < 1e-9 else math.nan), 1e-12, 1e-12


@field(r"law\.functions\.b-spline\.knots_rad\[(\d+)\]")
def knot(r, m):
    return coefficient_like(r, r.summary["law"]["functions"]["b-spline"]["knots_rad"][int(m[1])])


@field(r"law\.functions\.monomial\.range_rad\[(\d+)\]")
def monomial_range(r, m):
    return coefficient_like(r, r.summary["law"]["functions"]["monomial"]["range_rad"][int(m[1])])


def coefficient_like(r, stated):
    sizes = [max(float(np.max(np.abs(r.rows[r.columns[k + 1]]))), 1e-300) for k in range(3)]
    worst = max(float(np.max(np.abs(r.law(r.theta, k) - r.rows[r.columns[k + 1]]))) / sizes[k] for k in range(3))
    return (stated if worst < 1e-9 else math.nan), 1e-12, 1e-12


@field(r"law\.functions")
def functions(r, m):
    return r.summary["law"]["functions"], 0, 0


@field(r"law\.degree")
def degree(r, m):
    """Pieces of this degree vanish at the next derivative; 0 stands for functions that are not polynomials."""
    kind = r.summary["law"]["functions"]
    if kind == "segments":
        degrees = {"3-4-5": 5, "4-5-6-7": 7, "5-6-7-8-9": 9, "berzak-d": 7, "parabolic": 2, "cubic": 3, "constant-velocity": 1}
        used = [degrees.get(name, 0) for name, lift, _ in r.segments() if name != "dwell"]
        return (max(used) if used and all(used) else 0), 0, 0
    if kind == "fourier":
        return 0, 0, 0
    return (len(r.summary["law"]["coefficients"]) - 1 if "monomial" in kind else r.summary["law"]["degree"]), 0, 0


@field(r"law\.pieces")
def pieces(r, m):
    kind = r.summary["law"]["functions"]
    if kind == "fourier":
        return r.summary["law"]["pieces"], 0, 0
    return len(r.law.pieces), 0, 0


@field(r"law\.phase_rad")
def phase(r, m):
    return close(quantity(r.scene.get("gait", {}).get("phase", 0.0)) or 0.0, 1e-9)


@field(r"law\.family|cam\.follower|drive\.kind")
def named(r, m):
    section, key = m[0].split(".")
    default = {"family": None, "follower": "flat-translating", "kind": None}[key]
    stated = r.scene[section].get(key, default)
    kind = r.summary["law"]["functions"]
    by_functions = {"fourier": "harmonic", "segments": "program"}.get(kind) if isinstance(kind, str) else ("polynomial" if "monomial" in kind else "spline")
    if key == "family":
        return by_functions, 0, 0
    if key == "kind" and stated is None:
        return r.summary["drive"]["kind"], 0, 0
    return stated, 0, 0


@field(r"drive\.mass_kg")
def mass(r, m):
    own = r.scene["drive"].get("mass", r.scene["drive"].get("inertia"))
    value = quantity(own) if own not in (None, "auto") else None
    if value is not None:
        return close(value, 1e-12)
    if r.target is not None and r.drive.kind == "moving-axis":
        return close(float(np.mean(r.target)) / r.drive.gravity, 1e-5)
    return close(0.0)


@field(r"drive\.speed_rad_per_s")
def speed(r, m):
    value = quantity(r.scene["drive"].get("speed", "auto"))
    if value is not None:
        return close(value, 1e-12)
    gait = r.scene.get("gait", {})
    if gait.get("feet", "both") == "both" and quantity(gait.get("step_frequency")):
        return close(2 * math.pi * quantity(gait["step_frequency"]), 1e-12)
    raise Unknown("automatic speed of a recording")


@field(r"cam\.(prime_radius|base_radius|offset)_m")
def size(r, m):
    """Sizes: the profile of the rows belongs to them, and a size that the scene gives is it."""
    z = r.cam.size
    stated = {"prime_radius": z["prime"], "base_radius": z["base"], "offset": r.summary["cam"]["offset_m"]}[m[1]]
    given = quantity(r.scene["cam"].get(m[1], 0.0 if m[1] == "offset" else None))
    if m[1] == "base_radius" and not r.cam.is_face and r.cam.kind != "barrel":
        return close(z["prime"] - z["roller"], 1e-9)
    if m[1] == "prime_radius" and r.cam.is_face or m[1] == "prime_radius" and r.cam.kind == "barrel":
        return close(z["base"], 1e-9)
    if given is not None:
        return close(given, 1e-9)
    return (stated if profile_fits(r) else math.nan), 1e-9, 1e-15


def profile_fits(r):
    contact, pitch, rho, angle = r.cam.at(r.theta, *(r.law(r.theta, k) for k in range(3)))
    worst = 0.0
    for own, names in ((contact, ("x_m", "y_m")), (pitch, ("pitch_x_m", "pitch_y_m"))):
        for value, name in zip(r.cam.on_cam(own, r.theta), names):
            worst = max(worst, float(np.max(np.abs(value - r.profile[name]))))
    return worst < 1e-9


@field(r"cam\.rho_min_m")
def rho_min(r, m):
    return close(r.law.extreme(r.radius, False)[0], 1e-7, 1e-9)


@field(r"cam\.rho_min_at_rad")
def rho_min_at(r, m):
    return place(r, r.radius, r.summary["cam"]["rho_min_at_rad"], r.law.extreme(r.radius, False)[0])


def place(r, value, stated, worst):
    """The stated place where the quantity has its worst value."""
    if stated is None:
        return None, 0, 0
    nearest = math.inf
    for start, end, function in r.law.pieces:
        if start - 1e-9 <= stated <= end + 1e-9:
            theta = np.array([min(max(stated, start), end)])
            found = float(np.ravel(value(theta, *(function(theta, k) for k in range(4))))[0])
            nearest = min(nearest, abs(found - worst))
    return (stated if nearest <= 3e-8 * max(abs(worst), 1e-3 * size_of(r)) else math.nan), 0, 1e-12


def size_of(r):
    return max(r.cam.size["prime"], r.cam.size["base"])


@field(r"cam\.pressure_angle_(max|min)_rad")
def pressure(r, m):
    return close(r.law.extreme(r.pressure_angle, m[1] == "max")[0], 1e-7, 1e-9)


@field(r"cam\.face_width_m")
def face_width(r, m):
    if r.cam.kind == "flat-translating":
        return close(r.law.extreme(lambda *x: x[2])[0] - r.law.extreme(lambda *x: x[2], False)[0], 1e-7)
    if r.cam.kind.startswith("mushroom"):
        high, low = (r.law.extreme(r.pressure_angle, side)[0] for side in (True, False))
        return close(r.cam.size["roller"] * (math.sin(high) - math.sin(low)), 1e-7)
    if r.cam.kind == "flat-oscillating":
        def along(theta, s, v, a, j=None):
            side = math.copysign(1.0, r.cam.size["pivot"])
            xi = math.asin((r.cam.size["base"] - r.cam.size["face_offset"]) / abs(r.cam.size["pivot"])) + s
            return abs(r.cam.size["pivot"]) * np.cos(xi) / (1 + side * v)
        return close(r.law.extreme(along)[0] - r.law.extreme(along, False)[0], 1e-7)
    return None, 0, 0


@field(r"cam\.second\.(base_radius_m|prime_radius_m)")
def second_size(r, m):
    distance = quantity(r.scene["cam"].get("conjugate", {}).get("distance"))
    if distance is None:
        raise Unknown("conjugate pair by angle")
    depth = math.sqrt(r.cam.size["prime"] ** 2 - r.cam.size["offset"] ** 2) if not r.cam.is_face else r.cam.size["base"]
    prime = distance - depth - r.law.extreme(lambda *x: x[1])[0]
    roller = quantity(r.scene["cam"]["conjugate"].get("roller_radius")) or r.cam.size["roller"]
    return close(prime - (roller if m[1].startswith("base") else 0.0), 1e-9)


class Second:
    """The cam of the opposite follower: its lift is what the first one lacks to its highest point."""

    def __init__(self, r):
        self.top = r.law.extreme(lambda *x: x[1])[0]
        second = r.summary["cam"]["second"]
        roller = quantity(r.scene["cam"]["conjugate"].get("roller_radius")) or r.cam.size["roller"]
        self.cam = Cam(r.cam.kind, None, dict(r.cam.size, prime=second["prime_radius_m"], base=second["base_radius_m"], roller=roller))

    def at(self, theta, s, v, a):
        return self.cam.at(theta, self.top - s, -v, -a)

    def radius(self, theta, s, v, a, j=None):
        rho = self.at(theta, s, v, a)[2]
        return np.where(rho >= -self.cam.roller, rho, np.inf) if not self.cam.is_face else rho

    def concave(self, theta, s, v, a, j=None):
        rho = self.at(theta, s, v, a)[2]
        return np.where(rho < -self.cam.roller, -rho, np.inf)

    def by_motion(self, rising):
        def value(theta, s, v, a, j=None):
            moves = -v > 0 if rising else -v < 0
            return np.where(moves, np.abs(self.at(theta, s, v, a)[3]), 0.0)
        return value


def second_cam(r):
    return Second(r).radius


@field(r"cam\.second\.rho_min_m")
def second_rho(r, m):
    return close(r.law.extreme(second_cam(r), False)[0], 1e-7, 1e-9)


@field(r"cam\.second\.rho_min_at_rad")
def second_rho_at(r, m):
    return place(r, second_cam(r), r.summary["cam"]["second"]["rho_min_at_rad"], r.law.extreme(second_cam(r), False)[0])


def presses(r):
    d = r.drive
    return bool(d.rest or d.stiffness or d.damping or d.inertia)


@field(r"force")
def no_force(r, m):
    return (None if not presses(r) else math.nan), 0, 0


@field(r"force\.(.*)")
def force(r, m):
    name = m[1]
    if name in ("mean_n", "min_n", "max_n"):
        if name == "mean_n":
            return close(r.law.mean(r.force), 1e-7)
        return close(r.law.extreme(r.force, name == "max_n")[0], 1e-7, 1e-9)
    if r.target is None:
        return None, 0, 0
    error = r.force(r.theta, *(r.law(r.theta, k) for k in range(3))) - r.target
    mean = float(np.mean(r.target))
    rms = math.sqrt(float(np.mean(error**2)))
    if name == "target_mean_n":
        return close(mean, 2e-4)
    if name == "rms_error_n":
        return close(rms, 4e-4)
    if name == "rms_error_percent_of_mean":
        return close(100 * rms / mean, 4e-4)
    if name == "max_error_n":
        return close(peak_between_rows(np.abs(error)), 4e-4)
    raise Unknown(name)


def peak_between_rows(values):
    """Highest value of a parabola through the highest row and its neighbours."""
    i = int(np.argmax(values))
    a, b, c = values[i - 1], values[i], values[(i + 1) % len(values)]
    bend = a - 2 * b + c
    return float(b if bend >= 0 else b - (c - a) ** 2 / (8 * bend))


@field(r"machine\.(.*)")
def machine(r, m):
    name = m[1]
    if name == "hertz_pressure_allowable_pa":
        if r.scene["cam"].get("hardness") is None:
            return None, 0, 0
        raise Unknown("hardness")
    if not presses(r):
        return None, 0, 0
    high, low = (r.law.extreme(r.torque, side)[0] for side in (True, False))
    if name == "torque_max_n_m":
        return close(max(high, -low), 1e-7)
    if name == "torque_rms_n_m":
        return close(math.sqrt(r.law.mean(lambda *x: r.torque(*x) ** 2)), 1e-7)
    if name == "power_max_w":
        return close(max(high, -low) * r.drive.speed, 1e-7)
    if name == "power_mean_w":
        return close(r.law.mean(r.torque) * r.drive.speed, 1e-6, 1e-9 * max(high, -low) * r.drive.speed)
    if name == "liftoff_speed_rad_per_s":
        return close(r.drive.liftoff(r.law), 1e-7) if r.drive.liftoff(r.law) is not None else (None, 0, 0)
    if name == "hertz_pressure_max_pa":
        if rho_min(r, None)[0] <= 1e-9 * size_of(r):
            return None, 0, 0
        return close(r.law.extreme(r.hertz)[0], 1e-6)
    raise Unknown(name)


@field(r"load_factors\[(\d+)\]\.(.*)")
def load_factor(r, m):
    row = r.summary["load_factors"][int(m[1])]
    gait = r.scene.get("gait", {})
    steps = 2 if gait.get("model") in ("li-2010", "iso-22675") and gait.get("feet") in ("one", "left", "right") else 1
    n = int(m[1]) + 1
    if m[2] == "harmonic":
        return n, 0, 0
    if m[2] == "of_step":
        return close(n / steps, 1e-12)
    if m[2] == "frequency_hz":
        return close(n * r.drive.speed / (2 * math.pi), 1e-12)
    if m[2].startswith("target"):
        amplitude, angle = harmonics(r.target, n)[n - 1]
    else:
        cos = 2 * r.law.mean(lambda *x: r.force(*x) * np.cos(n * x[0]))
        sin = 2 * r.law.mean(lambda *x: r.force(*x) * np.sin(n * x[0]))
        amplitude, angle = math.hypot(cos, sin), math.atan2(cos, sin)
    # Stated as A sin(nθ − φ).
    angle = -angle
    weight = float(np.mean(r.target))
    if not m[2].endswith("phase_rad"):
        return close(amplitude / weight, 2e-4, 1e-8)
    stated = row[m[2]]
    if amplitude < 1e-9 * weight:
        return close(0.0)
    turns = round((stated - angle) / (2 * math.pi))
    return close(angle + 2 * math.pi * turns, 2e-4, 1e-6)


# --- checks: quantity, whether the largest or smallest value counts, and the bound without a limit ----


def by_motion(r, rising):
    """|pressure angle| over the angles where the follower rises, or falls."""
    def value(theta, s, v, a, j=None):
        moves = v > 0 if rising else v < 0
        return np.where(moves, np.abs(r.pressure_angle(theta, s, v, a)), 0.0)
    return value


def concave(r):
    def value(theta, s, v, a, j=None):
        rho = r.cam.at(theta, s, v, a)[2]
        return np.where(rho < -r.cam.roller, -rho, np.inf)
    return value


def in_time(order):
    return lambda r: (lambda *x: np.abs(x[1 + order]) * r.drive.speed**order)


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
    "torque_rate": (lambda r: (lambda t, s, v, a, j: np.abs((r.drive.stiffness * v + r.drive.damping * r.drive.speed * a
                    + r.drive.inertia * r.drive.speed**2 * j) * v + r.drive.force(t, s, v, a) * a)), True),
    "hertz_pressure": (lambda r: r.hertz, True),
    "second_curvature": (second_cam, False),
    "second_concave": (lambda r: Second(r).concave, False),
    "second_pressure_angle_rise": (lambda r: Second(r).by_motion(True), True),
    "second_pressure_angle_fall": (lambda r: Second(r).by_motion(False), True),
    "upper_wall": (lambda r: wall(r, 1.0), False),
    "lower_wall": (lambda r: wall(r, -1.0), False),
}


def wall(r, side):
    """Radius of a wall of the groove at its floor, where the groove bends towards it."""
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
        margin = row["limit"] - row["worst"] if largest else row["worst"] - row["limit"]
        return bool(margin >= -1e-9 * max(abs(row["limit"]), 1e-12)), 0, 0
    if what == "limit":
        return check_limit(r, name, row)
    if name == "rms_error":
        return (force(r, [None, "rms_error_n"]) if what == "worst" else (0.0, 0, 0))
    if name == "base_outside_bore":
        return close(r.cam.size["base"], 1e-9) if what == "worst" else (0.0, 0, 0)
    if name.endswith("interference"):
        return (interference(r, name.startswith("second")), 0, 1e-7 * size_of(r)) if what == "worst" else (0.0 if row["worst"] == 0 else row["at_rad"], 0, 0)
    if name not in CHECKS:
        raise Unknown(f"check {name}")
    value, _ = CHECKS[name]
    worst = r.law.extreme(value(r), largest)[0]
    if name == "stroke":
        worst -= r.law.extreme(lambda *x: x[1], False)[0]
    return close(worst, 1e-6, 1e-9) if what == "worst" else place(r, value(r), row["at_rad"], worst)


DEFAULT_ANGLE = {"translating": math.radians(30), "oscillating": math.radians(35), "outer": math.radians(45)}


def check_limit(r, name, row):
    limits = r.scene.get("limits", {})
    given = quantity(limits.get(name, limits.get("pressure_angle") if name.startswith("pressure_angle") else None))
    if given is not None:
        return close(given, 1e-12)
    second = name.startswith("second_")
    name = name.removeprefix("second_")
    if name.startswith("pressure_angle"):
        return close(DEFAULT_ANGLE["outer"], 1e-12)
    if name in ("curvature", "force_min", "upper_wall", "lower_wall"):
        return close(0.0)
    if name == "concave":
        return close(Second(r).cam.roller if second else r.cam.roller, 1e-12)
    if name == "interference":
        return close(1e-6 * (Second(r).cam.size if second else r.cam.size)["prime"], 1e-9)
    if name == "base_outside_bore":
        return close(quantity(r.scene["cam"]["bore"]) / 2, 1e-12)
    if name == "rms_error":
        share = quantity(r.scene.get("accuracy", {}).get("rms", "auto"))
        return close((0.005 if share is None else share) * float(np.mean(r.target)), 2e-4)
    raise Unknown(f"limit of {name}")


def interference(r, second=False):
    """Depth by which the follower, put back on the profile, cuts it anywhere."""
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
    return ("built" if r.is_built and "infeasible" not in r.summary else "infeasible"), 0, 0


@field(r"verdict")
def verdict(r, m):
    smooth = {name: continuity(r, [None, name])[0] for name in "svaj"}
    failed = [row for row in r.summary["checks"] if not row["pass"]]
    if not smooth["s"] or not smooth["v"] or failed or "infeasible" in r.summary:
        return "unacceptable", 0, 0
    usual = DEFAULT_ANGLE["oscillating" if "oscillating" in r.cam.kind else "translating"]
    angles = [row for row in r.summary["checks"] if row["name"].startswith("pressure_angle")]
    limits = r.scene.get("limits", {})
    steep = any(row["worst"] > usual + 1e-9 for row in angles
                if row["name"] not in limits and "pressure_angle" not in limits)
    cusp = abs(rho_min(r, None)[0]) <= 1e-9 * size_of(r)
    return ("not-for-high-speed" if steep or cusp or not smooth["a"] else "acceptable"), 0, 0


@field(r"out_of_time")
def out_of_time(r, m):
    return False, 0, 0


@field(r"scene\..*")
def scene_value(r, m):
    """The scene of the summary is the one of scene.toml."""
    value = tomllib.loads((r.folder / "scene.toml").read_text())
    for key in re.findall(r"[^.\[\]]+", m[0])[1:]:
        value = value[int(key) if isinstance(value, list) else key]
    return value, 0, 0


# --- the optimum: what is proved, what binds, what relaxing it buys --------------------------------


def program_of(r, relaxed=None):
    """The convex program of a law without other demands than limits that are linear in it; `Unknown` elsewhere."""
    law, scene = r.summary["law"], r.scene
    if isinstance(law["functions"], str) and law["functions"] != "fourier" or "monomial" in law["functions"]:
        raise Unknown("certificate of this family")
    if scene["law"].get("minimise", "force-error") != "force-error" or r.target is None:
        raise Unknown("certificate of this objective")
    if any(key in scene["law"] for key in ("point", "dwell", "monotone", "polydyne")) or "weight" in scene.get("gait", {}):
        raise Unknown("certificate with demands")
    if "machine" in scene:
        raise Unknown("certificate of a machine")
    count, degree = len(law["coefficients"]), law["degree"]
    if law["functions"] == "fourier":
        law_of = laws.fourier
    else:
        knots = law["functions"]["b-spline"]["knots_rad"]
        law_of = lambda c: laws.spline(knots, degree, c)
    program = Program(law_of, count, r.drive, (r.theta, r.target))
    w = r.drive.speed
    for name, value in scene.get("limits", {}).items():
        bound = quantity(value)
        if bound is None:
            continue
        bound *= 1.01 if name == relaxed else 1.0
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
    if r.drive.kind == "moving-axis" and "force_min" not in scene.get("limits", {}):
        program.add("force_min", -program.force, program.rest)
    return program


@field(r"solver\.certified")
def certified(r, m):
    """Prescribed laws have nothing to prove; otherwise no law of the family is better than the stated one."""
    if isinstance(r.summary["law"]["functions"], str) and r.summary["law"]["functions"] != "fourier" or "monomial" in r.summary["law"]["functions"]:
        return True, 0, 0
    program = program_of(r)
    _, least, _ = program.best()
    error = r.force(program.theta, *(r.law(program.theta, k) for k in range(3))) - program.wanted
    own = float(np.mean(error**2))
    return bool(own <= least * (1 + 2e-5) + 1e-12 * float(np.mean(program.wanted)) ** 2), 0, 0


@field(r"binding\[(\d+)\]\.(.*)")
def binding(r, m):
    row = r.summary["binding"][int(m[1])]
    program = program_of(r)
    _, _, dual = program.best()
    names = np.array(program.names)
    if m[2] == "limit":
        return (row["limit"] if row["limit"] in names else math.nan), 0, 0
    if m[2] == "multiplier":
        same = [other["multiplier"] for other in r.summary["binding"] if other["limit"] == row["limit"]]
        return close(float(np.sum(dual[names == row["limit"]])) - (sum(same) - row["multiplier"]), 5e-4, 1e-9)
    theta = np.concatenate([program.theta] * (len(names) // len(program.theta)))
    strong = (names == row["limit"]) & (dual > 1e-4 * np.max(dual))
    away = np.abs((theta[strong] - row["at_rad"] + math.pi) % (2 * math.pi) - math.pi)
    return (row["at_rad"] if away.size and np.min(away) < 4 * math.pi / len(program.theta) else math.nan), 0, 1e-12


@field(r"easing\[(\d+)\]\.(.*)")
def easing(r, m):
    row = r.summary["easing"][int(m[1])]
    limit = row["limit"]
    if m[2] == "limit":
        return (limit if limit in r.scene.get("limits", {}) else math.nan), 0, 0
    if m[2] == "objective":
        return "rms_error_n", 0, 0
    if m[2] in ("from", "to"):
        return close(quantity(r.scene["limits"][limit]) * (1.01 if m[2] == "to" else 1.0), 1e-9)
    if m[2] == "before":
        return force(r, [None, "rms_error_n"])
    return close(math.sqrt(program_of(r, relaxed=limit).best()[1]), 2e-4)


# --- comparing ----------------------------------------------------------------------------------


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


def judge(result, only=None):
    """Rows (field, stated, recomputed, difference or reason) and the count of faults."""
    rows, faults = [], 0
    for path, stated in leaves(result.summary):
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
    """Faults of the columns of law.csv and profile.csv, each against its own recomputation."""
    motion = [r.law(r.theta, k) for k in range(4)]
    own = dict(zip(r.columns[1:5], motion))
    own["force_n"] = r.force(r.theta, *motion[:3])
    own["speed_rad_per_s"] = np.full_like(r.theta, r.drive.speed)
    own["time_s"] = (r.theta - r.theta[0]) / r.drive.speed
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
        # At a jump between segments a row may have the value of either side.
        if name.startswith(("a_", "j_")) or name in ("force_n", "1/rho_m"):
            wrong = np.delete(wrong, np.argsort(wrong)[-2 * len(r.law.pieces):]) if r.summary["law"]["functions"] == "segments" else wrong
        worst = float(np.max(wrong)) if wrong.size else 0.0
        size = float(np.nanmax(np.abs(np.where(np.isfinite(own[name]), own[name], 0.0))))
        right = worst <= 1e-9 * max(size, 1e-9)
        faults += not right
        rows.append((f"rows.{name}", f"differs by {worst:.1e}", f"of {size:.3g}", "" if right else "DIFFERS"))
    return rows, faults


def target_of(r):
    """Target of the load model that the scene names, at the rows; `None` for a recording."""
    gait = r.scene.get("gait", {})
    if "model" not in gait or gait.get("feet", "both") != "both" or quantity(gait.get("phase", 0.0)):
        return None
    frequency, weight = quantity(gait.get("step_frequency")), quantity(gait.get("body_weight", 700.0))
    own = model(gait["model"], frequency, weight, r.theta) if frequency else None
    if own is not None and gait.get("scale") == "to-mass":
        own = own * r.drive.mass * r.drive.gravity / weight
    return own


def changed(value):
    if isinstance(value, bool):
        return not value
    if isinstance(value, (int, float)):
        return value * 1.001 if abs(value) > 1e-9 else 1e-3
    return value + "x" if isinstance(value, str) else 1.0


def put(summary, path, value):
    keys = [int(k[1:-1]) if k.startswith("[") else k for k in re.findall(r"[^.\[\]]+|\[\d+\]", path)]
    for key in keys[:-1]:
        summary = summary[key]
    summary[keys[-1]] = value


def self_test(folder):
    """Fields whose change by 0.1 % is not noticed."""
    whole = Result(folder)
    missed, count = [], 0
    for path, stated in list(leaves(whole.summary)):
        if TEXTS.match(path) or RECORDS.search(path):
            continue
        summary = copy.deepcopy(whole.summary)
        put(summary, path, changed(number(stated)))
        count += 1
        try:
            faults = judge(Result(folder, summary), path)[1]
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
