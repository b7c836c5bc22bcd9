"""Recomputations of simulation.json and dynamics.csv: a rigid run at constant speed without friction."""

import math

import numpy as np

from force import CONTACT_MODULUS
from result import Unknown, close, field
from units import quantity

# The run follows the profile, whose motion is recovered to about 1e-7 of the acceleration.
RECOVERED = 5e-7


def is_plain(r):
    return r.simulation["model"] == "rigid" and "machine" not in r.scene


@field(r"simulation\.(force|torque)\.(min|max|mean|rms|rms_error_n)")
def extreme_of_run(r, m):
    if not is_plain(r):
        raise Unknown("a run that is not rigid at constant speed")
    value = r.force if m[1] == "force" else r.torque
    if m[2] in ("min", "max"):
        return close(r.law.extreme(value, m[2] == "max")[0], RECOVERED, 1e-8 * abs(r.law.extreme(value)[0]))
    if m[2] == "mean":
        return close(r.law.mean(value), RECOVERED, 1e-8 * abs(r.law.extreme(value)[0]))
    if m[2] == "rms":
        return close(math.sqrt(r.law.mean(lambda *x: value(*x) ** 2)), RECOVERED)
    if r.target is None:
        return None, 0, 0
    error = r.force(r.theta, *(r.law(r.theta, k) for k in range(3))) - r.target
    return close(math.sqrt(float(np.mean(error**2))), 4e-4)


@field(r"simulation\.details\.period_turns")
def period(r, m):
    if not is_plain(r):
        raise Unknown("a run that is not rigid at constant speed")
    return 1, 0, 0


@field(r"simulation\.liftoff_speed_rad_per_s")
def liftoff(r, m):
    own = r.drive.liftoff(r.law)
    return close(own, RECOVERED) if own is not None else (None, 0, 0)


@field(r"simulation\.details\.hertz\.(at_rad|pressure_pa|half_width_m|shear_depth_m|shear_pa)")
def contact(r, m):
    """Line contact: p = √(F E*/(π L R)), b = 2 p R/E*, greatest shear 0.300 p at the depth 0.786 b."""
    stated = r.simulation["details"]["hertz"]
    at = np.array([stated["at_rad"]])
    motion = [r.law(at, k) for k in range(3)]
    pressure = float(r.hertz(at, *motion)[0])
    half_width = 2 * pressure / (CONTACT_MODULUS * float(r.cam.curvature_sum(at, *motion)[0]))
    if m[1] == "at_rad":
        worst = r.law.extreme(r.hertz)[0]
        return (stated["at_rad"] if abs(pressure - worst) < 3e-8 * worst else math.nan), 0, 1e-12
    return close({"pressure_pa": pressure, "half_width_m": half_width, "shear_depth_m": 0.786 * half_width, "shear_pa": 0.300 * pressure}[m[1]],
                 2e-4 if m[1].startswith("shear") else RECOVERED)


@field(r"simulation\.(contact_lost|lost_fraction|settle_cycles|speed_rad_per_s|model|verdict|failed.*)")
def state(r, m):
    if m[1] == "speed_rad_per_s":
        return close(r.drive.speed, 1e-12)
    if m[1] in ("model", "verdict"):
        own = "rigid" if "machine" not in r.scene else r.simulation["model"]
        return own if m[1] == "model" else r.summary["verdict"], 0, 0
    if not is_plain(r):
        raise Unknown("a run that is not rigid at constant speed")
    lost = r.law.extreme(r.force, False)[0] < -1e-9 * abs(r.law.extreme(r.force)[0])
    return {"contact_lost": bool(lost), "lost_fraction": 0.0 if not lost else math.nan, "settle_cycles": 0}[m[1]], 0, 0


def columns(r):
    """Own columns of dynamics.csv."""
    motion = [r.law(r.run_theta, k) for k in range(4)]
    force, torque = r.force(r.run_theta, *motion), r.torque(r.run_theta, *motion)
    angle = r.cam.at(r.run_theta, *motion[:3])[3]
    own = {
        "contact_force_n": force, "torque_nm": torque, "power_w": torque * r.drive.speed, "lift_m": motion[0], "gap_m": np.zeros_like(force),
        "time_s": r.run_theta / r.drive.speed, "speed_rad_per_s": np.full_like(force, r.drive.speed),
    }
    if r.cam.kind == "flat-translating":
        own["normal_force_n"] = force
        own["side_thrust_n"] = np.zeros_like(force)
        # The cam's contact point moves with Rb + s along the face, the face's with the acceleration of the contact offset.
        own["sliding_m_per_s"] = r.drive.speed * (r.cam.size["base"] + motion[0])
        along = r.drive.speed * motion[2]
        own["entraining_m_per_s"] = own["sliding_m_per_s"] / 2 + along
    elif "translating" in r.cam.kind:
        own["normal_force_n"] = force / np.cos(angle)
        own["side_thrust_n"] = force * np.tan(angle)
    return own
