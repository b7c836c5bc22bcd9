"""Smallest cam with a translating roller whose law, prime circle and offset are free.

The variables are the coefficients of the law, the depth D and the offset e; the objective is √(D² + e²). The limits on pressure angle, level
and direction of the motion are linear in them. The limit on the radius of curvature is not convex, so that the optimum is the one near the
stated design.
"""

import math

import numpy as np

import law as laws
from optimum import interior_point
from result import Unknown
from units import quantity

COARSE, FINE, ROUNDS = 240, 12000, 10


def is_sized(r):
    """Whether law and size are variables of one program that is implemented here."""
    law, cam = r.scene["law"], r.scene["cam"]
    return (law.get("minimise") == "size" and r.cam.kind == "roller-translating" and cam.get("prime_radius", "auto") == "auto"
            and cam.get("offset") == "auto" and set(r.scene["limits"]) <= {"pressure_angle", "curvature"})


class Sized:
    """Limits as functions that are at most 0, with their gradients."""

    def __init__(self, r, eased=None):
        if not is_sized(r):
            raise Unknown("certificate of this objective")
        law, limits = r.summary["law"], r.scene["limits"]
        self.count = len(law["coefficients"])
        knots = law["functions"]["b-spline"]["knots_rad"]
        self.columns = [laws.spline(knots, law["degree"], np.eye(self.count)[k]) for k in range(self.count)]
        self.roller, self.least = r.cam.roller, quantity(limits["curvature"])
        angle = quantity(limits["pressure_angle"])
        self.slope = {side: math.tan(angle * (1.01 if eased == f"pressure_angle_{side}" else 1.0)) for side in ("rise", "fall")}
        self.least *= 1.01 if eased == "curvature" else 1.0
        self.marks = [quantity(point["angle"]) for point in r.scene["law"]["point"]]
        self.prescribe(r)
        depth = math.sqrt(r.cam.size["prime"] ** 2 - r.cam.size["offset"] ** 2)
        self.start = np.concatenate([law["coefficients"], [depth, r.cam.size["offset"]]])

    def basis(self, theta):
        theta = np.asarray(theta, float)
        return [np.stack([column(theta, order) for column in self.columns], axis=1) for order in range(3)]

    def prescribe(self, r):
        """Directions that do not change lift and velocity of points and dwells."""
        rows = []
        for point in r.scene["law"]["point"]:
            own = self.basis([quantity(point["angle"])])
            rows += [own[0]] if "lift" in point or "force" in point else []
            rows += [own[1]] if "velocity" in point else []
        for dwell in r.scene["law"].get("dwell", []):
            rows.append(self.basis(np.linspace(quantity(dwell["from"]), quantity(dwell["to"]), 41))[0])
        _, size, turned = np.linalg.svd(np.vstack(rows), full_matrices=True)
        free = turned[int(np.sum(size > 1e-10 * size[0])):].T
        self.free = np.zeros((self.count + 2, free.shape[1] + 2))
        self.free[: self.count, :-2] = free
        self.free[self.count, -2] = self.free[self.count + 1, -1] = 1.0
        # Points are level: the law alternately rises and falls between them, and is at rest behind the last.
        self.moving = self.marks[-1]

    def rising(self, theta):
        return np.where(np.searchsorted(self.marks, theta, side="right") % 2 == 1, 1.0, -1.0)

    def sharpness(self, s, v, a, depth, offset):
        """K − √w³/ρ, at most 0 if the radius √w³/K of the pitch curve is at least ρ, the minimum radius plus that of the roller."""
        along, across = depth + s, v - offset
        square = along**2 + across**2
        return square + v * across - a * along - square**1.5 / (self.least + self.roller)

    def limits(self, x, theta, basis):
        """Names, values and gradients of all limits at angles."""
        c, depth, offset = x[: self.count], x[-2], x[-1]
        s, v, a = (part @ c for part in basis)
        one, none, sign = np.ones(len(theta)), np.zeros(len(theta)), self.rising(theta)
        rows = {"monotone": (-sign * v, np.column_stack([-sign[:, None] * basis[1], none, none]))}
        for side, turn in (("rise", 1.0), ("fall", -1.0)):
            slope = self.slope[side]
            rows[f"pressure_angle_{side}"] = (turn * (v - offset) - slope * (depth + s),
                                              np.column_stack([turn * basis[1] - slope * basis[0], -slope * one, -turn * one]))
        own, h, by = [s, v, a, depth, offset], 1e-6, []
        for k in range(5):
            near = [[part + side * h * (i == k) for i, part in enumerate(own)] for side in (1, -1)]
            by.append((self.sharpness(*near[0]) - self.sharpness(*near[1])) / (2 * h))
        gradient = np.column_stack([sum(g[:, None] * part for g, part in zip(by, basis)), by[3], by[4]])
        rows["curvature"] = (self.sharpness(*own), gradient)
        return rows

    def solve(self):
        """Radius, and angles, names and multipliers of all rows at the optimum near the start."""
        x = self.start.copy()
        theta = (np.arange(COARSE) + 0.5) * self.moving / COARSE
        fine = (np.arange(FINE) + 0.5) * self.moving / FINE
        basis, fine_basis = self.basis(theta), self.basis(fine)
        before = math.inf
        for _ in range(ROUNDS):
            rows = self.limits(x, theta, basis)
            radius = math.hypot(x[-2], x[-1])
            slope = np.zeros(len(x))
            slope[-2:] = x[-2:] / radius
            values = np.concatenate([value for value, _ in rows.values()])
            gradients = np.vstack([gradient for _, gradient in rows.values()])
            step, dual = interior_point(10.0 * np.eye(self.free.shape[1]), self.free.T @ slope, gradients @ self.free, -values,
                                        np.zeros((0, self.free.shape[1])), np.zeros(0), level=radius)
            x = x + self.free @ step
            names, places = np.repeat(list(rows), len(theta)), np.tile(theta, len(rows))
            if abs(before - radius) < 1e-8 * radius:
                break
            before = radius
            theta, basis = self.finer(x, theta, basis, fine, fine_basis)
        return math.hypot(x[-2], x[-1]), places, names, dual

    def finer(self, x, theta, basis, fine, fine_basis):
        """The angles, and those between them at which a limit is closest or exceeded."""
        more = set()
        for value, _ in self.limits(x, fine, fine_basis).values():
            peak = (value[1:-1] >= value[:-2]) & (value[1:-1] >= value[2:]) & (value[1:-1] > -1e-6)
            more |= set(np.nonzero(peak)[0] + 1)
        more = np.array([place for place in fine[sorted(more)] if np.min(np.abs(theta - place)) > 1e-9])
        if not len(more):
            return theta, basis
        return np.concatenate([theta, more]), [np.vstack([old, new]) for old, new in zip(basis, self.basis(more))]


def best(r, eased=None):
    """Radius, and positions, names and multipliers of the rows at the optimum, with a limit relaxed by 1 %."""
    return r.kept(f"smallest cam of {eased}", lambda: Sized(r, eased).solve())


def binding(r, row, what):
    """Checks a value of an active limit: the limit is reached there, and its multiplier is the sum of the adjacent ones."""
    _, places, names, dual = best(r)
    if what == "limit":
        return (row["limit"] if row["limit"] in set(names) | {"base_circle"} else math.nan), 0, 0
    program = r.kept("sized", lambda: Sized(r))
    at = np.array([row["at_rad"]])
    basis = program.basis(at)
    if what == "at_rad":
        value = -(basis[0] @ program.start[:-2]) if row["limit"] == "base_circle" else program.limits(program.start, at, basis)[row["limit"]][0]
        return (row["at_rad"] if abs(float(value[0])) < 1e-7 else math.nan), 0, 1e-12
    if row["limit"] in ("base_circle", "monotone"):
        raise Unknown("multiplier of a limit that prescribed points fix")
    # The sequence of the program ends when a step improves by less than 1e-7, and adjacent contacts share their sum.
    total = float(np.sum(dual[names == row["limit"]]))
    others = sum(other["multiplier"] for other in r.summary["binding"] if other["limit"] == row["limit"]) - row["multiplier"]
    return total - others, 0, 5e-3 * total
