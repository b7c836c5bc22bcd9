"""Result folder: the values in its files, and the quantities of its law, cam and drive over the cycle."""

import copy
import csv
import functools
import json
import math
import re
from pathlib import Path

import numpy as np

import law as laws
import recorded
from cam import Cam
from force import Drive, model, sines
from materials import contact_modulus
from machine import Floor, Motion, Motor
from units import quantity

# (pattern of a field, function of (result, match) that returns recomputed value, relative and absolute tolerance)
FIELDS = []


def field(pattern):
    """Registers the recomputation of all fields that match a pattern."""
    def register(function):
        FIELDS.append((re.compile(pattern + "$"), function))
        return function
    return register


def close(own, relative=1e-6, absolute=1e-12):
    return own, relative, absolute


# Cache of costly parts, for the fields of one result and for its copies with another number in a field.
KEPT = {}


class Unknown(Exception):
    """A field without a recomputation."""


@functools.cache
def read_rows(path):
    with open(path, newline="") as file:
        rows = list(csv.reader(file))
    columns = {name: np.array([float(row[i]) if row[i] else math.nan for row in rows[1:]]) for i, name in enumerate(rows[0])}
    return rows[0], columns


class Result:
    """Result folder with the law, cam and drive of its summary."""

    def __init__(self, folder, summary=None, simulation=None):
        self.folder = Path(folder)
        self.summary = summary or json.loads((self.folder / "summary.json").read_text())
        self.scene = self.summary["scene"]
        for section in ("gait", "drive", "law", "cam", "limits"):
            self.scene.setdefault(section, {})
        self.is_built = "law" in self.summary
        run = self.folder / "simulation.json"
        self.simulation = simulation or (json.loads(run.read_text()) if run.exists() else None)
        if not self.is_built:
            return
        names, self.rows = read_rows(self.folder / "law.csv")
        self.theta = self.rows[names[0]]
        self.columns = names
        if self.simulation:
            self.run_columns = read_rows(self.folder / "dynamics.csv")[1]
            self.run_theta = self.run_columns["theta_rad"]
        self.profile = read_rows(self.folder / "profile.csv")[1]
        self.law = self.stated_law()
        self.cam = Cam(self.summary["cam"]["follower"], self.law, self.sizes(self.summary["cam"]))
        drive = self.summary["drive"]
        lever = quantity(self.scene["drive"].get("lever")) or abs(self.cam.size["arm"] or self.cam.size["pivot"] or 1.0)
        is_arm = "oscillating" in self.cam.kind
        self.drive = Drive(self.scene, drive["mass_kg"], drive["speed_rad_per_s"], lever if is_arm else 1.0)
        self.friction = 0.0
        self.is_recorded = "file" in self.scene["gait"]
        self.target = self.rows["target_n"] if np.isfinite(self.rows["target_n"]).all() else None
        self.machine = self.scene.get("machine", {})
        self.motion = self.run = None
        design = self.summary.get("shaft_design")
        if "floor" in self.machine or "motor" in self.machine:
            self.on_machine(design is not None and design["rounds"] > 0)

    def kept(self, name, value):
        """Value that depends only on law, cam, drive and scene."""
        stated = self.summary
        key = (str(self.folder), name, json.dumps([self.scene, stated["law"], stated["cam"], stated["drive"]], sort_keys=True))
        if key not in KEPT:
            KEPT[key] = value()
        return KEPT[key]

    def motor(self, **parts):
        return Motor(self.scene, self.folder, **parts) if "motor" in self.machine else None

    def on_machine(self, varies):
        """Motion of shaft and floor with the cam. The design is checked in this motion if the law was designed for it."""
        floor = Floor(self.scene) if "floor" in self.machine else None
        if floor and floor.is_drawn:
            raise Unknown("walkers with drawn phases")
        friction = quantity(self.machine.get("friction", 0.0)) or 0.0
        self.lever = lambda *motion: self.cam.lever(*motion, friction)
        plain = copy.copy(self.drive)
        motor = self.motor() if "shaft" in self.summary or (self.simulation or {}).get("shaft") else None
        self.is_timed = False
        wanted = self.target_at if self.target is not None and floor else None
        own = model_of(self)
        if motor is None:
            self.motion = self.drive.motion = self.kept("motion", lambda: Motion(self.law, plain, None, floor, self.lever, own or wanted))
            return
        self.motion = self.kept("motion", lambda: Motion(self.law, plain, motor, floor, self.lever, own))
        self.is_timed = varies
        if varies:
            self.drive.motion = self.motion

    def target_at(self, phase):
        """Target at fractions of the period, from the rows, by cubics through four neighbours."""
        own = self.motion.phase(self.theta) if self.motion is not None and self.is_timed else self.theta
        turn = self.law.end - self.law.start
        x = np.concatenate([own - turn, own, own + turn])
        y = np.tile(self.target, 3)
        phase = self.law.start + np.mod(phase - self.law.start, turn)
        i = np.clip(np.searchsorted(x, phase, side="right") - 1, 1, len(x) - 3)
        total = np.zeros(np.shape(phase))
        for j in range(-1, 3):
            term = y[i + j]
            for k in range(-1, 3):
                if k != j:
                    term = term * (phase - x[i + k]) / (x[i + j] - x[i + k])
            total += term
        return total

    def stated_law(self):
        law = self.summary["law"]
        functions, coefficients = law["functions"], law["coefficients"]
        if functions == "fourier":
            return laws.fourier(coefficients)
        if functions == "segments":
            return laws.programme(self.segments())
        if functions == "double-harmonic":
            return laws.double_harmonic(*coefficients)
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
        force = self.drive.force(theta, s, v, a)
        if not self.friction:
            return force * v
        pressed, pulled = self.cam.lever(theta, s, v, a, self.friction)
        return force * np.where(force < 0, pulled, pressed)

    def running(self):
        """The result with its cam on the machine in motion."""
        run = copy.copy(self)
        run.drive = copy.copy(self.drive)
        run.drive.motion = self.motion
        run.friction = quantity(self.machine.get("friction", 0.0)) or 0.0
        return run

    def time_mean(self, value):
        """Mean over time for the varying speed of the shaft, or over the angle at constant speed."""
        if self.motion is None or self.motion.shaft is None:
            return self.law.mean(value)
        shaft = self.motion.shaft
        return self.law.mean(lambda theta, *x: value(theta, *x) / shaft.speed(theta)) * shaft.mean

    def speed(self, theta):
        return np.full(np.shape(theta), self.drive.speed) if self.drive.motion is None else self.drive.motion.speed(theta)

    def hertz(self, theta, s, v, a, j=None):
        size = self.cam.size
        normal = self.drive.force(theta, s, v, a) / (size["arm"] if "oscillating" in self.cam.kind else 1.0)
        if self.friction and "roller" not in self.cam.kind and self.cam.kind.endswith("-translating"):
            normal = normal / self.cam.normal_share(theta, s, v, a, self.friction)
        else:
            normal = normal * self.cam.normal_force_factor(theta, s, v, a)
        length = quantity(self.scene["cam"].get("thickness", 0.010))
        curvature = self.cam.curvature_sum(theta, s, v, a)
        return np.sqrt(np.maximum(normal * curvature, 0.0) * contact_modulus(self.scene) / (math.pi * length))


def place(r, value, stated, worst):
    """Stated position of the worst value of the quantity."""
    if stated is None:
        return None, 0, 0
    nearest = math.inf
    for start, end, function in r.law.pieces:
        if start - 1e-9 <= stated <= end + 1e-9:
            # Neighbouring angles are included: a supremum over the rise or the fall is where the follower reverses.
            for beside in (0.0, -1e-6, 1e-6):
                theta = np.array([min(max(stated + beside, start), end)])
                found = float(np.ravel(value(theta, *(function(theta, k) for k in range(4))))[0])
                nearest = min(nearest, 0.0 if found == worst else abs(found - worst))
    allowed = 3e-8 * max(abs(worst), 1e-3 * size_of(r))
    if nearest > allowed:  # a worst value of 0 is one of rounding
        peak = r.law.extreme(lambda *x: np.abs(value(*x)))[0]
        allowed = 1e-14 * peak if abs(worst) < 1e-12 * peak < math.inf else allowed
    return (stated if nearest <= allowed else math.nan), 0, 1e-12


def size_of(r):
    return max(r.cam.size["prime"], r.cam.size["base"])


def presses(r):
    d = r.drive
    return bool(d.rest or d.stiffness or d.damping or d.inertia)


def model_of(r):
    """Target of the load model, load factors or critical points of the scene over the phase of the cycle; `None` for a recording."""
    gait = r.scene.get("gait", {})
    frequency, weight = quantity(gait.get("step_frequency")), quantity(gait.get("body_weight", 700.0)) or 700.0
    parts = str(gait.get("step_frequency")).split(":")
    if len(parts) == 3:  # of several walkers that in the middle
        frequency = (quantity(parts[0]) + quantity(parts[1])) / 2
    shift = quantity(gait.get("phase", 0.0)) or 0.0
    if gait.get("phase") == "free":
        shift = r.summary["law"]["phase_rad"]
    if "harmonics" in gait:
        factors = own_factors(gait["harmonics"])
        plain = lambda phase: weight * sines(factors, phase)
    elif "model" in gait and frequency and model(gait["model"], frequency, weight, np.zeros(1), gait.get("feet", "both")) is not None:
        plain = lambda phase: model(gait["model"], frequency, weight, phase, gait.get("feet", "both"))
    else:
        return recorded.curve(r)
    size, level = 1.0, 0.0
    if gait.get("scale", "none") != "none" and r.drive.kind == "moving-axis":
        mean = float(np.mean(plain(2 * math.pi * np.arange(2880) / 2880)))
        rest = r.drive.mass * r.drive.gravity
        size, level = (rest / mean, 0.0) if gait["scale"] == "to-mass" else (1.0, rest - mean)
    return lambda phase: size * plain(phase + shift) + level


def own_factors(rows):
    """Amplitude and added phase of each harmonic, from texts such as `0.1 at -90 deg`."""
    parts = [str(row).partition(" at ") for row in (rows if isinstance(rows, list) else [rows])]
    return [(quantity(size.strip()), quantity(shift.strip() or 0.0)) for size, _, shift in parts]
