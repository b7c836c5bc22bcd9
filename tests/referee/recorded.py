"""Target from a file of critical points: the curve through them, level at maxima and minima and monotone between them."""

import re
from pathlib import Path

import numpy as np

from units import factor, quantity

REPOSITORY = Path(__file__).resolve().parents[2]


def read(r):
    """Period in s, and times in s and forces in N of the critical points; `None` for any other file."""
    text = r.scene["gait"].get("file")
    found = [path for base in (r.folder, REPOSITORY / "scenes") if isinstance(text, str) and (path := base / text).is_file()]
    lines = found[0].read_text().splitlines() if found else []
    header = next((match for line in lines if (match := re.match(r"# critical points, period_s = ([\d.]+)", line))), None)
    if header is None:
        return None
    rows = [line.split(",") for line in lines if line and not line.startswith("#")]
    unit = factor(rows[0][1].removeprefix("force_"))
    time, force = np.array([[float(x) for x in row] for row in rows[1:]]).T
    return float(header[1]), time, force * unit


def slopes(time, force):
    """Slopes at periodic points: 0 at an extreme, else a weighted harmonic mean of the adjacent slopes (Fritsch and Butland 1984)."""
    width, secant = np.diff(time), np.diff(force) / np.diff(time)
    before, slope_before = np.roll(width, 1), np.roll(secant, 1)
    own = np.zeros(len(width))
    same = slope_before * secant > 0
    near, far = (2 * width + before)[same], (width + 2 * before)[same]
    own[same] = (near + far) / (near / slope_before[same] + far / secant[same])
    return np.append(own, own[0])


def curve(r):
    """Target over the phase of the cycle, N; `None` for any other file."""
    points = read(r)
    if points is None:
        return None
    period, time, force = points
    gait = r.scene["gait"]
    given, span = quantity(gait.get("period")), quantity(gait.get("span"))
    if given or span or gait.get("scale", "none") != "none":
        return None
    time, force = np.append(time, time[0] + period), np.append(force, force[0])
    slope = slopes(time, force)
    shift = quantity(gait.get("phase", 0.0))
    shift = r.summary["law"]["phase_rad"] if shift is None else shift

    def at(phase):
        x = time[0] + np.mod((phase + shift) / (2 * np.pi) * period - time[0], period)
        i = np.clip(np.searchsorted(time, x, side="right") - 1, 0, len(time) - 2)
        h = time[i + 1] - time[i]
        u = (x - time[i]) / h
        return (force[i] * (1 + 2 * u) * (1 - u) ** 2 + force[i + 1] * u * u * (3 - 2 * u)
                + h * u * (1 - u) * (slope[i] * (1 - u) - slope[i + 1] * u))

    return at
