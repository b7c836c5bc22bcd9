"""Force of the drive, target force, and derived quantities at the constant speed of a rigid machine."""

import copy
import math

import numpy as np

from units import quantity

GRAVITY = 9.81


def learned_terms(rows):
    """Amplitude in N and phase of each term."""
    parts = [str(row).partition(" at ") for row in (rows if isinstance(rows, list) else [rows] if rows else [])]
    return [(quantity(size.strip()), quantity(phase.strip() or 0.0)) for size, _, phase in parts]


class Drive:
    """F = F0 + k s + c ω v + m ω² a. For an arm this is a torque, which acts as a force at the lever."""

    def __init__(self, scene, mass, speed, lever):
        drive = scene["drive"]
        self.kind = drive.get("kind", "fixed-axis")
        self.mass, self.speed, self.lever = mass, speed, lever
        self.gravity = quantity(drive.get("gravity", GRAVITY))
        self.rest = self.stiffness = self.damping = 0.0
        self.inertia = mass
        self.motion = None
        self.learned = learned_terms(scene.get("machine", {}).get("learned_force"))
        if self.kind == "moving-axis":
            self.rest = mass * self.gravity
        elif self.kind == "hydraulic":
            area = math.pi * quantity(drive["piston_radius"]) ** 2
            self.stiffness, self.inertia = quantity(drive["pressure_per_volume"]) * area**2, 0.0
        else:
            self.rest = quantity(drive.get("preload", 0)) or 0.0
            self.stiffness = quantity(drive.get("spring_rate", 0)) or 0.0
            self.damping = quantity(drive.get("damping", 0)) or 0.0

    def learned_force(self, theta):
        """Force of the machine outside its drive: a mean, then harmonics of the turn as A sin(nθ + p)."""
        return self.lever * sum(size * np.sin(n * theta + phase) if n else size for n, (size, phase) in enumerate(self.learned))

    def force(self, theta, s, v, a, j=None):
        if self.learned:
            plain = copy.copy(self)
            plain.learned = []
            return plain.force(theta, s, v, a) + self.learned_force(theta)
        if self.motion is None:
            w = self.speed
            return self.rest + self.stiffness * s + self.damping * w * v + self.inertia * w * w * a
        w = self.motion.speed(theta)
        moved = w * w * a + self.motion.angular(theta, s, v, a) * v + self.motion.floor_at(theta)
        return self.rest + self.stiffness * s + self.damping * w * v + self.inertia * moved

    def liftoff(self, law):
        """Smallest speed at which the force touches zero; `None` without inertia and damping."""
        if self.inertia == 0.0 and self.damping == 0.0:
            return None

        def touches(theta, s, v, a, j):
            """Smallest root of m a ω² + c v ω + F₀ + k s."""
            square, slope, rest = self.inertia * a, self.damping * v, self.rest + self.stiffness * s
            with np.errstate(all="ignore"):
                root = np.sqrt(slope**2 - 4 * square * rest)
                # The smaller positive one of both roots 2C/(−B ± √(B² − 4AC)).
                near, far = 2 * rest / (-slope + root), 2 * rest / (-slope - root)
                found = np.minimum(np.where(near > 0, near, np.inf), np.where(far > 0, far, np.inf))
            return np.where(rest <= 0, np.where((slope < 0) | (slope == 0) & (square < 0), 0.0, np.inf), found)

        least = law.extreme(touches, largest=False)[0]
        return least if math.isfinite(least) else None


def model(name, frequency, weight, phase, feet="both"):
    """Force of both feet, G (1 + Σ a_i sin(i phase + p_i)), or of one foot over its stride; `None` for an unknown model."""
    if name == "li-2010":
        return weight * (both_feet(phase, frequency) if feet == "both" else stance(phase / math.pi, frequency))
    factors = load_factors(name, frequency)
    return None if factors is None or feet != "both" else weight * sines(factors, phase)


def load_factors(name, f):
    """Amplitude and added phase of each harmonic of the step frequency (SOURCES.md of the curves); `None` for other models."""
    pi = math.pi
    return {
        "blanchard": [(180 / 700, 0.0)],
        "bachmann": [(0.4 + 0.1 * (min(max(f, 2.0), 2.4) - 2.0) / 0.4, 0.0), (0.1, -pi / 2), (0.1, -pi / 2)],
        "setra": [(0.4, 0.0), (0.1, -pi / 2), (0.1, -pi / 2)],
        "rebelo": [(0.43 * f - 0.38, 0.0), (0.15 * f - 0.125 if f > 1.5 else 0.0, 0.0), (0.1, 0.0)],
        "kerr": [(-0.2649 * f**3 + 1.3206 * f**2 - 1.7597 * f + 0.7613, 0.0), (0.07, 0.0), (0.05, 0.0)],
        "young": [(min(0.37 * (f - 0.95), 0.5), 0.0), (0.054 + 0.0044 * 2 * f, -pi / 2), (0.026 + 0.0050 * 3 * f, pi),
                  (0.010 + 0.0051 * 4 * f, pi / 2)],
        "young-design": [(min(0.41 * (f - 0.95), 0.56), 0.0), (0.069 + 0.0056 * 2 * f, -pi / 2), (0.033 + 0.0064 * 3 * f, pi),
                         (0.013 + 0.0065 * 4 * f, pi / 2)],
        "sci-p354": [(0.436 * (f - 0.95), 0.0), (0.006 * (2 * f + 12.3), -pi / 2), (0.007 * (3 * f + 5.2), pi), (0.007 * (4 * f + 2.0), pi / 2)],
        "iso-10137": [(0.37 * (f - 1.0), 0.0), (0.1, 0.0), (0.06, 0.0), (0.06, 0.0), (0.06, 0.0)],
    }.get(name)


def sines(factors, phase):
    """Value of 1 + Σ a_i sin(i phase + p_i)."""
    force = np.ones_like(phase)
    for i, (size, shift) in enumerate(factors, 1):
        force = force + size * np.sin(i * phase + shift)
    return force


def stance(steps, frequency):
    """Force of one foot per weight (Li and others 2010), over the number of steps since its strike. A stride has two steps."""
    f = frequency
    part = np.mod(steps, 2.0) * 0.76
    sizes = (-0.0698 * f + 1.211, 0.1052 * f - 0.1284, 0.3002 * f - 0.1534, 0.0416 * f - 0.0288, -0.0275 * f + 0.0608)
    return np.where(part < 1.0, sum(size * np.sin(n * math.pi * part) for n, size in enumerate(sizes, 1)), 0.0)


def both_feet(phase, frequency):
    """Force of two feet half a stride apart, over the phase of a step."""
    step = np.mod(phase, 2 * math.pi) / (2 * math.pi)
    return stance(step, frequency) + stance(step + 1.0, frequency)


def harmonics(samples, count):
    """Amplitude and phase p of the terms A sin(nθ + p) of equally spaced samples of one turn."""
    spectrum = np.fft.rfft(samples) / len(samples)
    return [(2 * abs(spectrum[n]), float(np.angle(spectrum[n]) + math.pi / 2)) for n in range(1, count + 1)]
