"""Recomputation of law, cam, force and machine."""

import copy
import math

import numpy as np

from cam import Cam
from force import harmonics
from materials import allowable
from on_shaft import error_over_time
from result import Unknown, close, field, model_of, place, presses, size_of
from units import quantity

# Models of a single stance, with kinks where the foot strikes and leaves the ground.
STANCES = ("li-2010", "iso-22675")


@field(r"law\.(stroke|v_max|v_min|a_max|a_min|j_max|j_min)_.*")
def extreme_of_law(r, m):
    name = m[1]
    if name == "stroke":
        return close(r.law.extreme(lambda *x: x[1])[0] - r.law.extreme(lambda *x: x[1], False)[0])
    order = "svaj".index(name[0])
    sign = 1.0 if name.endswith("max") else -1.0
    for below in range(order):
        least = 1e-7 * max(r.law.jumps(below)[1], 1e-12)
        steps = r.law.steps(below)
        # At a step the first derivative is infinite on its own side, and the second on both sides.
        if any(abs(step) > least if below + 1 < order else sign * step > least for step in steps):
            return sign * math.inf, 0.0, 0.0
    return close(r.law.extreme(lambda *x: x[1 + order], name.endswith("max"))[0], 1e-6, 1e-9 * max(1e-6, r.law.jumps(order)[1]))


@field(r"continuity\.([svaj])")
def continuity(r, m):
    order = "svaj".index(m[1])
    jump, size = r.law.jumps(order)
    return bool(jump <= 1e-7 * max(size, 1e-12)), 0, 0


@field(r"law\.coefficients\[(\d+)\]")
def coefficient(r, m):
    """Checks that the law of all stated coefficients has the rows of law.csv. All coefficients are then correct."""
    i = int(m[1])
    stated = r.summary["law"]["coefficients"]
    if r.summary["law"]["functions"] == "segments":
        return close(r.segments()[i][1], 1e-9)
    sizes = [max(float(np.max(np.abs(r.rows[r.columns[k + 1]]))), 1e-15) for k in range(3)]
    worst = max(float(np.max(np.abs(r.law(r.theta, k) - r.rows[r.columns[k + 1]]))) / sizes[k] for k in range(3))
    return (stated[i] if worst < 1e-9 else math.nan), 1e-12, 1e-12


@field(r"law\.functions\.b-spline\.knots_rad\[(\d+)\]")
def knot(r, m):
    return coefficient_like(r, r.summary["law"]["functions"]["b-spline"]["knots_rad"][int(m[1])])


@field(r"law\.functions\.monomial\.range_rad\[(\d+)\]")
def monomial_range(r, m):
    return coefficient_like(r, r.summary["law"]["functions"]["monomial"]["range_rad"][int(m[1])])


def coefficient_like(r, stated):
    sizes = [max(float(np.max(np.abs(r.rows[r.columns[k + 1]]))), 1e-15) for k in range(3)]
    worst = max(float(np.max(np.abs(r.law(r.theta, k) - r.rows[r.columns[k + 1]]))) / sizes[k] for k in range(3))
    return (stated if worst < 1e-9 else math.nan), 1e-12, 1e-12


@field(r"law\.functions")
def functions(r, m):
    return r.summary["law"]["functions"], 0, 0


@field(r"law\.degree")
def degree(r, m):
    """Degree of the pieces, whose next derivative vanishes; 0 for functions that are not polynomials."""
    kind = r.summary["law"]["functions"]
    if kind == "segments":
        degrees = {"3-4-5": 5, "4-5-6-7": 7, "5-6-7-8-9": 9, "berzak-d": 7, "parabolic": 2, "cubic": 3, "constant-velocity": 1}
        used = [degrees.get(name, 0) for name, lift, _ in r.segments() if name != "dwell"]
        return (max(used) if used and all(used) else 0), 0, 0
    if kind in ("fourier", "double-harmonic"):
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
    phase, stated = r.scene.get("gait", {}).get("phase", 0.0), r.summary["law"]["phase_rad"]
    if phase == "free":  # chosen by the design; the target of the rows is the one at this phase
        return (stated if 0.0 <= stated < 2 * math.pi else math.nan), 0, 0
    return close(quantity(phase) or 0.0, 1e-9)


@field(r"law\.family|cam\.follower|drive\.kind")
def named(r, m):
    section, key = m[0].split(".")
    default = {"family": None, "follower": "flat-translating", "kind": None}[key]
    stated = r.scene[section].get(key, default)
    kind = r.summary["law"]["functions"]
    by_functions = {"fourier": "harmonic", "segments": "program", "double-harmonic": "double-harmonic"}.get(kind) if isinstance(kind, str) else ("polynomial" if "monomial" in kind else "spline")
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
        return close(mean_target(r) / r.drive.gravity, 1e-5)
    return close(0.0)


@field(r"drive\.speed_rad_per_s")
def speed(r, m):
    value = quantity(r.scene["drive"].get("speed", "auto"))
    if value is not None:
        return close(value, 1e-12)
    gait = r.scene.get("gait", {})
    if quantity(gait.get("step_frequency")):  # one turn for a step, or for the stride of one foot
        turn = 2 * math.pi if gait.get("feet", "both") == "both" else math.pi
        return close(turn * quantity(gait["step_frequency"]), 1e-12)
    parts = str(gait.get("step_frequency")).split(":")
    if len(parts) == 3:
        return close(math.pi * (quantity(parts[0]) + quantity(parts[1])), 1e-12)
    raise Unknown("automatic speed of a recording")


@field(r"cam\.(prime_radius|base_radius|offset)_m")
def size(r, m):
    """Size of the cam: the profile points agree with it, and it equals the size in the scene, if given."""
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


def distance(r):
    """Distance of the point of contact from the centre of the shaft."""
    return lambda theta, s, v, a, j=None: np.hypot(*r.cam.at(theta, s, v, a)[0])


@field(r"cam\.radius_(min|max)_m")
def radius_of_profile(r, m):
    if r.cam.kind in ("translating-cam", "barrel"):
        return None, 0, 0
    if rho_min(r, None)[0] < 0 and not r.cam.is_face:
        raise Unknown("radius of an undercut profile")
    return close(r.law.extreme(distance(r), m[1] == "max")[0], 1e-7)


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
        roller = Second(r).cam.roller
        base = quantity(r.scene["cam"]["conjugate"].get("base_radius"))
        if base is None:
            raise Unknown("conjugate pair by angle")
        return close(base if m[1].startswith("base") else base + roller, 1e-9)
    depth = math.sqrt(r.cam.size["prime"] ** 2 - r.cam.size["offset"] ** 2) if not r.cam.is_face else r.cam.size["base"]
    prime = distance - depth - r.law.extreme(lambda *x: x[1])[0]
    roller = quantity(r.scene["cam"]["conjugate"].get("roller_radius")) or r.cam.size["roller"]
    return close(prime - (roller if m[1].startswith("base") else 0.0), 1e-9)


class Second:
    """Cam of the opposite follower. Its lift is the distance of the first one from its highest point."""

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


@field(r"force")
def no_force(r, m):
    return (None if not presses(r) else math.nan), 0, 0


@field(r"force\.(.*)")
def force(r, m):
    name = m[1]
    if name in ("mean_n", "min_n", "max_n"):
        if name == "mean_n":
            return close(r.time_mean(r.force) if varies(r) else r.law.mean(r.force), 2e-5 if varies(r) else 1e-7)
        return close(r.law.extreme(r.force, name == "max_n")[0], 2e-4 if varies(r) else 3e-6 if r.motion or r.drive.learned else 1e-7, 1e-9)
    if r.target is None:
        return None, 0, 0
    error = r.force(r.theta, *(r.law(r.theta, k) for k in range(3))) - r.target
    mean = mean_target(r)
    has_motor = r.motion is not None and r.motion.shaft is not None
    rms = r.kept("error", lambda: error_over_time(r, r.motion))[0] if has_motor else math.sqrt(float(np.mean(error**2)))
    rounding = (1e-6 if has_motor else 1e-10) * mean
    if name == "target_mean_n":
        return close(mean, 2e-4)
    if name == "rms_error_n":
        return close(rms, 4e-4, rounding)
    if name == "rms_error_percent_of_mean":
        return close(100 * rms / mean, 4e-4, 100 * rounding / mean)
    if name == "max_error_n":
        # Near the kinks of a stance, the program uses a cubic between 1024 samples.
        kinks = 1e-3 * float(np.max(r.target)) if r.scene["gait"].get("model") in STANCES else 0.0
        return close(peak_between_rows(np.abs(error)), 4e-4, max(rounding, kinks, moved(r) * mean))
    raise Unknown(name)


def varies(r):
    """Whether the design is checked at a varying speed."""
    return r.drive.motion is not None and r.drive.motion.shaft is not None


def mean_target(r):
    if not varies(r):
        return float(np.mean(r.target))
    time = np.diff(r.motion.phase(np.append(r.theta, r.theta[0] + 2 * math.pi))) / (2 * math.pi)
    return float(np.sum((r.target + np.roll(r.target, -1)) / 2 * time))


def peak_between_rows(values):
    """Maximum of a parabola through the highest row and its neighbours."""
    i = int(np.argmax(values))
    a, b, c = values[i - 1], values[i], values[(i + 1) % len(values)]
    bend = a - 2 * b + c
    return float(b if bend >= 0 else b - (c - a) ** 2 / (8 * bend))


@field(r"machine\.(.*)")
def machine(r, m):
    name = m[1]
    if name == "hertz_pressure_allowable_pa":
        return (None, 0, 0) if allowable(r.scene) is None else close(allowable(r.scene), 1e-9)
    if not presses(r):
        return None, 0, 0
    exact = 2e-4 if varies(r) else 3e-6 if r.motion or r.drive.learned else 1e-7
    power = lambda *x: r.torque(*x) * r.speed(x[0])
    if name == "torque_max_n_m":
        return close(r.law.extreme(lambda *x: np.abs(r.torque(*x)))[0], exact)
    if name == "torque_rms_n_m":
        return close(math.sqrt(r.law.mean(lambda *x: r.torque(*x) ** 2)), exact)
    if name == "power_max_w":
        return close(r.law.extreme(lambda *x: np.abs(power(*x)))[0], exact)
    if name == "power_mean_w":
        mean = r.time_mean(power) if varies(r) else r.law.mean(power)
        return close(mean, 1e-6, (1e-5 if varies(r) else 1e-7 if r.motion else 1e-9) * r.law.extreme(lambda *x: np.abs(power(*x)))[0])
    if name == "liftoff_speed_rad_per_s":
        # A conjugate pair has contact on both sides.
        if r.drive.motion is not None or r.drive.learned or "conjugate" in r.scene["cam"]:
            return None, 0, 0
        return close(r.drive.liftoff(r.law), 1e-7) if r.drive.liftoff(r.law) is not None else (None, 0, 0)
    if name == "hertz_pressure_max_pa":
        if r.cam.kind.startswith("knife"):
            return math.inf, 0, 0
        if rho_min(r, None)[0] <= 1e-9 * size_of(r):
            return None, 0, 0
        return close(r.law.extreme(r.hertz)[0], max(exact, 1e-6))
    raise Unknown(name)


def moved(r):
    """Accuracy of the force in a design relative to the mean force. Its law is that of the last motion but one (theory §10)."""
    return 2e-6 if varies(r) else 1e-8


def weight_of(r):
    """Weight of the walker in the target: that of a load model, scaled with it; for a recording the mean force."""
    gait = r.scene.get("gait", {})
    if gait.get("model") in STANCES:
        if gait.get("scale") == "to-mass" and r.drive.kind == "moving-axis":
            raise Unknown("the mean of a model of one foot")
        return quantity(gait.get("body_weight", 700.0)) or 700.0
    if r.is_recorded or model_of(r) is None:
        return mean_target(r)
    weight = quantity(gait.get("body_weight", 700.0)) or 700.0
    if gait.get("scale") == "to-mass" and r.drive.kind == "moving-axis":
        unscaled = copy.copy(r)
        unscaled.scene = dict(r.scene, gait={key: value for key, value in gait.items() if key != "scale"})
        angles = 2 * math.pi * np.arange(2880) / 2880
        return weight * float(np.mean(model_of(r)(angles)) / np.mean(model_of(unscaled)(angles)))
    return weight


@field(r"load_factors\[(\d+)\]\.(.*)")
def load_factor(r, m):
    row = r.summary["load_factors"][int(m[1])]
    gait = r.scene.get("gait", {})
    steps = 2 if gait.get("model") in STANCES and gait.get("feet") in ("one", "left", "right") else 1
    n = int(m[1]) + 1
    if m[2] == "harmonic":
        return n, 0, 0
    if m[2] == "of_step":
        return close(n / steps, 1e-12)
    if m[2] == "frequency_hz":
        return close(n * r.drive.speed / (2 * math.pi), 1e-12)
    if m[2].startswith("target"):
        wanted = r.target if not varies(r) else (model_of(r) or r.target_at)(2 * math.pi * np.arange(1440) / 1440)
        amplitude, angle = harmonics(wanted, n)[n - 1]
    else:
        # Mean over time, at the speed for which the design states its force.
        turns = r.motion is not None and (r.motion.shaft is None or varies(r))
        run, mean, phase = (r.running(), r.time_mean, r.motion.phase) if turns else (r, r.law.mean, lambda x: x)
        cos = 2 * mean(lambda *x: run.force(*x) * np.cos(n * phase(x[0])))
        sin = 2 * mean(lambda *x: run.force(*x) * np.sin(n * phase(x[0])))
        amplitude, angle = math.hypot(cos, sin), math.atan2(cos, sin)
    # The terms are stated as A sin(nθ − φ).
    angle = -angle
    weight = weight_of(r)
    if not m[2].endswith("phase_rad"):
        return close(amplitude / weight, 2e-4, moved(r))
    stated = row[m[2]]
    if amplitude < 1e-9 * weight or stated == 0.0 and amplitude < 1e-8 * weight:
        return close(0.0)
    turns = round((stated - angle) / (2 * math.pi))
    return close(angle + 2 * math.pi * turns, 2e-4, max(3e-6 if r.motion else 1e-6, moved(r) * weight / amplitude if varies(r) else 0.0))
