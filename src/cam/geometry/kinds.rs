//! Contact formulas of each kind of follower.

use super::contact::Contact;
use crate::law::Svaj;

/// Contact formulas of a kind of follower.
pub trait Kind {
    /// Contact at a given lift, velocity and acceleration.
    fn contact(&self, motion: [f64; 3]) -> Contact;

    /// Velocities at a point of the fixed frame. The first is that of the follower per unit of lift, the second that of the cam per unit of
    /// θ.
    fn velocities(&self, point: [f64; 2]) -> [[f64; 2]; 2];
}

/// Velocity of a point of a rotating cam, per radian of rotation.
#[inline(always)]
fn turning([x, y]: [f64; 2]) -> [f64; 2] {
    [-y, x]
}

/// Velocity of a point of an arm with its pivot on the x axis, per radian of rotation.
#[inline(always)]
fn swinging([x, y]: [f64; 2], pivot: f64, side: f64) -> [f64; 2] {
    [side * y, -side * (x - side * pivot)]
}

/// Velocity of a translating follower, per metre of lift.
const SLIDING: [f64; 2] = [0.0, 1.0];

/// Contact of a translating flat face with a rotating cam.
#[derive(Debug, Clone, Copy)]
pub struct Flat {
    pub base: f64,
}

impl Kind for Flat {
    #[inline(always)]
    fn contact(&self, [s, v, a]: [f64; 3]) -> Contact {
        let height = self.base + s;
        let point = [v, height];
        Contact {
            point,
            pitch: point,
            normal: [0.0, 1.0],
            rho: height + a,
            tan_pressure: 0.0,
        }
    }

    #[inline(always)]
    fn velocities(&self, point: [f64; 2]) -> [[f64; 2]; 2] {
        [SLIDING, turning(point)]
    }
}

/// Contact of a circle on a translating follower. The centre is C = (e, D + s), so t = (D + s, v − e) and t′ = (2v − e, a − D − s) in the
/// notation of [`super`].
#[derive(Debug, Clone, Copy)]
pub struct Circle {
    /// Height D of the centre at s = 0, m.
    pub rise: f64,
    /// Offset e of the line of motion, m.
    pub offset: f64,
    pub radius: f64,
}

impl Kind for Circle {
    #[inline(always)]
    fn contact(&self, [s, v, a]: [f64; 3]) -> Contact {
        let (x, y) = (self.rise + s, v - self.offset);
        let square = x * x + y * y;
        let length = square.sqrt();
        let bend = y * (2.0 * v - self.offset) - x * (a - x);
        let unit = self.radius / length;
        Contact {
            point: [self.offset + y * unit, x - x * unit],
            pitch: [self.offset, x],
            normal: [-y / length, x / length],
            rho: square * length / bend - self.radius,
            tan_pressure: y / x,
        }
    }

    #[inline(always)]
    fn velocities(&self, point: [f64; 2]) -> [[f64; 2]; 2] {
        [SLIDING, turning(point)]
    }
}

/// Contact of a roller with a translating cam (scale 1) or an unrolled barrel. For a barrel, the scale is its radius, m. The pitch curve is
/// (scale·θ, base + s).
#[derive(Debug, Clone, Copy)]
pub struct Unrolled {
    pub scale: f64,
    pub base: f64,
    pub radius: f64,
}

impl Kind for Unrolled {
    #[inline(always)]
    fn contact(&self, [s, v, a]: [f64; 3]) -> Contact {
        let slope = v / self.scale;
        let square = 1.0 + slope * slope;
        let length = square.sqrt();
        let unit = self.radius / length;
        let height = self.base + s;
        let rho = -square * length * self.scale * self.scale / a - self.radius;
        Contact {
            point: [slope * unit, height - unit],
            pitch: [0.0, height],
            normal: [-slope / length, 1.0 / length],
            rho: if a == 0.0 { f64::INFINITY } else { rho },
            tan_pressure: slope,
        }
    }

    #[inline(always)]
    fn velocities(&self, _: [f64; 2]) -> [[f64; 2]; 2] {
        [SLIDING, [-self.scale, 0.0]]
    }
}

impl Unrolled {
    /// Signed curvature of the pitch curve, 1/m.
    pub fn pitch_curvature(&self, at: Svaj) -> f64 {
        let slope = at.v / self.scale;
        let square = 1.0 + slope * slope;
        -at.a / (self.scale * self.scale * square * square.sqrt())
    }
}

/// Contact of a flat face on an arm: n = (σ sin ξ, cos ξ) at ψ = π/2 − σξ − θ, p = f + c sin ξ in the notation of [`super`].
#[derive(Debug, Clone, Copy)]
pub struct FlatOnArm {
    /// Distance |c| of the pivot from the cam centre, m.
    pub pivot: f64,
    /// Sign σ of the x coordinate of the pivot, 1 or −1.
    pub side: f64,
    /// Offset f of the face from its parallel through the pivot, m.
    pub offset: f64,
    /// Arm angle ξ at s = 0, rad.
    pub start: f64,
}

impl Kind for FlatOnArm {
    #[inline(always)]
    fn contact(&self, [s, v, a]: [f64; 3]) -> Contact {
        let (pivot, side, offset) = (self.pivot, self.side, self.offset);
        let (sin, cos) = libm::sincos(self.start + s);
        let v = side * v;
        let speed = 1.0 / (1.0 + v);
        let p = offset + pivot * sin;
        // dp/dψ, along n⊥ = (−cos ξ, σ sin ξ).
        let along = -side * pivot * cos * v * speed;
        let rho = offset + pivot * (sin * (1.0 + 2.0 * v) + cos * a * speed) * speed * speed;
        let point = [side * p * sin - along * cos, p * cos + along * side * sin];
        Contact {
            point,
            pitch: point,
            normal: [side * sin, cos],
            rho,
            // The distance along the face from the foot of the perpendicular from the pivot to the contact is c cos ξ/(1 + σξ′).
            tan_pressure: side * offset / (pivot * cos * speed) + 0.0,
        }
    }

    #[inline(always)]
    fn velocities(&self, point: [f64; 2]) -> [[f64; 2]; 2] {
        [swinging(point, self.pivot, self.side), turning(point)]
    }
}

impl FlatOnArm {
    /// Position of the contact along the face, measured from the foot of the perpendicular from the pivot, m.
    pub fn travel(&self, at: Svaj) -> f64 {
        self.pivot * libm::cos(self.start + at.s) / (1.0 + self.side * at.v)
    }
}

/// Contact of a circle on an arm. The centre is C = (σ(c − A cos ξ), A sin ξ).
#[derive(Debug, Clone, Copy)]
pub struct CircleOnArm {
    /// Distance |c| of the pivot from the cam centre, m.
    pub pivot: f64,
    /// Sign σ of the x coordinate of the pivot, 1 or −1.
    pub side: f64,
    /// Length A of the arm, m.
    pub arm: f64,
    /// Arm angle ξ at s = 0, rad.
    pub start: f64,
    pub radius: f64,
}

impl Kind for CircleOnArm {
    #[inline(always)]
    fn contact(&self, [s, v, a]: [f64; 3]) -> Contact {
        let (side, arm) = (self.side, self.arm);
        let (sin, cos) = libm::sincos(self.start + s);
        let (x, y) = (side * (self.pivot - arm * cos), arm * sin);
        let (x1, y1) = (side * arm * sin * v, arm * cos * v);
        let square_v = v * v;
        let x2 = side * arm * (cos * square_v + sin * a);
        let y2 = arm * (cos * a - sin * square_v);
        let t = [x1 + y, y1 - x];
        let rate = [x2 + 2.0 * y1 - x, y2 - 2.0 * x1 - y];
        let square = t[0] * t[0] + t[1] * t[1];
        let length = square.sqrt();
        let bend = t[1] * rate[0] - t[0] * rate[1];
        let unit = self.radius / length;
        // Scalar product of the motion (σ sin ξ, cos ξ) and the normal (−t₁, t₀).
        let push = t[0] * cos - side * t[1] * sin;
        let lean = side * t[0] * sin + t[1] * cos;
        Contact {
            point: [x + t[1] * unit, y - t[0] * unit],
            pitch: [x, y],
            normal: [-t[1] / length, t[0] / length],
            rho: square * length / bend - self.radius,
            tan_pressure: lean / push,
        }
    }

    #[inline(always)]
    fn velocities(&self, point: [f64; 2]) -> [[f64; 2]; 2] {
        [swinging(point, self.pivot, self.side), turning(point)]
    }
}
