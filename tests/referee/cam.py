"""Geometry of the cam from the motion of its follower, in the fixed frame.

A point p of this frame is R(−θ)p in the frame of the cam with R(−θ) = [[cos θ, sin θ], [−sin θ, cos θ]]. With J p = (p_y, −p_x),
its derivative by θ on the cam is R(−θ)(p′ + J p). The normal n = J t / |t| to the tangent t of the pitch curve points away from
the centre of the cam if the curve is clockwise. The curvature is positive where the cam is convex.
"""

import math

import numpy as np


class Cam:
    """Cam with follower, sizes and law: contact, pitch point, radius of curvature and pressure angle at any angle."""

    def __init__(self, kind, law, size):
        self.kind, self.law, self.size = kind, law, size
        self.is_face = kind.startswith("flat")
        self.roller = size.get("roller", 0.0)

    def centre(self, s, v, a):
        """Roller centre with two derivatives, and the direction of its motion with the lift."""
        z = self.size
        if self.kind.endswith("-translating"):
            depth = math.sqrt(max(z["prime"] ** 2 - z["offset"] ** 2, 0.0))
            zero = np.zeros_like(s)
            return (zero + z["offset"], depth + s), (zero, v), (zero, a), (zero, zero + 1.0)
        arm, pivot = z["arm"], z["pivot"]
        side = math.copysign(1.0, pivot)
        xi = start_of_arm(z) + s
        x, y = pivot - side * arm * np.cos(xi), arm * np.sin(xi)
        dx, dy = side * arm * np.sin(xi), arm * np.cos(xi)
        ddx, ddy = side * arm * np.cos(xi), -arm * np.sin(xi)
        return (x, y), (dx * v, dy * v), (ddx * v * v + dx * a, ddy * v * v + dy * a), (side * np.sin(xi), np.cos(xi))

    def at(self, theta, s, v, a):
        """Contact and pitch point (fixed frame), radius of curvature of the cam and pressure angle."""
        z = self.size
        if self.kind == "flat-translating":
            point = (v, z["base"] + s)
            return point, point, z["base"] + s + a, np.zeros_like(s)
        if self.kind == "flat-oscillating":
            return self.arm_face(s, v, a)
        if self.kind == "translating-cam":
            return self.wedge(theta, s, v, a)
        if self.kind == "barrel":
            return self.groove(theta, s, v, a)
        p, p1, p2, up = self.centre(s, v, a)
        t = (p1[0] + p[1], p1[1] - p[0])
        t2 = (p2[0] + 2 * p1[1] - p[0], p2[1] - 2 * p1[0] - p[1])
        length = np.hypot(*t)
        outward = (-t[1] / length, t[0] / length)
        with np.errstate(divide="ignore"):
            pitch = -(length**3) / (t[0] * t2[1] - t[1] * t2[0])
        angle = np.arctan2(up[0] * outward[1] - up[1] * outward[0], up[0] * outward[0] + up[1] * outward[1])
        contact = (p[0] - self.roller * outward[0], p[1] - self.roller * outward[1])
        return contact, p, pitch - self.roller, angle

    def arm_face(self, s, v, a):
        z = self.size
        pivot, face = z["pivot"], z["face_offset"]
        side = math.copysign(1.0, pivot)
        xi = math.asin((z["base"] - face) / abs(pivot)) + s
        c = abs(pivot)
        # Support function h of the face over the angle of its normal, on the cam: dα/dθ = −(1 ± ξ′).
        rate = -(1.0 + side * v)
        h, h1 = face + c * np.sin(xi), c * np.cos(xi) * v
        h2 = -c * np.sin(xi) * v * v + c * np.cos(xi) * a
        slope = h1 / rate
        slope1 = h2 / rate - h1 * (-side * a) / rate**2
        normal = (side * np.sin(xi), np.cos(xi))
        along = (-normal[1], normal[0])
        point = (h * normal[0] + slope * along[0], h * normal[1] + slope * along[1])
        reach = (point[0] - pivot, point[1])
        push = (side * reach[1], -side * reach[0])
        angle = np.arctan2(push[0] * normal[1] - push[1] * normal[0], push[0] * normal[0] + push[1] * normal[1])
        return point, point, h + slope1 / rate, angle

    def wedge(self, x, s, v, a):
        pitch = (x, self.size["prime"] + s)
        length = np.hypot(1.0, v)
        outward = (-v / length, 1.0 / length)
        contact = (pitch[0] - self.roller * outward[0], pitch[1] - self.roller * outward[1])
        with np.errstate(divide="ignore"):
            rho = -(length**3) / a
        return contact, pitch, rho - self.roller, np.arctan(v)

    def groove(self, theta, s, v, a):
        """The unrolled groove at the radius of the barrel, and the roller on its lower wall."""
        radius = self.size["base"]
        out = self.size["eccentricity"]
        slope = v / radius
        phi = np.arctan(slope)
        pitch = (radius * theta, s - out)
        contact = (pitch[0] + self.roller * np.sin(phi), pitch[1] - self.roller * np.cos(phi))
        with np.errstate(divide="ignore"):
            rho = -(np.hypot(1.0, slope) ** 3) / (a / radius**2)
        return contact, pitch, rho - self.roller, phi

    def on_cam(self, point, theta):
        if self.kind in ("translating-cam", "barrel"):
            return point
        cos, sin = np.cos(theta), np.sin(theta)
        return cos * point[0] + sin * point[1], -sin * point[0] + cos * point[1]

    def normal_force_factor(self, theta, s, v, a):
        """Normal force per newton along the motion of the follower; for an arm, per newton at the end of the arm."""
        return 1.0 / np.cos(self.at(theta, s, v, a)[3])

    def lever(self, theta, s, v, a, friction):
        """Shaft torque per newton on the follower with Coulomb friction, for a pressing and for a pulling contact.

        The force on the follower at the contact is N n + μ|N| t, where t is the direction of motion of the cam surface. Its
        component along the velocity G acts on the follower, and its component along the velocity U of the cam on the shaft.
        """
        if friction == 0.0 or self.kind in ("translating-cam", "barrel") or self.kind.startswith("roller"):
            return v, v
        found = [cam / own for own, cam in self.shares(theta, s, v, a, friction)]
        return found[0], found[1]

    def normal_share(self, theta, s, v, a, friction):
        """Force along the motion of the follower per newton of normal force for a pressing contact, with friction."""
        return self.shares(theta, s, v, a, friction)[0][0]

    def shares(self, theta, s, v, a, friction):
        """Components of the contact force along the velocities of follower and cam, for a pressing and for a pulling contact."""
        contact, pitch, _, _ = self.at(theta, s, v, a)
        cam = (-contact[1], contact[0])
        if self.kind.endswith("-translating"):
            own = (np.zeros_like(s), np.ones_like(s))
        else:
            pivot, side = self.size["pivot"], math.copysign(1.0, self.size["pivot"])
            own = (side * contact[1], -side * (contact[0] - pivot))
        if self.kind == "flat-translating":
            normal = (np.zeros_like(s), np.ones_like(s))
        elif self.kind == "flat-oscillating":
            side = math.copysign(1.0, self.size["pivot"])
            xi = math.asin((self.size["base"] - self.size["face_offset"]) / abs(self.size["pivot"])) + s
            normal = (side * np.sin(xi), np.cos(xi))
        else:
            p, p1, _, _ = self.centre(s, v, a)
            t = (p1[0] + p[1], p1[1] - p[0])
            length = np.hypot(*t)
            normal = (-t[1] / length, t[0] / length)
        dot = lambda x, y: x[0] * y[0] + x[1] * y[1]
        along = (-normal[1], normal[0])
        slides = np.sign(dot(along, cam) - v * dot(along, own))
        found = []
        for sign in (1.0, -1.0):
            mu = sign * friction * slides
            found.append((dot(normal, own) + mu * dot(along, own), dot(normal, cam) + mu * dot(along, cam)))
        return found

    def curvature_sum(self, theta, s, v, a):
        """Curvature 1/R of cam and follower at the contact."""
        rho = self.at(theta, s, v, a)[2]
        with np.errstate(divide="ignore"):
            own = 1.0 / rho
        return own + (1.0 / self.roller if self.roller else 0.0)


def start_of_arm(size):
    """Angle of the arm on the prime circle."""
    arm, pivot = size["arm"], abs(size["pivot"])
    return math.acos((arm**2 + pivot**2 - size["prime"] ** 2) / (2 * arm * pivot))
