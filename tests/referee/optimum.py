"""Optimal law of a family under limits that are linear in the law, by an interior-point method on a dense grid of angles.

The limits are not enforced between the angles of the grid. The optimum is therefore a lower bound of the true optimum, with an
error of the order of the squared spacing. Multipliers of adjacent angles belong to one contact of the true program.
"""

import math

import numpy as np

ANGLES = 2880


def design_matrix(law_of, count, theta):
    """Columns: lift and three derivatives of each basis function, from a law of unit coefficients."""
    columns = [law_of([1.0 if i == k else 0.0 for i in range(count)]) for k in range(count)]
    return [np.stack([column(theta, order) for column in columns], axis=1) for order in range(4)]


def interior_point(h, g, a, b, e, f, level=0.0):
    """Solves min ½ xᵀHx + gᵀx with Ax ≤ b and Ex = f by Mehrotra's method. Returns x and the multipliers of Ax ≤ b.

    `level` is the magnitude of the objective if its value is only a change.
    """
    n, m = len(g), len(b)
    scale = np.maximum(np.linalg.norm(a, axis=1), 1e-300)
    a, b = a / scale[:, None], b / scale
    x = np.linalg.lstsq(np.vstack([h, e]), np.concatenate([-g, f]), rcond=None)[0]
    size = max(np.max(np.abs(b)), np.max(np.abs(a @ x)), 1e-9)
    slack = np.maximum(b - a @ x, 1e-2 * size)
    dual = np.full(m, max(np.max(np.abs(g)), 1e-9) / max(m, 1))
    nu = np.zeros(len(f))
    for _ in range(120):
        rd = h @ x + g + a.T @ dual + e.T @ nu
        rp, re = a @ x + slack - b, e @ x - f
        gap = slack @ dual / m
        objective = abs(0.5 * x @ h @ x + g @ x) + level + 1e-300
        if slack @ dual < 1e-12 * objective and np.max(np.abs(rp)) < 1e-12 * size and np.max(np.abs(rd)) < 1e-10 * np.max(np.abs(g)):
            break
        weight = dual / slack
        kkt = np.block([[h + a.T @ (weight[:, None] * a), e.T], [e, np.zeros((len(f), len(f)))]])

        def step(complement):
            right = np.concatenate([-rd - a.T @ ((dual * rp - complement) / slack), -re])
            solution = np.linalg.lstsq(kkt, right, rcond=None)[0] if not np.all(np.isfinite(kkt)) else solve(kkt, right)
            dx = solution[:n]
            ds = -rp - a @ dx
            return dx, solution[n:], ds, -(complement + dual * ds) / slack

        dx, _, ds, dl = step(dual * slack)
        reach = min(longest(slack, ds), longest(dual, dl))
        centre = ((slack + reach * ds) @ (dual + reach * dl) / m / gap) ** 3 if gap > 0 else 0.0
        dx, dn, ds, dl = step(dual * slack + ds * dl - centre * gap)
        reach = 0.995 * min(longest(slack, ds), longest(dual, dl))
        x, nu, slack, dual = x + reach * dx, nu + reach * dn, slack + reach * ds, dual + reach * dl
    return x, dual / scale


def solve(kkt, right):
    scale = 1 / np.sqrt(np.maximum(np.abs(np.diag(kkt)), 1e-300))
    scale = np.where(np.diag(kkt) == 0, 1.0, scale)
    matrix = kkt * scale[:, None] * scale
    matrix = matrix + 1e-15 * np.eye(len(right))
    return scale * np.linalg.solve(matrix, scale * right)


def longest(value, change):
    falling = change < 0
    return min(1.0, float(np.min(-value[falling] / change[falling]))) if falling.any() else 1.0


def cubic(theta, samples, span):
    """Function through periodic samples at equal steps, by cubics through four neighbours."""
    n = len(samples)
    place = (theta - span[0]) / (span[1] - span[0]) * n
    i = np.floor(place).astype(int)
    u = place - i
    a, b, c, d = (samples[(i + k) % n] for k in (-1, 0, 1, 2))
    return (-a * u * (u - 1) * (u - 2) / 6 + b * (u + 1) * (u - 1) * (u - 2) / 2 - c * (u + 1) * u * (u - 2) / 2 + d * (u + 1) * u * (u - 1) / 6)


class Program:
    """Program with the force error as objective, limits at a grid of angles, and demands as equalities."""

    def __init__(self, law_of, count, drive, target, span=(0.0, 2 * math.pi), angles=ANGLES):
        # Midpoints are used, so that jumps at knots are between them.
        theta = span[0] + (span[1] - span[0]) * (np.arange(angles) + 0.5) / angles
        self.theta = theta
        self.basis = design_matrix(law_of, count, theta)
        w = drive.speed
        self.force = drive.stiffness * self.basis[0] + drive.damping * w * self.basis[1] + drive.inertia * w * w * self.basis[2]
        self.rest = np.full(len(theta), drive.rest) + (drive.learned_force(theta) if drive.learned else 0.0)
        if drive.motion is not None and drive.motion.floor is not None:
            self.on_floor(drive)
        self.wanted = cubic(theta, target[1], span) if target else None
        self.rows, self.bounds, self.names = [], [], []
        self.equalities, self.values = [], []
        self.span, self.law_of, self.count = span, law_of, count
        self.objective = (self.force, self.wanted - self.rest) if target else None
        # The lowest point of the law is on the base circle.
        self.add("base_circle", -self.basis[0], 0.0)

    def on_floor(self, drive):
        """Force on the moving floor, which is linear in the law for each harmonic: F_n = (P_n + M H O_n)/(1 − M H)."""
        motion, count = drive.motion, len(self.theta)
        n = np.arange(count // 2 + 1)
        moved = drive.inertia * motion.floor.accelerance(n * drive.speed)
        moved[0] = 0.0
        self.force = np.fft.irfft(np.fft.rfft(self.force, axis=0) / (1 - moved)[:, None], count, axis=0)
        if motion.wanted is not None:
            others = motion.floor.others(motion.wanted)
            n = n[: len(others)]
            others = moved[: len(others)] * others / (1 - moved[: len(others)])
            turned = np.exp(1j * np.outer(self.theta, n)) @ np.where(n > 0, others, 0.0)
            self.rest = self.rest + turned.real

    def add(self, name, rows, bound):
        self.rows.append(rows)
        self.bounds.append(np.zeros(len(rows)) + bound)
        self.names += [name] * len(rows)

    def demand(self, order, theta, value):
        """Adds a demand: the lift or a derivative has a value at some angles."""
        self.equalities.append(design_matrix(self.law_of, self.count, np.asarray(theta, float))[order])
        self.values.append(np.full(len(theta), value))

    def value(self, coefficients):
        """Mean square of the objective's residual."""
        matrix, aim = self.objective
        return float(np.mean((matrix @ np.asarray(coefficients) - aim) ** 2))

    def size(self):
        return float(np.mean(self.objective[1] ** 2))

    def best(self):
        """Coefficients, mean square of the objective's residual, and multipliers of the rows of all limits."""
        matrix, aim = self.objective
        n = len(self.theta)
        h, g = matrix.T @ matrix / n, -matrix.T @ aim / n
        e, f = independent(self.equalities, self.values, self.count)
        x, dual = interior_point(h, g, np.vstack(self.rows), np.concatenate(self.bounds), e, f)
        return x, self.value(x), dual


def independent(rows, values, count):
    """Equations of full rank with the same solutions."""
    if not rows:
        return np.zeros((0, count)), np.zeros(0)
    u, size, v = np.linalg.svd(np.vstack(rows), full_matrices=False)
    kept = size > 1e-10 * size[0]
    return v[kept], (u[:, kept].T @ np.concatenate(values)) / size[kept]
