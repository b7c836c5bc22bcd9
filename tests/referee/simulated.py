"""Recomputation of simulation.json and dynamics.csv: a rigid run with the motion of shaft and floor and with friction."""

import math

import numpy as np

from figures import mean_target
from materials import contact_modulus
from on_shaft import error_over_time
from result import Unknown, close, field
from units import quantity

# The run follows the profile, from which the motion is recovered to about 1e-7 of the acceleration.
RECOVERED = 5e-7


def rigid(r):
    if r.simulation["model"] != "rigid" or "learned_force" in r.machine:
        raise Unknown("a run that is not rigid")
    return r.running()


def accuracy(r):
    """If shaft or floor move, the extremes are those of the rows, and the steps of the shaft resolve its speed."""
    if r.motion is None and "friction" in r.machine:
        return 4e-6
    return RECOVERED if r.motion is None else 2e-4 if r.motion.shaft else 2e-5


@field(r"simulation\.(force|torque)\.(min|max|mean|rms|rms_error_n)")
def extreme_of_run(r, m):
    run = rigid(r)
    value = run.force if m[1] == "force" else run.torque
    size = abs(r.law.extreme(lambda *x: np.abs(value(*x)))[0])
    if m[2] in ("min", "max"):
        return close(r.law.extreme(value, m[2] == "max")[0], accuracy(r), 2e-2 * accuracy(r) * size)
    if m[2] == "mean":
        return close(r.law.mean(value), accuracy(r), 2e-2 * accuracy(r) * size)
    if m[2] == "rms":
        return close(math.sqrt(r.law.mean(lambda *x: value(*x) ** 2)), accuracy(r))
    if r.target is None:
        return None, 0, 0
    if r.motion is not None and r.motion.shaft is not None:
        return close(error_over_time(r, r.motion)[0], 5e-4, 1e-6 * mean_target(r))
    error = run.force(r.theta, *(r.law(r.theta, k) for k in range(3))) - r.target
    return close(math.sqrt(float(np.mean(error**2))), 4e-4)


@field(r"simulation\.details\.period_turns")
def period(r, m):
    rigid(r)
    return 1, 0, 0


@field(r"simulation\.liftoff_speed_rad_per_s")
def liftoff(r, m):
    own = r.drive.liftoff(r.law) if r.motion is None or r.motion.floor is None else None
    return close(own, RECOVERED) if own is not None else (None, 0, 0)


@field(r"simulation\.details\.hertz\.(at_rad|pressure_pa|half_width_m|shear_depth_m|shear_pa)")
def contact(r, m):
    """Line contact: p = √(F E*/(π L R)), b = 2 p R/E*, maximum shear stress 0.300 p at the depth 0.786 b."""
    run = rigid(r)
    stated = r.simulation["details"]["hertz"]
    at = np.array([stated["at_rad"]])
    motion = [r.law(at, k) for k in range(3)]
    pressure = float(run.hertz(at, *motion)[0])
    half_width = 2 * pressure / (contact_modulus(r.scene) * float(r.cam.curvature_sum(at, *motion)[0]))
    if m[1] == "at_rad" and r.motion is not None:
        # The value is that of a row.
        rows = run.hertz(r.run_theta, *(r.law(r.run_theta, k) for k in range(3)))
        near = int(np.argmin(np.abs(r.run_theta - stated["at_rad"])))
        return (r.run_theta[near] if rows[near] >= np.max(rows) * (1 - 1e-6) else math.nan), 0, 1e-9
    if m[1] == "at_rad":
        worst = r.law.extreme(run.hertz)[0]
        return (stated["at_rad"] if abs(pressure - worst) <= 3e-8 * worst else math.nan), 0, 1e-12
    return close({"pressure_pa": pressure, "half_width_m": half_width, "shear_depth_m": 0.786 * half_width, "shear_pa": 0.300 * pressure}[m[1]],
                 2e-4 if m[1].startswith("shear") else accuracy(r))


@field(r"simulation\.(contact_lost|lost_fraction|settle_cycles|speed_rad_per_s|model|verdict)")
def state(r, m):
    run = rigid(r)
    if m[1] == "speed_rad_per_s":
        return close(r.drive.speed, 1e-12)
    if m[1] == "model":
        return "rigid", 0, 0
    if m[1] == "verdict":
        return r.summary["verdict"], 0, 0
    lost = r.law.extreme(run.force, False)[0] < -1e-9 * abs(r.law.extreme(run.force)[0])
    share = 0.0 if not lost else r.law.mean(lambda *x: 1.0 * (run.force(*x) < 0))
    return {"contact_lost": bool(lost), "lost_fraction": share, "settle_cycles": 0}[m[1]], 0, 2e-3 if lost else 0


def columns(r):
    """Recomputed columns of dynamics.csv."""
    run = r.running()
    motion = [r.law(r.run_theta, k) for k in range(4)]
    force, torque = run.force(r.run_theta, *motion), run.torque(r.run_theta, *motion)
    angle = r.cam.at(r.run_theta, *motion[:3])[3]
    speed = run.speed(r.run_theta)
    shaft = r.motion.shaft if r.motion is not None else None
    own = {
        "contact_force_n": force, "torque_nm": torque, "power_w": torque * speed, "lift_m": motion[0], "gap_m": np.zeros_like(force),
        "time_s": (r.run_theta - r.law.start) / r.drive.speed if shaft is None else shaft.clock(r.run_theta), "speed_rad_per_s": speed,
    }
    if r.cam.kind == "flat-translating":
        own["normal_force_n"] = force
        own["side_thrust_n"] = run.friction * force
        # The contact point moves along the face with Rb + s on the cam, and with the acceleration of the contact offset on the face.
        own["sliding_m_per_s"] = speed * (r.cam.size["base"] + motion[0])
        own["entraining_m_per_s"] = own["sliding_m_per_s"] / 2 + speed * motion[2]
    elif r.cam.kind == "roller-translating":
        own["normal_force_n"] = force / np.cos(angle)
        own["side_thrust_n"] = force * np.tan(angle)
    return own
