"""The law of motion, evaluated from the coefficients in a summary."""

import math

import numpy as np

GOLDEN = (math.sqrt(5) - 1) / 2


class Law:
    """Lift and derivatives over one cycle. `pieces` are (start, end, function of (theta, order))."""

    def __init__(self, pieces):
        self.pieces = pieces
        self.start, self.end = pieces[0][0], pieces[-1][1]

    def __call__(self, theta, order=0):
        theta = np.atleast_1d(np.asarray(theta, float))
        value = np.zeros_like(theta)
        length = self.end - self.start
        wrapped = np.where(theta > self.end, self.start + np.mod(theta - self.start, length), theta)
        for start, end, function in self.pieces:
            inside = (wrapped >= start) & (wrapped <= end)
            value[inside] = function(wrapped[inside], order)
        return value

    def motion(self, theta):
        return [self(theta, k) for k in range(4)]

    def steps(self, order):
        """Jumps of a derivative between pieces and over the end of the cycle."""
        after = self.pieces[1:] + self.pieces[:1]
        return [float(b[2](np.array([b[0]]), order)[0]) - float(a[2](np.array([a[1]]), order)[0]) for a, b in zip(self.pieces, after)]

    def jumps(self, order):
        """Position and size of the largest jump of a derivative between pieces and over the end of the cycle."""
        worst, size = max(map(abs, self.steps(order))), 0.0
        for start, end, function in self.pieces:
            size = max(size, float(np.max(np.abs(function(np.linspace(start, end, 65), order)))))
        return worst, size

    def extreme(self, value, largest=True):
        """Maximum or minimum of a function of (theta, s, v, a, j) over the cycle, and its position."""
        sign = 1.0 if largest else -1.0
        starts = []
        for start, end, function in self.pieces:
            at = along(value, function, sign)
            grid = np.linspace(start, end, 385)
            values = at(grid)
            for i in np.argsort(values)[-2:]:
                starts.append((float(values[i]), float(grid[i]), float(grid[max(i - 1, 0)]), float(grid[min(i + 1, 384)]), at))
        starts.sort(key=lambda row: -row[0])
        best = starts[0][:2]
        for _, _, low, high, at in starts[:4]:
            peak = refine(at, low, high)
            best = max(best, (float(at(peak)[0]), peak))
        return sign * best[0], best[1]

    def mean(self, value):
        """Mean of a function of (theta, s, v, a, j) over the cycle, by Gaussian quadrature on each piece."""
        nodes, weights = np.polynomial.legendre.leggauss(24)
        total = 0.0
        for start, end, function in self.pieces:
            parts = max(1, math.ceil((end - start) / (self.end - self.start) * 24))
            edges = np.linspace(start, end, parts + 1)
            for low, high in zip(edges, edges[1:]):
                theta = (low + high) / 2 + (high - low) / 2 * nodes
                total += (high - low) / 2 * float(weights @ value(theta, *(function(theta, k) for k in range(4))))
        return total / (self.end - self.start)


def along(value, function, sign):
    """Function of the angle only, from a function of (theta, s, v, a, j) and the law of a piece."""

    def at(theta):
        theta = np.atleast_1d(np.asarray(theta, float))
        with np.errstate(all="ignore"):
            found = sign * value(theta, *(function(theta, k) for k in range(4)))
        return np.where(np.isnan(found), -np.inf, found)

    return at


def refine(at, low, high):
    """Position of the maximum between two positions, by golden-section search."""
    a, b = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
    fa, fb = float(at(a)[0]), float(at(b)[0])
    for _ in range(60):
        if fa > fb:
            high, b, fb = b, a, fa
            a = high - GOLDEN * (high - low)
            fa = float(at(a)[0])
        else:
            low, a, fa = a, b, fb
            b = low + GOLDEN * (high - low)
            fb = float(at(b)[0])
    return (low + high) / 2


def spline(knots, degree, coefficients):
    """Periodic spline. Coefficient i belongs to the B-spline on the knots t_i … t_(i+p+1)."""
    n, turn = len(knots), 2 * math.pi
    before = n * -(-(degree + 2) // n)  # whole turns with at least degree + 2 knots
    t = np.array([knots[i % n] + turn * (i // n) for i in range(-before, n + before)])
    c = np.array([coefficients[i % n] for i in range(-before, n + before)])
    derivatives = [(t, c, degree)]
    for _ in range(degree):
        t_, c_, p = derivatives[-1]
        new = np.zeros_like(c_)
        for i in range(1, len(c_)):
            if i + p < len(t_) and t_[i + p] > t_[i]:
                new[i] = p * (c_[i] - c_[i - 1]) / (t_[i + p] - t_[i])
        derivatives.append((t_, new, p - 1))
    pieces = []
    for m in range(before, before + n):
        low, high = t[m], t[m + 1]
        if high - low > 1e-12 and low >= -1e-12 and high <= turn + 1e-12:
            pieces.append((low, high, span(derivatives, m)))
    pieces.sort(key=lambda piece: piece[0])
    return Law(pieces)


def span(derivatives, m):
    """Polynomial of a spline between knots m and m + 1: its Taylor series about the middle, by de Boor's recursion."""
    t = derivatives[0][0]
    middle = (t[m] + t[m + 1]) / 2
    taylor = np.polynomial.Polynomial([de_boor(*row, m, middle) / math.factorial(k) for k, row in enumerate(derivatives)])
    orders = [taylor.deriv(k) if k else taylor for k in range(4)]
    return lambda theta, order: orders[order](theta - middle)


def de_boor(t, c, p, m, theta):
    """Value at theta of the spline of degree p with knots t and coefficients c, between knots m and m + 1."""
    d = [c[m - p + j] for j in range(p + 1)]
    for r in range(1, p + 1):
        for j in range(p, r - 1, -1):
            i = m - p + j
            alpha = (theta - t[i]) / (t[i + p - r + 1] - t[i])
            d[j] = (1 - alpha) * d[j - 1] + alpha * d[j]
    return d[p]


def fourier(coefficients):
    """Basis 1, cos θ, sin θ, cos 2θ, sin 2θ …"""

    def function(theta, order):
        value = np.full_like(theta, coefficients[0] if order == 0 else 0.0)
        for i in range(1, (len(coefficients) + 1) // 2):
            cos, sin = coefficients[2 * i - 1], coefficients[2 * i]
            turned = i * theta + order * math.pi / 2
            value = value + i**order * (cos * np.cos(turned) + sin * np.sin(turned))
        return value

    parts = max(8, len(coefficients))
    edges = np.linspace(0, 2 * math.pi, parts + 1)
    return Law([(low, high, function) for low, high in zip(edges, edges[1:])])


def monomial(span_rad, coefficients):
    """Polynomial in powers of u on a range. The law is at rest outside."""
    low, high = span_rad
    powers = np.polynomial.Polynomial(coefficients)

    def moving(theta, order):
        return powers.deriv(order)((theta - low) / (high - low)) / (high - low) ** order if order else powers((theta - low) / (high - low))

    def resting(theta, order):
        return np.full_like(theta, float(powers(1.0)) if order == 0 else 0.0)

    pieces = [(low, high, moving)]
    if low > 1e-12:
        pieces.insert(0, (0.0, low, resting))
    if high < 2 * math.pi - 1e-12:
        pieces.append((high, 2 * math.pi, resting))
    return Law(pieces)


# --- motions of a programme on 0 … 1: acceleration in closed form, or polynomial -----------------

def polynomial(*pairs):
    powers = [0.0] * (max(p for p, _ in pairs) + 1)
    for power, factor in pairs:
        powers[power] = factor
    whole = np.polynomial.Polynomial(powers)
    return lambda x, k: whole.deriv(k)(x) if k else whole(x)


def sines(linear, *terms, constant=0.0):
    """Function constant + linear x + Σ factor sin(frequency x + phase)."""

    def function(x, k):
        value = constant + linear * x if k == 0 else np.full_like(x, linear if k == 1 else 0.0)
        for factor, frequency, phase in terms:
            value = value + factor * frequency**k * np.sin(frequency * x + phase + k * math.pi / 2)
        return value

    return function


def joined(*pieces):
    """Function on 0 … 1 composed of pieces: (end, function)."""
    edges = [0.0] + [end for end, _ in pieces]
    return [(low, high, function) for low, high, (_, function) in zip(edges, edges[1:], pieces)]


def scca(b, c, d):
    """Law of sine, constant and cosine acceleration. The peak is chosen for a lift of 1."""
    pi = math.pi
    edges = [0.0, b / 2, (1 - d) / 2, (1 + d) / 2, 1 - b / 2, 1.0]
    shapes = []
    if b > 0:
        shapes.append((edges[0], edges[1], (math.sin, pi / b, 0.0)))
    if edges[2] > edges[1]:
        shapes.append((edges[1], edges[2], 1.0))
    if d > 0:
        shapes.append((edges[2], edges[3], (math.cos, pi / d, edges[2])))
    if edges[4] > edges[3]:
        shapes.append((edges[3], edges[4], -1.0))
    if b > 0:
        shapes.append((edges[4], edges[5], (lambda u: -math.cos(u), pi / b, edges[4])))
    # Integrate twice in closed form, piece by piece, with continuous velocity and lift.
    pieces, speed, lift = [], 0.0, 0.0
    for low, high, shape in shapes:
        if isinstance(shape, float):
            function = constant_acceleration(low, shape, speed, lift)
        else:
            which, rate, origin = shape
            phase = {math.sin: 0.0, math.cos: pi / 2}.get(which)
            phase = 3 * pi / 2 if phase is None else phase
            function = sine_acceleration(low, rate, origin, phase, speed, lift)
        pieces.append((low, high, function))
        end = np.array([high])
        lift, speed = float(function(end, 0)[0]), float(function(end, 1)[0])
    return [(low, high, lambda x, k, f=f: f(x, k) / lift) for low, high, f in pieces]


def constant_acceleration(low, value, speed, lift):
    def function(x, k):
        u = x - low
        return [lift + speed * u + value * u * u / 2, speed + value * u, np.full_like(u, value), np.zeros_like(u)][k]
    return function


def sine_acceleration(low, rate, origin, phase, speed, lift):
    """Acceleration sin(rate (x − origin) + phase)."""
    def function(x, k):
        angle, begin = rate * (x - origin) + phase, rate * (low - origin) + phase
        if k == 3:
            return rate * np.cos(angle)
        if k == 2:
            return np.sin(angle)
        slope = math.cos(begin) / rate
        if k == 1:
            return speed + slope - np.cos(angle) / rate
        return lift + (speed + slope) * (x - low) - (np.sin(angle) - math.sin(begin)) / rate**2
    return function


PI = math.pi
ALPHA = 1125 / 1192
MOTIONS = {
    "constant-velocity": polynomial((1, 1.0)),
    "parabolic": joined((0.5, polynomial((2, 2.0))), (1.0, polynomial((0, -1.0), (1, 4.0), (2, -2.0)))),
    "cubic": polynomial((2, 3.0), (3, -2.0)),
    "simple-harmonic": sines(0.0, (-0.5, PI, PI / 2), constant=0.5),
    "eccentric": sines(0.0, (-0.5, PI, PI / 2), constant=0.5),
    "double-harmonic": sines(0.0, (-0.5, PI, PI / 2), (0.125, 2 * PI, PI / 2), constant=0.375),
    "cycloidal": sines(1.0, (-1 / (2 * PI), 2 * PI, 0.0)),
    "semiharmonic-start": sines(0.0, (-1.0, PI / 2, PI / 2), constant=1.0),
    "semiharmonic-end": sines(0.0, (1.0, PI / 2, 0.0)),
    "semicycloidal-start": sines(1.0, (-1 / PI, PI, 0.0)),
    "semicycloidal-end": sines(1.0, (1 / PI, PI, 0.0)),
    "3-4-5": polynomial((3, 10.0), (4, -15.0), (5, 6.0)),
    "4-5-6-7": polynomial((4, 35.0), (5, -84.0), (6, 70.0), (7, -20.0)),
    "5-6-7-8-9": polynomial((5, 126.0), (6, -420.0), (7, 540.0), (8, -315.0), (9, 70.0)),
    "berzak-d": polynomial((3, 12.1), (4, -25.5), (5, 24.9), (6, -14.7), (7, 4.2)),
    "gutman-1-3": sines(1.0, (-15 / (32 * PI), 2 * PI, 0.0), (-1 / (96 * PI), 6 * PI, 0.0)),
    "freudenstein-1-3": sines(1.0, (-27 / (56 * PI), 2 * PI, 0.0), (-27 / (56 * 54 * PI), 6 * PI, 0.0)),
    "freudenstein-1-3-at-rest": sines(1.0, (-27 / (56 * PI), 2 * PI, 0.0), (-27 / (56 * 81 * PI), 6 * PI, 0.0)),
    "freudenstein-1-3-5": sines(1.0, (-ALPHA / (2 * PI), 2 * PI, 0.0), (-ALPHA / (108 * PI), 6 * PI, 0.0), (-ALPHA / (2500 * PI), 10 * PI, 0.0)),
    "modified-trapezoid": scca(0.25, 0.5, 0.25),
    "modified-sine": scca(0.25, 0.0, 0.75),
    "scca": scca(0.25, 0.25, 0.5),
    "dwell": polynomial((0, 0.0)),
}
# The fall of these motions is the rise mirrored in x; the fall of all others is the rise with the opposite sign.
MIRRORED = {"double-harmonic", "eccentric"}


def programme(segments, start=0.0):
    """Law of segments (motion, change of lift, length) whose lowest point has lift 0."""
    pieces, theta, lift = [], start, 0.0
    for motion, change, length in segments:
        shape = MOTIONS[motion]
        parts = shape if isinstance(shape, list) else [(0.0, 1.0, shape)]
        mirrored = change < 0 and motion in MIRRORED
        if mirrored:
            parts = [(1 - high, 1 - low, f) for low, high, f in reversed(parts)]
        for low, high, f in parts:
            pieces.append((theta + low * length, theta + high * length, segment(f, theta, length, lift, change, mirrored)))
        theta, lift = theta + length, lift + change
    lowest = min(float(np.min(f(np.linspace(a, b, 257), 0))) for a, b, f in pieces)
    raised = [(a, b, lambda x, k, f=f: f(x, k) - (lowest if k == 0 else 0.0)) for a, b, f in pieces]
    return Law(raised)


def double_harmonic(level, lift, start, rise, fall):
    """Rise, fall and dwell over one turn that begins at a given angle. The fall is the mirror image of the rise."""
    turn = 2 * math.pi
    hump = [("double-harmonic", 1.0, rise), ("double-harmonic", -1.0, fall)]
    rest = turn - rise - fall
    pieces = []
    for low, high, f in programme(hump + ([("dwell", 0.0, rest)] if rest > 1e-9 else []), start).pieces:
        for back in (0.0, turn):
            a, b = max(low - back, 0.0), min(high - back, turn)
            if b - a > 1e-12:
                pieces.append((a, b, lambda x, k, f=f, back=back: lift * f(x + back, k) + (level if k == 0 else 0.0)))
    return Law(sorted(pieces, key=lambda piece: piece[0]))


def segment(shape, theta, length, lift, change, mirrored):
    def function(x, k):
        u = (x - theta) / length
        if mirrored:
            value = (1.0 if k == 0 else 0.0) - (-1) ** k * shape(1 - u, k)
        else:
            value = shape(u, k)
        return (lift if k == 0 else 0.0) + change * value / length**k
    return function
