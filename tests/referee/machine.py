"""Motion of the machine under the cam: speed of the shaft with its motor, and motion of the floor.

With E = ω²/2, the equation of the shaft is (J + τ m v) E′ = T_motor(ω) − T_friction − τ (F₀ + k s + c ω v + 2 m a E + m z″),
where τ is the torque per newton of contact force. The equation of a mode q of the floor is m (q″ + 2ζω q′ + ω² q) = −φ F. It
moves the feet by z = φ q.
"""

import csv
import math
from pathlib import Path

import numpy as np

from units import quantity

TURN = 2 * math.pi
STEPS = 1440


class Motor:
    """Torque at the camshaft over its speed, for a no-load speed there. `torque` is a factor for the torque."""

    def __init__(self, scene, base=Path(), torque=1.0, inertia=1.0, friction=1.0):
        machine = scene["machine"]
        own = machine["motor"]
        gear, efficiency = quantity(own.get("gear", 1.0)), quantity(own.get("efficiency", 1.0))
        self.inertia = (quantity(machine.get("inertia", 0.0)) or 0.0) * inertia
        self.friction = (quantity(machine.get("friction_torque", 0.0)) or 0.0) * friction
        self.gear, self.efficiency = gear, efficiency
        self.slope = self.stall = self.curve = None
        if "slope" in own:
            self.slope = quantity(own["slope"]) * torque
        elif "stall_torque" in own:
            self.stall = quantity(own["stall_torque"]) * gear * efficiency * torque
        else:
            rows = curve_of(own["curve"], base)
            self.curve = [(speed / gear, t * gear * efficiency * torque) for speed, t in rows]
        self.no_load = self.free_speed()

    def free_speed(self):
        """No-load speed of a curve as given."""
        if self.curve is None:
            return None
        (w0, t0), (w1, t1) = self.part_of_curve(lambda row: row[1] <= 0)
        return w0 - t0 * (w1 - w0) / (t1 - t0)

    def part_of_curve(self, beyond):
        i = next((i for i, row in enumerate(self.curve) if beyond(row)), len(self.curve) - 1)
        i = max(i, 1)
        return self.curve[i - 1], self.curve[i]

    def torque(self, speed, no_load):
        if self.slope is not None:
            return self.slope * (no_load - speed)
        if self.stall is not None:
            return self.stall * (1.0 - speed / no_load)
        at = np.asarray(speed, float) - no_load + self.no_load
        w, t = np.array(self.curve).T
        i = np.clip(np.searchsorted(w, at, side="right"), 1, len(w) - 1)
        found = t[i - 1] + (t[i] - t[i - 1]) / (w[i] - w[i - 1]) * (at - w[i - 1])
        return float(found) if found.ndim == 0 else found

    def no_load_for(self, speed, torque):
        if self.slope is not None:
            return speed + torque / self.slope
        if self.stall is not None:
            return speed / max(1.0 - torque / self.stall, 0.05)
        (w0, t0), (w1, t1) = self.part_of_curve(lambda row: row[1] <= torque)
        return speed + self.no_load - (w0 + (torque - t0) * (w1 - w0) / (t1 - t0))


def curve_of(text, base):
    """Pairs of speed and torque from an alternating list of numbers, or from a file."""
    words = str(text).split()
    try:
        values = [float(word) for word in words]
        return list(zip(values[::2], values[1::2]))
    except ValueError:
        with open(base / text, newline="") as file:
            return [(float(row["speed_rad_per_s"]), float(row["torque_n_m"])) for row in csv.DictReader(file)]


class Shaft:
    """Periodic turn with a motor, with the duration of a given mean speed."""

    def __init__(self, law, drive, motor, lever, floor=lambda theta: 0.0, start=None):
        self.law, self.drive, self.motor, self.lever, self.floor = law, drive, motor, lever, floor
        self.mean = drive.speed
        self.table(STEPS)
        self.solve(start)

    def loads(self, theta, function):
        """τ for a pressing and for a pulling contact, F₀ + k s + m z″, c v, 2 m a, m v."""
        d = self.drive
        s, v, a = (function(theta, k) for k in range(3))
        pressed, pulled = self.lever(theta, s, v, a)
        return np.stack([pressed, pulled, d.rest + d.stiffness * s + d.inertia * self.floor(theta), d.damping * v,
                         2 * d.inertia * a, d.inertia * v], axis=1)

    def table(self, steps):
        """Loads at the ends and the middle of each step. Steps end where the law may jump."""
        left, middle, right, width, edges = [], [], [], [], []
        rest = self.law.end - self.law.start
        for start, end, function in self.law.pieces:
            count = max(4, math.ceil(steps * (end - start) / rest))
            at = np.linspace(start, end, count + 1)
            left.append(self.loads(at[:-1], function))
            middle.append(self.loads((at[:-1] + at[1:]) / 2, function))
            right.append(self.loads(at[1:], function))
            width.append(np.diff(at))
            edges.append(at[:-1])
        join = np.concatenate
        self.nodes = [join(left), join(middle), join(right)]
        self.width, self.edges = join(width), np.append(join(edges), self.law.end)
        self.steps = [(float(h), *(tuple(map(float, row)) for row in rows)) for h, *rows in zip(self.width, *self.nodes)]

    def rate(self, load, energy, no_load):
        """Derivative E′ for a load."""
        pressed, pulled, rest, damping, bend, mass = load
        speed = math.sqrt(2 * energy) if energy > 0 else 0.0
        still = rest + damping * speed + bend * energy
        drive = self.motor.torque(speed, no_load) - self.motor.friction
        found = (drive - pressed * still) / (self.motor.inertia + pressed * mass)
        if pressed != pulled and still + mass * found < 0:
            found = (drive - pulled * still) / (self.motor.inertia + pulled * mass)
        return found

    def turn(self, energy, no_load, keep=False):
        """Energy at the end of a turn, and its duration, by the Runge-Kutta method of order 4."""
        time, energies, times, rates = 0.0, [energy], [0.0], []
        for h, a, b, c in self.steps:
            k1 = self.rate(a, energy, no_load)
            e2 = energy + h / 2 * k1
            k2 = self.rate(b, e2, no_load)
            e3 = energy + h / 2 * k2
            k3 = self.rate(b, e3, no_load)
            e4 = energy + h * k3
            k4 = self.rate(c, e4, no_load)
            next_energy = energy + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
            if not (next_energy > 1e-5 * self.mean**2 and e2 > 0 and e3 > 0):
                return None
            # Duration by Simpson's rule, with the middle from a Hermite cubic.
            mid = (energy + next_energy) / 2 + h / 8 * (k1 - self.rate(c, next_energy, no_load))
            time += h / 6 * ((2 * energy) ** -0.5 + 4 * (2 * max(mid, 1e-30)) ** -0.5 + (2 * next_energy) ** -0.5)
            if keep:
                rates.append((k1, self.rate(c, next_energy, no_load)))
            energy = next_energy
            if keep:
                energies.append(energy)
                times.append(time)
        if keep:
            self.energy, self.time, self.slopes = np.array(energies), np.array(times), np.array(rates)
        return energy, time

    def slow_turn(self, energy, no_load):
        """As `turn`, but by the implicit midpoint rule, which is stable for small inertia and a stiff motor."""
        time = 0.0
        for h, _, load, _ in self.steps:
            k = self.rate(load, energy, no_load)
            middle = max(energy + h / 2 * k, 0.3 * energy)
            for _ in range(12):
                off = energy + h / 2 * self.rate(load, middle, no_load) - middle
                slope = h / 2 * (self.rate(load, middle * 1.000001, no_load) - self.rate(load, middle, no_load)) / (1e-6 * middle) - 1
                change = -off / slope
                middle = max(middle + change, 0.3 * middle)
                if abs(change) < 1e-11 * middle:
                    break
            energy = 2 * middle - energy
            if not energy > 1e-5 * self.mean**2:
                return None
            time += h * (2 * middle) ** -0.5
            self.least = min(self.least, energy)
        return energy, time

    def solve(self, start, rounds=60, slow=False):
        advance = self.slow_turn if slow else self.turn
        period = TURN / self.mean
        if start is None:
            level = 0.5 * self.mean**2
            still = self.nodes[1]
            force = still[:, 2] + still[:, 3] * self.mean + still[:, 4] * level
            arm = np.where(force < 0, still[:, 1], still[:, 0])
            torque = float(np.sum(self.width * arm * force)) / TURN
            energy, no_load = level, self.motor.no_load_for(self.mean, torque + self.motor.friction)
        else:
            energy, no_load = start
        for _ in range(rounds):
            self.least = math.inf
            found = advance(energy, no_load)
            if found is None:
                energy, no_load = 1.1 * energy, no_load * 1.01
                continue
            off = np.array([found[0] - energy, found[1] - period])
            de, dw = 1e-6 * energy, 1e-6 * no_load
            by_energy, by_supply = advance(energy + de, no_load), advance(energy, no_load + dw)
            if by_energy is None or by_supply is None:
                energy *= 1.05
                continue
            matrix = np.array([[(by_energy[0] - found[0]) / de - 1, (by_supply[0] - found[0]) / dw],
                               [(by_energy[1] - found[1]) / de, (by_supply[1] - found[1]) / dw]])
            step = np.linalg.solve(matrix, -off)
            part = min(1.0, 0.5 * energy / abs(step[0]) if step[0] else 1.0, 0.2 * abs(no_load) / abs(step[1]) if step[1] else 1.0)
            energy, no_load = energy + part * step[0], no_load + part * step[1]
            if part == 1.0 and abs(step[0]) < 1e-10 * energy and abs(step[1]) < 1e-10 * abs(no_load):
                break
        else:
            raise ArithmeticError("no turn that repeats")
        self.no_load, self.first = no_load, energy
        if not slow:
            self.turn(energy, no_load, keep=True)

    def place(self, theta):
        theta = np.asarray(theta, float)
        wrapped = np.where((theta < self.law.start) | (theta > self.law.end), self.law.start + np.mod(theta - self.law.start, TURN), theta)
        i = np.clip(np.searchsorted(self.edges, wrapped, side="right") - 1, 0, len(self.width) - 1)
        h = self.width[i]
        return i, (wrapped - self.edges[i]) / h, h

    def hermite(self, theta, values, left, right):
        i, u, h = self.place(theta)
        a, b = values[i], values[i + 1]
        return a + (b - a) * u * u * (3 - 2 * u) + h * u * (1 - u) * (left[i] * (1 - u) - right[i] * u)

    def half_square(self, theta):
        return self.hermite(theta, self.energy, self.slopes[:, 0], self.slopes[:, 1])

    def speed(self, theta):
        return np.sqrt(2 * self.half_square(theta))

    def clock(self, theta):
        rate = (2 * self.energy) ** -0.5
        turns = np.floor((np.asarray(theta, float) - self.law.start) / TURN)
        return self.hermite(theta, self.time, rate[:-1], rate[1:]) + np.where(np.asarray(theta) > self.law.end, turns * self.time[-1], 0.0)

    def angular(self, theta, s, v, a):
        """dω/dt at the given angles for a given motion."""
        d, energy = self.drive, self.half_square(theta)
        speed = np.sqrt(2 * energy)
        still = d.rest + d.stiffness * s + d.damping * speed * v + 2 * d.inertia * a * energy + d.inertia * self.floor(theta)
        pressed, pulled = self.lever(theta, s, v, a)
        torque = self.motor.torque(speed, self.no_load) - self.motor.friction
        found = (torque - pressed * still) / (self.motor.inertia + pressed * d.inertia * v)
        pulls = still + d.inertia * v * found < 0
        return np.where(pulls, (torque - pulled * still) / (self.motor.inertia + pulled * d.inertia * v), found)

    def stop_from_rest(self, lowest):
        """Angle, from the lowest lift, at which a start from rest ends; `None` if it completes a turn."""
        count = 2 * STEPS
        at = lowest + TURN * np.arange(2 * count + 1) / (2 * count)
        table = [tuple(map(float, row)) for row in self.loads(self.law.start + np.mod(at - self.law.start, TURN), self.law)]
        h, energy = TURN / count, 0.0
        for i in range(count):
            a, b, c = table[2 * i : 2 * i + 3]
            k1 = self.rate(a, energy, self.no_load)
            k2 = self.rate(b, max(energy + h / 2 * k1, 0.0), self.no_load)
            k3 = self.rate(b, max(energy + h / 2 * k2, 0.0), self.no_load)
            k4 = self.rate(c, max(energy + h * k3, 0.0), self.no_load)
            after = energy + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
            if after <= 0:
                return i * h + (energy / -k1 if k1 < 0 else 0.0)
            energy = after
        return None


class Floor:
    """Modes of a structure, and its walkers with phase and weight relative to the first one, the shaker."""

    def __init__(self, scene):
        machine = scene["machine"]
        own = machine["floor"]
        rows = own["mode"] if "mode" in own else [own]
        self.modes = [(quantity(r["mass"]), quantity(r["frequency"]), quantity(r["damping"]), quantity(r.get("ordinate", 1.0))) for r in rows]
        walkers = machine.get("walkers", {})
        count = int(walkers.get("count", 1))
        phases = [quantity(p) for p in listed(walkers.get("phases"))]
        weights = [quantity(w) for w in listed(walkers.get("weights"))] or [1.0] * count
        self.count, self.phases = count, phases
        self.weights = [w / weights[0] for w in weights]
        self.is_drawn = count > 1 and not phases

    def accelerance(self, w):
        """z″ per newton of the total foot force at the angular frequencies w."""
        total = np.zeros(len(w), complex)
        for mass, frequency, damping, ordinate in self.modes:
            own = TURN * frequency
            # q = −φF / (m (ω² − w² + 2iζωw)), z″ = −w² φ q.
            total += (ordinate * w) ** 2 / (mass * (own**2 - w**2 + 2j * damping * own * w))
        return total

    def others(self, target):
        """Harmonics of the force of the other walkers. They have the target force at their phases."""
        n = np.arange(len(target))
        total = np.zeros(len(target), complex)
        for phase, weight in list(zip(self.phases, self.weights))[1:]:
            total += weight * np.exp(1j * n * (phase - self.phases[0])) * target
        return total


def listed(value):
    if value is None:
        return []
    return value if isinstance(value, list) else [part.strip() for part in str(value).split(",")]


def series(harmonics, phase):
    """Sum over n ≥ 1 of Re(c_n e^{inφ})."""
    phase = np.asarray(phase, float)
    total = np.zeros(phase.shape)
    for n, c in enumerate(harmonics):
        if n and abs(c) > 0:
            total += c.real * np.cos(n * phase) - c.imag * np.sin(n * phase)
    return total


class Motion:
    """Steady motion of shaft and floor with a cam. `None` is a constant speed or a rigid floor."""

    def __init__(self, law, drive, motor, floor, lever, target, start=None):
        self.drive, self.speed_at_rest = drive, drive.speed
        self.shaft, self.floor, self.terms = None, floor, None
        self.wanted = harmonics_of(target, 720) if floor and target else None
        if motor is None and floor is not None:
            self.settle_floor(law, drive)
            return
        self.shaft = Shaft(law, drive, motor, lever, start=start)
        for _ in range(40 if floor else 0):
            before = self.terms
            self.settle_floor(law, drive)
            self.shaft = Shaft(law, drive, motor, lever, floor=self.floor_at, start=(self.shaft.energy[0], self.shaft.no_load))
            if before is not None and np.max(np.abs(before - self.terms)) < 1e-10 * drive.gravity:
                break

    def settle_floor(self, law, drive):
        """z″ from the force without the effect of the floor: F_n = (P_n + M H O_n)/(1 − M H), z″_n = H (F_n + O_n)."""
        count = 2880
        phase = TURN * (np.arange(count) + 0.5) / count
        theta = law.start + phase if self.shaft is None else self.angle(phase)
        still = drive.rest + drive.stiffness * law(theta)
        v, a = law(theta, 1), law(theta, 2)
        speed = drive.speed if self.shaft is None else self.shaft.speed(theta)
        turning = 0.0 if self.shaft is None else self.shaft.angular(theta, law(theta), v, a)
        still = still + drive.damping * speed * v + drive.inertia * (speed**2 * a + turning * v)
        n = np.arange(360)
        pressed = 2 * np.fft.rfft(still)[:360] / count * np.exp(-1j * n * math.pi / count)
        h = self.floor.accelerance(n * drive.speed)
        others = self.floor.others(self.wanted) if self.wanted is not None else 0.0
        force = (pressed + drive.inertia * h * others) / (1 - drive.inertia * h)
        self.terms = h * (force + others)
        self.terms[0] = 0.0
        fine = TURN * np.arange(5760) / 5760
        self.kept = series(self.terms, fine), series(1j * n * self.terms, fine)

    def angle(self, phase):
        """Cam angle at a fraction of the period."""
        time = phase / self.drive.speed
        theta = np.interp(time, self.shaft.time, self.shaft.edges)
        for _ in range(4):
            theta = np.clip(theta - (self.shaft.clock(theta) - time) * self.shaft.speed(theta), self.shaft.law.start, self.shaft.law.end)
        return theta

    def phase(self, theta):
        return np.asarray(theta, float) if self.shaft is None else self.shaft.clock(theta) * self.drive.speed

    def speed(self, theta):
        return np.full(np.shape(theta), self.drive.speed) if self.shaft is None else self.shaft.speed(theta)

    def angular(self, theta, s, v, a):
        return np.zeros(np.shape(theta)) if self.shaft is None else self.shaft.angular(theta, s, v, a)

    def floor_at(self, theta):
        if self.floor is None:
            return np.zeros(np.shape(theta))
        value, slope = self.kept
        count = len(value)
        place = np.mod(self.phase(theta), TURN) / TURN * count
        i = np.minimum(place.astype(int), count - 1)
        u, k, h = place - i, (i + 1) % count, TURN / count
        return (value[i] + (value[k] - value[i]) * u * u * (3 - 2 * u) + h * u * (1 - u) * (slope[i] * (1 - u) - slope[k] * u))

    def floor_figures(self):
        peak = float(np.max(np.abs(self.kept[0])))
        return peak, math.sqrt(0.5 * float(np.sum(np.abs(self.terms) ** 2)))

    def error_in_time(self, force, target):
        """Smallest RMS difference of force and target over time for any phase between them, and the mean of the target."""
        count = 1440
        part = TURN * np.arange(count) / count
        theta = self.angle(part) if self.shaft is not None else part
        have, want = np.fft.rfft(force(theta)) / count, np.fft.rfft(target(part)) / count
        n = np.arange(len(have))
        energy = np.sum(np.abs(have[1:]) ** 2 + np.abs(want[1:]) ** 2) * 2
        product = have * np.conj(want)

        def square(shift):
            return energy - 4 * float(np.real(np.sum(product[1:] * np.exp(-1j * n[1:] * shift)))) + abs(have[0] - want[0]) ** 2

        shifts = np.linspace(-math.pi, math.pi, 721)
        table = [square(shift) for shift in shifts]
        best = shifts[int(np.argmin(table))]
        low, high = best - TURN / 720, best + TURN / 720
        for _ in range(80):
            a, b = low + (high - low) / 3, high - (high - low) / 3
            low, high = (low, b) if square(a) < square(b) else (a, high)
        return math.sqrt(max(square((low + high) / 2), 0.0)), float(np.real(want[0]))


def harmonics_of(target, count):
    """Coefficients c_n of a periodic function Re Σ c_n e^{inφ}."""
    phase = TURN * np.arange(count) / count
    found = np.fft.rfft(target(phase)) / count
    found[1:] *= 2
    return found[:360]
