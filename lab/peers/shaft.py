"""A motor with every follower and drive: dynamics.csv of `gaitcam simulate` compared with scipy's DOP853 in time for (θ, ω), with
the closed form of the law. Only the scene is shared. The law is s = h/2 (1 − cos θ), two harmonic segments."""

import csv
import json
import os
import subprocess
import tempfile
from pathlib import Path

import numpy as np
from scipy.integrate import solve_ivp

GAITCAM = os.environ["GAITCAM"]
G, SPEED = 9.81, 9.0
SLIDE, ARM = 0.02, 0.12
FOLLOWERS = {
    "flat-translating": {"base_radius": "50 mm"},
    "roller-translating": {"prime_radius": "60 mm", "roller_radius": "12 mm", "offset": "-11 mm"},
    "knife-translating": {"prime_radius": "60 mm"},
    "mushroom-translating": {"prime_radius": "120 mm", "arc_radius": "80 mm"},
    "barrel": {"prime_radius": "60 mm", "roller_radius": "10 mm"},
    "roller-oscillating": {"prime_radius": "50 mm", "roller_radius": "10 mm", "pivot_distance": "90 mm", "arm": "70 mm"},
    "flat-oscillating": {"base_radius": "45 mm", "pivot_distance": "110 mm", "face_offset": "6 mm"},
    "conjugate": {"prime_radius": "60 mm", "roller_radius": "12 mm"},
}
# Keys of a drive, then F0, k, c, m of F = F0 + k s + c ds/dt + m d2s/dt2, inertia and slope.
AREA = np.pi * 0.012**2
SLIDES = {
    "moving-axis": ({"mass": "70 kg"}, (70 * G, 0, 0, 70), 0.5, 10),
    "fixed-axis": ({"mass": "20 kg", "spring_rate": "5000 N/m", "preload": "400 N", "damping": "60 N s/m"}, (400, 5000, 60, 20), 0.3, 5),
    "hydraulic": ({"pressure_per_volume": "5e11 Pa/m^3", "piston_radius": "12 mm"}, (0, 5e11 * AREA**2, 0, 0), 0.2, 4),
}
ARMS = {
    "fixed-axis": ({"lever": "1 m", "inertia": "0.4 kg m^2", "spring_rate": "150 N m/rad", "preload": "60 N m"}, (60, 150, 0, 0.4), 0.1, 2),
}
FRICTION = 0.7


def scene(follower, kind, keys, inertia, slope):
    """Text of a scene file."""
    arm = follower.endswith("oscillating")
    cam = dict(FOLLOWERS[follower])
    name = "roller-translating" if follower == "conjugate" else follower
    lines = ['name = "peer"', "[cam]", f'follower = "{name}"', *(f'{k} = "{v}"' for k, v in cam.items())]
    if follower == "conjugate":
        lines += ["[cam.conjugate]", 'base_radius = "48 mm"']
    lines += ["[drive]", f'kind = "{kind}"', f'speed = "{SPEED} rad/s"', *(f'{k} = "{v}"' for k, v in keys.items())]
    lines += ["[law]", 'family = "program"']
    lift = f"{ARM} rad" if arm else f"{SLIDE} m"
    for sign in ("", "-"):
        lines += ["[[law.segment]]", 'motion = "simple-harmonic"', f'lift = "{sign}{lift}"', 'angle = "180 deg"']
    lines += ["[machine]", f'inertia = "{inertia} kg m^2"', f'friction_torque = "{FRICTION} N m"', f'motor = {{ slope = "{slope} N m s/rad" }}']
    return "\n".join(lines) + "\n"


def steady(stroke, coefficients, inertia, slope, no_load, start, angles):
    """Force at the angles in the steady turn, and the duration of the turn, by DOP853."""
    f0, k, c, m = coefficients

    def rates(_, state):
        theta, w = state
        s, v, a = 0.5 * stroke * (1 - np.cos(theta)), 0.5 * stroke * np.sin(theta), 0.5 * stroke * np.cos(theta)
        still = f0 + k * s + c * v * w + m * a * w * w
        rate = (slope * (no_load - w) - FRICTION - v * still) / (inertia + m * v * v)
        return w, rate, still + m * v * rate

    def done(_, state):
        return state[0] - 2 * np.pi

    done.terminal, done.direction = True, 1
    w = start
    for _ in range(300):
        turn = solve_ivp(lambda t, y: rates(t, y)[:2], (0, 100), (0, w), "DOP853", events=done, dense_output=True, rtol=1e-12, atol=1e-12)
        end = turn.y_events[0][0][1]
        if abs(end - w) < 1e-11 * w:
            break
        w = end
    period = turn.t_events[0][0]
    # Time of each angle, by Newton's method.
    times = np.interp(angles, turn.y[0], turn.t)
    for _ in range(6):
        theta, speed = turn.sol(times)
        times = times - (theta - angles) / speed
    return np.array([rates(0, turn.sol(t))[2] for t in times]), period


def main():
    ran = 0
    for follower in FOLLOWERS:
        arm = follower.endswith("oscillating")
        for kind, (keys, coefficients, inertia, slope) in (ARMS if arm else SLIDES).items():
            with tempfile.TemporaryDirectory() as folder:
                file, out = Path(folder, "peer.toml"), Path(folder, "out")
                file.write_text(scene(follower, kind, keys, inertia, slope), encoding="utf-8")
                command = [GAITCAM, "simulate", file, "--model", "rigid", "--json", "--out", out]
                done = subprocess.run(command, capture_output=True, text=True)
                assert done.returncode in (0, 3) and done.stdout, f"{follower}, {kind}: {done.stderr}"
                shaft = json.loads(done.stdout)["shaft"]
                with open(out / "dynamics.csv", newline="", encoding="utf-8") as table:
                    rows = [{k: float(v) for k, v in row.items()} for row in csv.DictReader(table)]
            angles = np.array([row["theta_rad"] for row in rows])
            own = np.array([row["contact_force_n"] for row in rows])
            stroke = ARM if arm else SLIDE
            forces, period = steady(stroke, coefficients, inertia, slope, shaft["no_load_speed_rad_per_s"], rows[0]["speed_rad_per_s"], angles)
            mean = abs(forces.mean())
            off = np.abs(own - forces).max() / mean
            slow = abs(period * SPEED / (2 * np.pi) - 1)
            print(f"{follower:21} {kind:12} ripple {100 * shaft['ripple']:5.2f} %, force off {off:.1e} of the mean, period off {slow:.1e}")
            assert shaft["ripple"] > 0.03 and off < 1e-5 and slow < 1e-6, (follower, kind)
            assert abs(shaft["energy_balance"]) < 1e-9, shaft
            ran += 1
    print(f"{ran} machines agree")


main()
