"""Recomputations of electronic cams: the points of each dialect are those of the law, and a cubic spline through them errs as stated."""

import math
import re

import numpy as np

DEGREE = math.pi / 180


def points(dialect, path):
    """Angle in rad, and lift with its derivatives by the angle as far as the dialect has them, in m."""
    text = path.read_text()
    scale = np.array([DEGREE, 1e-3, 1e-3 / DEGREE, 1e-3 / DEGREE**2])
    if dialect == "codesys":
        rows = [[float(x) for x in re.findall(r":= *([-+\d.eE]+)", line)] for line in text.splitlines() if "dX" in line]
    else:
        rows = [[float(x) for x in line.split(",")] for line in text.splitlines() if re.match(r"[-\d]", line)]
        if dialect == "segments":  # both ends of each
            rows = [row[:4] for row in rows] + [row[4:8] for row in rows]
    rows = np.array(rows)
    return rows * scale[: rows.shape[1]]


def periodic_cubic(y, h):
    """Second derivatives at the points of the periodic cubic spline through equally spaced values."""
    n = len(y)
    right = 6 * (np.roll(y, -1) - 2 * y + np.roll(y, 1)) / h**2
    # Circulant: 1 4 1.
    eigen = 4 + 2 * np.cos(2 * math.pi * np.arange(n) / n)
    return np.fft.ifft(np.fft.fft(right) / eigen).real


def judge(r, dialect, path, message, change=None):
    """Count of numbers and lines that differ; `change` multiplies the numbers of one column."""
    table = points(dialect, path)
    if change is not None:
        table[:, change] *= 1.001
    faults, theta = [], table[:, 0]
    accuracy = 1e-6 if dialect == "segments" else 1e-9
    for order in range(table.shape[1] - 1):
        own = r.law(theta, order)
        off = float(np.max(np.abs(table[:, order + 1] - own))) / float(np.max(np.abs(own)))
        if not off <= accuracy or len(table) < 8:
            faults.append(f"{dialect}: derivative {order} of the points differs by {off:.1e} of its size")
    count = table.size
    if dialect == "csv":
        y, n = table[:-1, 1], len(table) - 1
        bend, h = periodic_cubic(y, 2 * math.pi / n), 2 * math.pi / n
        fine = 2 * math.pi * (np.arange(16 * n) + 0.5) / (16 * n)
        i = (fine / h).astype(int)
        u = fine / h - i
        off = r.drive.inertia * r.drive.speed**2 * (bend[i] * (1 - u) + bend[(i + 1) % n] * u - r.law(fine, 2))
        own = 100 * math.sqrt(float(np.mean(off**2))) / float(np.mean(r.target))
        stated = float(re.search(r"of it ([\d.e+-]+) %", message)[1])
        count += 1
        if abs(stated - own) > 0.02 * own:  # printed with two digits
            faults.append(f"csv: stated {stated} % added by the table, recomputed {own}")
    return count, faults
