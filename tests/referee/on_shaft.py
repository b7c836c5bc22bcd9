"""Recomputation of the motion of shaft and floor, and of the results for other machines."""

import copy
import math

import numpy as np

import law as laws
from force import Drive
from machine import TURN, Motion
from optimum import Program
from result import Unknown, close, field, model_of
from units import quantity

# Accuracy of the speed between the breaks of a law with the steps of the program.
SPEED = 5e-5
# The motion repeats to 1e-6 of its energy from turn to turn, and to half of this of the speed.
SETTLED = 5e-7
CLASSES = (0.5, 1.0, 2.5)


def motion_of(r):
    if r.motion is None or r.motion.shaft is None:
        raise Unknown("no motor")
    return r.motion


@field(r"(simulation\.)?shaft\.(.*)")
def shaft(r, m):
    motion, name = motion_of(r), m[2]
    own, motor = motion.shaft, motion.shaft.motor
    speed = lambda theta, *_: own.speed(theta)
    torque = lambda theta, *_: motor.torque(own.speed(theta), own.no_load)
    if name == "inertia_kg_m2":
        return close(motor.inertia, 1e-12)
    if name == "mean_rad_per_s":
        return close(TURN / own.time[-1], 1e-9)
    if name == "no_load_speed_rad_per_s":
        return close(own.no_load, SPEED)
    low, high = r.law.extreme(speed, False)[0], r.law.extreme(speed)[0]
    if name in ("min_rad_per_s", "max_rad_per_s"):
        return close(low if name.startswith("min") else high, SPEED)
    if name == "ripple":
        return close((high - low) / own.mean, 2e-4, SETTLED)
    if name == "energy_balance":
        if not r.force(r.theta, *(r.law(r.theta, k) for k in range(3))).any():
            raise Unknown("a balance of no work, which is rounding over rounding")
        return close(0.0, 0.0, 1e-6)
    if name == "stops_at_rad":
        stop = own.stop_from_rest(r.law.extreme(lambda *x: x[1], False)[1])
        return (None, 0, 0) if stop is None else close(stop, 5e-4, 5e-4)
    if name == "least_inertia_kg_m2":
        # The search of the program ends within a few per cent, and at 1e-4 of the given inertia.
        least, end = least_inertia(r), 1e-4 * own.motor.inertia
        return (least, 0.04, 0.0) if least > end else (0.0, 0.0, 1.01 * end)
    if name == "motor_torque_max_n_m":
        share = abs(motor.torque(high * (1 + SETTLED), own.no_load) - motor.torque(high, own.no_load))
        return close(max(abs(motor.torque(w, own.no_load)) for w in (low, high)) / (motor.gear * motor.efficiency), 2e-4, share / (motor.gear * motor.efficiency))
    if name == "motor_torque_rms_n_m":
        return close(math.sqrt(r.time_mean(lambda *x: torque(*x) ** 2)) / (motor.gear * motor.efficiency), 2e-4)
    if name == "motor_power_mean_w":
        swing = own.motor.inertia * (high**2 - low**2) / 2 / own.time[-1]
        return close(r.time_mean(lambda *x: torque(*x) * speed(*x)) / motor.efficiency, 1e-4, max(1e-5 * swing, 1e-9))
    raise Unknown(name)


def least_inertia(r):
    """Smallest inertia for which a turn repeats; 0 if it repeats for any inertia.

    The duration of a turn falls from ∞ to 0 as the no-load speed increases. A turn with the mean speed therefore exists unless
    the shaft jams: the inertia at the shaft, J + τ m v, must be positive. Without friction τ = v, and this holds.
    """
    seen = r.law.extreme(lambda theta, s, v, a, j: r.drive.inertia * v * r.lever(theta, s, v, a)[0], False)[0]
    return max(-seen, 0.0)


def error_over_time(r, motion, law=None):
    """RMS force error over time for a motion, and the mean of the target."""
    law = law or r.law
    drive = copy.copy(motion.drive)
    drive.motion = motion
    force = lambda theta: drive.force(theta, *(law(theta, k) for k in range(3))) / drive.lever
    return motion.error_in_time(force, model_of(r) or r.target_at)


@field(r"(simulation\.)?force_time")
def no_force_time(r, m):
    return (None if r.target is None else math.nan), 0, 0


@field(r"(simulation\.)?force_time\.(rms_error_n|rms_error_percent_of_mean)")
def force_time(r, m):
    if r.target is None:
        return None, 0, 0
    rms, mean = r.kept("error", lambda: error_over_time(r, motion_of(r)))
    return close(rms if m[2] == "rms_error_n" else 100 * rms / mean, 5e-4, 1e-6 * mean if m[2] == "rms_error_n" else 1e-4)


@field(r"shaft_design\.at_constant_speed")
def no_error_at_constant_speed(r, m):
    return (None if r.target is None else math.nan), 0, 0


@field(r"shaft_design\.sensitivity\[(\d+)\]\.(.*)")
def sensitivity(r, m):
    key = r.summary["shaft_design"]["sensitivity"][int(m[1])]["key"]
    part = {"machine.inertia": "inertia", "machine.motor": "torque", "machine.friction_torque": "friction"}[key]
    if m[2] == "key":
        return ["machine.inertia", "machine.motor", "machine.friction_torque"][int(m[1])], 0, 0
    less_or_more = 1.1 if m[2].endswith("[1]") else 0.9
    if r.target is None:
        return None, 0, 0
    before = motion_of(r)

    def error():
        own = before.shaft
        motion = Motion(r.law, before.drive, r.motor(**{part: less_or_more}), before.floor, r.lever, model_of(r), (own.energy[0], own.no_load))
        rms, mean = error_over_time(r, motion)
        return 100 * rms / mean

    try:
        return close(r.kept(f"{part}{less_or_more}", error), 5e-4, 2e-4)
    except ArithmeticError:
        return None, 0, 0


def at_constant_speed(r):
    """Laws for constant speed: the design itself if no iteration corrected it, else those with the smallest numbers of spans
    or harmonics that reach the accuracy, and with some more."""
    if r.summary["shaft_design"]["rounds"] == 0:
        return [r.law]
    if binding(r):
        raise Unknown("law for constant speed under active limits")
    law = r.summary["law"]
    target, drive = model_of(r) or r.target_at, copy.copy(r.drive)
    drive.motion = None
    spans = r.scene["law"].get("spans", r.scene["law"].get("harmonics", "auto"))
    phase = TURN * np.arange(2880) / 2880
    wanted = target(phase) * drive.lever
    allowed = share_of(r) * float(np.mean(wanted))
    found = []
    if law["functions"] == "fourier":
        c = np.fft.rfft(wanted) / len(wanted)
        gain = lambda n: drive.stiffness + 1j * drive.damping * n * drive.speed - drive.inertia * (n * drive.speed) ** 2
        level = (c[0].real - drive.rest) / drive.stiffness if drive.stiffness else 0.0
        for count in range(1, 64) if spans == "auto" else [int(spans)]:
            left = math.sqrt(2 * np.sum(np.abs(c[count + 1 :]) ** 2))
            if spans != "auto" or left <= allowed:
                n = np.arange(1, count + 1)
                own = 2 * c[1 : count + 1] / gain(n)
                found.append(laws.fourier([level, *np.stack([own.real, -own.imag], axis=1).ravel()]))
        return [on_base_circle(own, drive) for own in found]
    degree = law["degree"]
    for count in range(degree + 1, law["pieces"] + 1) if spans == "auto" else [int(spans)]:
        knots = TURN * np.arange(count) / count
        law_of = lambda c, knots=knots: laws.spline(knots, degree, c)
        program = Program(law_of, count, drive, (phase, wanted))
        c = np.linalg.lstsq(program.objective[0], program.objective[1], rcond=1e-11)[0]
        if spans != "auto" or math.sqrt(program.value(c)) <= allowed:
            found.append(on_base_circle(law_of(c), drive))
    return found


def on_base_circle(law, drive):
    """Law with its lowest point at lift 0 if the force does not determine the level. Friction depends on it."""
    if drive.stiffness:
        return law
    lowest = law.extreme(lambda *x: x[1], False)[0]
    return laws.Law([(a, b, lambda x, k, f=f: f(x, k) - (lowest if k == 0 else 0.0)) for a, b, f in law.pieces])


def share_of(r):
    """Accuracy relative to the mean force."""
    own = quantity(r.scene.get("accuracy", {}).get("rms", "auto"))
    return 0.005 if own is None else own


@field(r"shaft_design\.(at_constant_speed|forecast)\.(.*)")
def forecast(r, m):
    before = motion_of(r)
    is_limited = r.target is not None and r.scene.get("accuracy", {}).get("rms") != "none"
    neglected = 20 * share_of(r) if is_limited else 0.1
    if m[2] == "neglected_percent_of_mean":
        return close(neglected, 1e-3)
    stated = r.summary["shaft_design"][m[1]][m[2]]
    if m[2] == "is_negligible":
        own = r.summary["shaft_design"]
        change = own["forecast"]["force_change_percent_of_mean"]
        change = math.inf if change is None else change
        misses = is_limited and own["at_constant_speed"]["rms_error_percent_of_mean"] > 5 * neglected
        return bool(change <= neglected and not misses and not held(r)), 0, 0
    if r.target is None and m[1] == "at_constant_speed":
        return None, 0, 0
    best = math.nan
    for i, law in enumerate(r.kept("constant", lambda: at_constant_speed(r))[:8]):
        own = r.kept(f"{m[1]}{m[2]}{i}", lambda law=law: figure_of(law, before, r, m))
        if own is None or stated is None:
            return (None if own is None or math.isnan(own) else own), 0, 0
        if not abs(own - stated) > abs(best - stated):
            best = own
        if abs(own - stated) <= (2e-3 if m[1] == "forecast" else 5e-4) * abs(own):
            break
    return close(best, 2e-3 if m[1] == "forecast" else 5e-4, 1e-9)


def figure_of(law, before, r, m):
    if m[1] == "at_constant_speed":
        try:
            motion = Motion(law, before.drive, r.motor(), before.floor, r.lever, model_of(r))
        except ArithmeticError:
            return None
        rms, mean = error_over_time(r, motion, law)
        return rms if m[2] == "rms_error_n" else 100 * rms / mean
    ripple, change = linear(law, before, r)
    return ripple if m[2] == "ripple" else 100 * change


def held(r):
    """Whether a quantity other than the force error depends on the speed of the shaft."""
    still = ("stroke", "curvature", "pressure_angle", "pressure_angle_rise", "pressure_angle_fall", "prime_radius", "diameter", "face_width")
    limits = [name for name, value in r.scene["limits"].items() if name not in still and value != "none"]
    usual = "force-error" if r.target is not None else "jerk"
    return bool(limits or "band" in r.scene["gait"] or r.scene["law"].get("minimise", usual) != "force-error")


def binding(r):
    return r.summary["binding"] or "infeasible" in r.summary


def linear(law, before, r):
    """Ripple, and first-order change of the force about a constant speed: ε′ = r + r_E ε + r_ω δω with a constant period."""
    drive, motor = before.drive, r.motor()
    level = 0.5 * drive.speed**2
    theta = law.start + TURN * (np.arange(2880) + 0.5) / 2880
    s, v, a = (law(theta, k) for k in range(3))
    arm = r.lever(theta, s, v, a)[0]
    still = drive.rest + drive.stiffness * s + drive.damping * drive.speed * v + drive.inertia * drive.speed**2 * a
    no_load = motor.no_load_for(drive.speed, float(np.mean(arm * still)) + motor.friction)
    h = TURN / len(theta)

    def rates(energy, supply):
        w = math.sqrt(2 * energy)
        force = drive.rest + drive.stiffness * s + drive.damping * w * v + 2 * drive.inertia * energy * a
        return (motor.torque(w, supply) - motor.friction - arm * force) / (motor.inertia + arm * drive.inertia * v)

    base = rates(level, no_load)
    by_energy = (rates(level * 1.0001, no_load) - rates(level * 0.9999, no_load)) / (2e-4 * level)
    by_supply = (rates(level, no_load * 1.0001) - rates(level, no_load * 0.9999)) / (2e-4 * no_load)
    # The midpoint rule of each step is affine in (ε(0), δω).
    row, rows = np.array([0.0, 1.0, 0.0]), []
    for b, e, w in zip(base, by_energy, by_supply):
        after = (row * (1 + h / 2 * e) + h * np.array([b, 0.0, w])) / (1 - h / 2 * e)
        rows.append((row + after) / 2)
        row = after
    rows = np.array(rows)
    mean = rows.mean(axis=0)
    first, supply = np.linalg.solve([[row[1] - 1, row[2]], [mean[1], mean[2]]], [-row[0], -mean[0]])
    change = rows @ np.array([1.0, first, supply])
    slope = base + by_energy * change + by_supply * supply
    force = (drive.damping * v / drive.speed + 2 * drive.inertia * a) * change + drive.inertia * v * slope
    # The time of each angle changes; the phase is that of the smallest change.
    slope = drive.stiffness * v + drive.damping * drive.speed * a + drive.inertia * drive.speed**2 * law(theta, 3)
    ahead = (np.cumsum(change) - change / 2) * h / (2 * level)
    force = force + slope * ahead
    force = force - slope * np.dot(slope, force) / (np.dot(slope, slope) or 1.0)
    return (change.max() - change.min()) / (2 * level), math.sqrt(float(np.mean(force**2))) / (abs(float(np.mean(still))) or math.nan)


@field(r"(simulation\.)?floor\.(.*)")
def floor(r, m):
    peak, rms = r.motion.floor_figures()
    if m[2].startswith("comfort"):
        rank = sum(peak > bound for bound in CLASSES)
        return (("maximum", "mean", "minimum", "unacceptable") if m[2].endswith("setra") else ("CL1", "CL2", "CL3", "CL4"))[rank], 0, 0
    return close(peak if "peak" in m[2] else rms, 2e-5)


def inertia(r, row, side):
    """Smallest inertia for which the law reaches the accuracy over time."""
    own = motion_of(r).shaft.motor.inertia
    if side == "from":
        return close(own, 1e-12)
    share = share_of(r)

    def error(part):
        motion = Motion(r.law, r.motion.drive, r.motor(inertia=part), r.motion.floor, r.lever, model_of(r))
        rms, mean = error_over_time(r, motion)
        return rms / mean

    part = row["to"] / own
    is_least = r.kept(f"inertia{part}", lambda: error(part) <= share * (1 + 2e-4) and error(0.97 * part) > share)
    return (row["to"] if is_least else math.nan), 1e-12, 0
