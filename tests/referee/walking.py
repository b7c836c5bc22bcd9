"""Recomputations of the recorded walk against the cam at resonance, from strides.csv and the law."""

import copy
import math

import numpy as np

from result import close, field

OF_STRIDE = 128  # rows of strides.csv for each stride
HARMONICS = 48  # of the stride; a mode near the step frequency hardly responds to higher ones
DAMPING = (0.003, 0.005, 0.01)


def strides(r):
    """Force of the recorded strides at equal steps, their duration and number."""
    time, force = np.loadtxt(r.folder / "strides.csv", delimiter=",", skiprows=1).T
    return force, len(time) * (time[-1] - time[0]) / (len(time) - 1), round(len(time) / OF_STRIDE)


def steady(r):
    """Force of the cam at constant speed over a turn, and its duration."""
    theta = r.law.start + 2 * math.pi * np.arange(1024) / 1024
    drive = copy.copy(r.drive)
    drive.motion = None
    force = drive.force(theta, *(r.law(theta, k) for k in range(3))) / drive.lever
    return force, 2 * math.pi / abs(drive.speed), 1


def peak(force, duration, count, damping):
    """Highest RMS acceleration of a mode of 1 kg tuned through 0.9 … 1.1 of the step frequency: each line of the repeated force through the mode."""
    lines = np.fft.rfft(force)[1 : HARMONICS * count + 1] / len(force)
    own = np.arange(1, len(lines) + 1) / duration
    highest = 0.0
    for part in np.linspace(0.9, 1.1, 401):
        ratio = own / (part * 2 * count / duration)
        response = ratio**2 / (1 - ratio**2 + 2j * damping * ratio)
        highest = max(highest, 2 * float(np.sum(np.abs(response * lines) ** 2)))
    return math.sqrt(highest)


@field(r"walker\.(strides|step_frequency_hz)")
def walk(r, m):
    _, duration, count = strides(r)
    return (count, 0, 0) if m[1] == "strides" else close(2 * count / duration, 1e-9)


@field(r"walker\.resonance\[(\d)\]\.(\w+)")
def resonance(r, m):
    damping, name = DAMPING[int(m[1])], m[2]
    if name == "damping_ratio":
        return damping, 0, 0
    recorded = strides(r)
    if name == "resolved":
        return 2 * math.pi * damping * recorded[2] >= 1, 0, 0
    under = {"recorded": lambda: peak(*recorded, damping), "mean_stride": lambda: peak(*steady(r), damping)}
    if name in under:
        return close(r.kept(f"{name}{damping}", under[name]), 1e-5)
    return close(peak(*steady(r), damping) / peak(*recorded, damping), 1e-5)
