"""Recomputation of electronic cams: the points of each dialect are those of the law, and the controller has the stated force error."""

import math
import re

import numpy as np

DEGREE = math.pi / 180
SCALE = np.array([DEGREE, 1e-3, 1e-3 / DEGREE, 1e-3 / DEGREE**2])
# Dialect: ending of the file, relative accuracy of its numbers.
DIALECTS = {"csv": ("csv", 1e-9), "segments": ("csv", 1e-6), "codesys": ("st", 1e-9), "twincat": ("st", 1e-9), "rockwell": ("st", 1e-6)}
# Numbers of a point in structured text.
NUMBERS = {"codesys": r"d[XYVA] *:= *([-+\d.eE]+)", "twincat": r"(?:MasterPos|SlavePos|SlaveVelo|SlaveAcc) *:= *([-+\d.eE]+)",
           "rockwell": r"(?:Master|Slave) *:= *([-+\d.eE]+)"}
# A share of the mean force below this value, in per cent, is rounding.
ROUNDING = 1e-8
FINE = 16


def points(dialect, path):
    """Angle in rad, and lift in m with the derivatives by the angle that the dialect contains."""
    lines = path.read_text().splitlines()
    if dialect in NUMBERS:
        rows = [[float(x) for x in re.findall(NUMBERS[dialect], line)] for line in lines]
        rows = [row for row in rows if row]
    else:
        rows = [[float(x) for x in line.split(",")] for line in lines if re.match(r"[-\d]", line)]
        if dialect == "segments":  # both ends of each; the last angle is that of the end
            rows = [row[:4] for row in rows] + [rows[-1][4:8]]
    rows = np.array(rows)
    return rows * SCALE[: rows.shape[1]]


def periodic_cubic(y, h):
    """Second derivatives at the points of the periodic cubic spline through equally spaced values."""
    n = len(y)
    right = 6 * (np.roll(y, -1) - 2 * y + np.roll(y, 1)) / h**2
    # Circulant matrix with the elements 1 4 1.
    eigen = 4 + 2 * np.cos(2 * math.pi * np.arange(n) / n)
    return np.fft.ifft(np.fft.fft(right) / eigen).real


def clamped_cubic(y, h, start, end):
    """Second derivatives of the spline with given slopes at both ends. It has one value more than the periodic spline."""
    n = len(y)
    matrix = np.diag([2.0] + [4.0] * (n - 2) + [2.0]) + np.diag(np.ones(n - 1), 1) + np.diag(np.ones(n - 1), -1)
    right = np.empty(n)
    right[1:-1] = 6 * (y[2:] - 2 * y[1:-1] + y[:-2]) / h**2
    right[0], right[-1] = 6 * ((y[1] - y[0]) / h - start) / h, 6 * (end - (y[-1] - y[-2]) / h) / h
    return np.linalg.solve(matrix, right)


def control_points(dialect, table, text):
    """Bernstein coefficients of the polynomial of the controller on each interval between the points."""
    h, y = table[1, 0] - table[0, 0], table[:, 1]
    if table.shape[1] == 4:
        v, a = h / 5 * table[:, 2], h**2 / 20 * table[:, 3]
        first, last = (y + v, y + 2 * v + a), (y - 2 * v + a, y - v)
        return np.stack([y[:-1], *(c[:-1] for c in first), *(c[1:] for c in last), y[1:]], axis=1)
    if dialect == "csv":
        bend = periodic_cubic(y[:-1], h)
        bend = np.append(bend, bend[0])
    else:
        slopes = re.search(r"MCCP\(.*, *([-+\d.eE]+), *([-+\d.eE]+), *\w+\[0\]\)", text)
        bend = clamped_cubic(y, h, *(float(slopes[k]) * SCALE[2] for k in (1, 2)))
    left, right = y[:-1], y[1:]
    thirds = ((2 * left + right) / 3 - h**2 / 18 * (2 * bend[:-1] + bend[1:]), (left + 2 * right) / 3 - h**2 / 18 * (bend[:-1] + 2 * bend[1:]))
    return np.stack([left, *thirds, right], axis=1)


def followed(dialect, table, text):
    """Angles, with the second derivative of the controller's polynomial there, in the numbers of the controller."""
    control, h = control_points(dialect, table, text), table[1, 0] - table[0, 0]
    if DIALECTS[dialect][1] > 1e-8:  # REAL, in mm
        control = np.float64(np.float32(control / SCALE[1])) * SCALE[1]
    second = np.diff(control, 2, axis=1)
    u, k = (np.arange(FINE) + 0.5) / FINE, second.shape[1] - 1
    weights = np.array([math.comb(k, i) * u**i * (1 - u) ** (k - i) for i in range(k + 1)])
    bend = (k + 2) * (k + 1) / h**2 * (second @ weights)
    fine = table[0, 0] + h * (np.arange(len(control))[:, None] + u)
    return fine.ravel(), bend.ravel()


def judge(r, dialect, path, message, change=None):
    """Number of checked numbers, and differing lines. `change` multiplies the numbers of one column."""
    table, accuracy = points(dialect, path), DIALECTS[dialect][1]
    if change is not None:
        table[:, change] *= 1.001
    faults, theta = [], table[:, 0]
    for order in range(table.shape[1] - 1):
        own = r.law(theta, order)
        off = float(np.max(np.abs(table[:, order + 1] - own))) / float(np.max(np.abs(own)))
        if not off <= accuracy or len(table) < 8:
            faults.append(f"{dialect}: derivative {order} of the points differs by {off:.1e} of its size")
    fine, bend = followed(dialect, table, path.read_text())
    mass = r.drive.inertia * r.drive.speed**2
    added, mean = mass * (bend - r.law(fine, 2)), float(np.mean(r.target))
    stated = re.search(r"controller ([\d.e+-]+) N RMS; RMS deviation from the designed force (less than )?([\d.e+-]+) %", message)
    share = 100 * math.sqrt(float(np.mean(added**2))) / mean
    target = np.interp(fine, r.theta, r.target, period=2 * math.pi)
    whole = math.sqrt(float(np.mean((r.drive.rest + mass * bend - target) ** 2)))
    if stated[2] and share > float(stated[3]):
        faults.append(f"{dialect}: stated less than {stated[3]} % added by the file, recomputed {share}")
    added_share = share if stated[2] else float(stated[3])
    for what, given, own, part in (("N RMS", float(stated[1]), whole, 2e-3), ("% added by the file", added_share, share, 0.02)):
        # This number is printed with few digits.
        if abs(given - own) > part * own and max(given, own) > ROUNDING:
            faults.append(f"{dialect}: stated {given} {what}, recomputed {own}")
    return table.size + 2, faults
