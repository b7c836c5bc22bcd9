"""Walker of known mass: vertical force of each foot, from published relations of the peaks to the speed.

Peaks and their positions are linear fits to the 600 stances of Pataky et al. (2008), each divided by its mean. Step times,
peaks and the momentum at heel strike vary from step to step. The impulses of all stances sum to M g times the duration.
"""

from dataclasses import dataclass, field

import numpy as np

G = 9.81


@dataclass
class Stance:
    """Stance: foot (0 left, 1 right), first and last time in s, nodes of the shape and their force in N."""

    foot: int
    start: float
    end: float
    nodes: np.ndarray
    forces: np.ndarray
    ends: tuple
    transient: float

    def force(self, t):
        """Force at times t, N; zero outside the stance."""
        s = (t - self.start) / (self.end - self.start)
        return np.where((s > 0) & (s < 1), self.shape(np.clip(s, 0, 1)), 0.0)

    def shape(self, s):
        i = np.clip(np.searchsorted(self.nodes, s, side="right") - 1, 0, len(self.nodes) - 2)
        x0, x1, y0, y1 = self.nodes[i], self.nodes[i + 1], self.forces[i], self.forces[i + 1]
        h = x1 - x0
        u = (s - x0) / h
        first = np.where(i == 0, self.ends[0] * y1, 0.0)
        last = np.where(i == len(self.nodes) - 2, -self.ends[1] * y0, 0.0)
        cubic = y0 * (1 + 2 * u) * (1 - u) ** 2 + first * u * (1 - u) ** 2
        cubic += y1 * u * u * (3 - 2 * u) - last * u * u * (1 - u)
        bump = self.transient * self.forces[1] * np.exp(-0.5 * ((s - 0.06) / 0.018) ** 2)
        return cubic + bump * np.clip(s / 0.03, 0, 1)


@dataclass
class Walk:
    """Stances in order, and the true values for a reading."""

    mass: float
    speed: float
    stances: list
    step_s: float
    cv_time: float
    cv_impulse: float
    asymmetry: float = 0.0
    strikes: np.ndarray = field(default_factory=lambda: np.zeros(0))

    def feet(self, t):
        """Force of the left and the right foot at times t, N."""
        out = np.zeros((2, len(t)))
        for s in self.stances:
            a, b = np.searchsorted(t, [s.start, s.end])
            out[s.foot, a:b] += s.force(t[a:b])
        return out

    def middle(self, k):
        """Middle of stance k, where the other foot is in its swing phase."""
        return 0.5 * (self.stances[k].start + self.stances[k].end)

    def counts(self, t0, t1):
        """Complete stances of the left and the right foot between two times."""
        inside = [s.foot for s in self.stances if s.start > t0 and s.end < t1]
        return [inside.count(0), inside.count(1)]

    def stride_range(self, t0, t1):
        """Minimum and maximum of mean and median of the strides between two times, s."""
        times = self.strikes[(self.strikes > t0) & (self.strikes < t1)]
        strides = times[2:] - times[:-2]
        if len(strides) == 0:
            own = 2 * np.diff(times) if len(times) > 1 else np.array([2 * self.step_s])
            return own.mean() * (1 - 3 * self.cv_time), own.mean() * (1 + 3 * self.cv_time)
        kinds = [strides, strides[::2], strides[1::2]]
        values = [f(k) for k in kinds if len(k) for f in (np.mean, np.median)]
        return min(values), max(values)


def walk(rng, mass=None, speed=None, steps=24, cv_time=None, cv_force=None, asymmetry=0.0, first=0, start=0.4):
    """Walk of some steps from a time on. Parameters that are not given are random."""
    mass = mass or float(np.clip(rng.lognormal(4.28, 0.2), 40, 125))
    speed = speed or rng.uniform(0.85, 1.75)
    cv_time = rng.uniform(0.01, 0.03) if cv_time is None else cv_time
    cv_force = rng.uniform(0.01, 0.04) if cv_force is None else cv_force
    step_s = 1 / (1.05 + 0.6 * speed)
    duty = 0.68 - 0.045 * speed + rng.normal(0, 0.006)
    intervals = step_s * (1 + cv_time * np.clip(rng.normal(size=steps + 2), -2.5, 2.5))
    strikes = start + np.concatenate([[0], np.cumsum(intervals[1:])])
    momentum = 0.3 * cv_force * step_s * mass * G * np.clip(rng.normal(size=steps + 1), -2.5, 2.5)
    peaks = np.array([0.863 + 0.406 * speed, 1.561 - 0.525 * speed, 1.474 - 0.012 * speed])
    places = np.array([0.30 - 0.058 * speed, 0.455 + 0.02 * speed, 0.74 + 0.015 * speed])
    places += rng.normal(0, 0.006, 3)
    slopes = (rng.uniform(1.2, 1.9), rng.uniform(1.1, 1.8))
    transient = rng.uniform(0, 0.15)
    stances = []
    for k in range(steps):
        foot = (first + k) % 2
        before = intervals[k] if k else intervals[1]
        share = 1 + (0.5 - foot) * asymmetry
        impulse = mass * G * 0.5 * (before + intervals[k + 1]) * share + momentum[k + 1] - momentum[k]
        duration = 2 * step_s * duty * (1 + 0.5 * cv_time * np.clip(rng.normal(), -2.5, 2.5))
        forces = np.concatenate([[0], peaks * (1 + cv_force * np.clip(rng.normal(size=3), -2.5, 2.5)), [0]])
        nodes = np.concatenate([[0], places, [1]])
        s = Stance(foot, strikes[k], strikes[k] + duration, nodes, forces, slopes, transient)
        s.forces = forces * impulse / duration / s.shape(np.linspace(0, 1, 801)).mean()
        stances.append(s)
    cv_impulse = np.hypot(0.3 * np.sqrt(2) * cv_force, cv_time / np.sqrt(2))
    return Walk(mass, speed, stances, step_s, cv_time, cv_impulse, asymmetry, strikes[:steps])


@dataclass
class Sensor:
    """Disturbance of a plate: noise, offset and hum in N, share of the other plates, sign."""

    noise: float = 0.0
    offset: float = 0.0
    hum: tuple = (0.0, 50.0)
    cross: float = 0.0
    sign: float = 1.0
    drift: float = 0.0


def measured(rng, t, forces, sensor):
    """Readings of plates for true forces (one row each) at times t."""
    total = forces.sum(axis=0)
    out = np.empty_like(forces)
    for k, own in enumerate(forces):
        hum = sensor.hum[0] * np.sin(2 * np.pi * sensor.hum[1] * t + rng.uniform(0, 6.28))
        offset = sensor.offset * rng.uniform(-1, 1)
        x = own + sensor.cross * (total - own) + offset + hum + sensor.drift * (t - t[0])
        out[k] = sensor.sign * (x + rng.normal(0, sensor.noise, len(t)) if sensor.noise else x)
    return out
