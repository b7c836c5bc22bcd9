//! Where cam and follower touch, seen in the frame fixed in space.
//!
//! Followers with a circle (roller, knife edge, mushroom): with the circle's centre C(θ), the pitch curve
//! in the cam's frame is R(−θ)·C. Its tangent, still seen in the fixed frame, is t = C′ − J·C and t's
//! derivative C″ − 2J·C′ − C, J the quarter turn. Traversed clockwise, its curvature is −det(t, t′)/|t|³,
//! positive where convex; the cam is its inner parallel at the circle's radius.
//!
//! Flat faces: the face with outward normal n at angle ψ stands p from the cam's centre; the cam is the
//! envelope p·n + (dp/dψ)·n⊥ with radius of curvature p + d²p/dψ².

mod arc_tangent;
mod fit;
mod shape;
mod space;

use super::Follower;
use crate::law::{BATCH, Batch, Svaj};
use arc_tangent::arc_tangent;

/// What is known of one contact, fixed frame; lengths in m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Contact {
    /// Contact point.
    pub point: [f64; 2],
    /// Centre of the circle; the contact point itself for a flat face.
    pub pitch: [f64; 2],
    /// Signed radius of curvature of the cam.
    pub rho: f64,
    /// tan of the signed pressure angle: the push leans by φ from the motion of the follower's point there,
    /// counter-clockwise positive.
    pub tan_pressure: f64,
}

/// A follower with everything that does not change with θ worked out.
#[derive(Debug, Clone, Copy)]
pub(super) enum Geometry {
    Flat {
        base: f64,
    },
    FlatArm {
        pivot: f64,
        /// +1 for a pivot on +x, −1 on −x.
        side: f64,
        offset: f64,
        start: f64,
    },
    Circle {
        rise: f64,
        offset: f64,
        radius: f64,
    },
    Arm {
        pivot: f64,
        side: f64,
        arm: f64,
        start: f64,
        radius: f64,
    },
    /// Translating cam (scale 1) and unrolled barrel (scale = its radius): pitch curve (scale·θ, base + s).
    Unrolled {
        scale: f64,
        base: f64,
        radius: f64,
    },
}

impl Geometry {
    pub fn new(follower: &Follower) -> Self {
        let start = follower.start_angle().unwrap_or(0.0);
        let radius = follower.roller_radius();
        match *follower {
            Follower::FlatTranslating { base_radius } => Geometry::Flat { base: base_radius },
            Follower::FlatOscillating {
                pivot_distance,
                face_offset,
                ..
            } => Geometry::FlatArm {
                pivot: pivot_distance.abs(),
                side: pivot_distance.signum(),
                offset: face_offset,
                start,
            },
            Follower::RollerTranslating { offset, .. }
            | Follower::MushroomTranslating { offset, .. } => Geometry::Circle {
                rise: follower.start_height(),
                offset,
                radius,
            },
            Follower::RollerOscillating {
                pivot_distance,
                arm,
                ..
            }
            | Follower::MushroomOscillating {
                pivot_distance,
                arm,
                ..
            } => Geometry::Arm {
                pivot: pivot_distance.abs(),
                side: pivot_distance.signum(),
                arm,
                start,
                radius,
            },
            Follower::TranslatingCam { base_height, .. } => Geometry::Unrolled {
                scale: 1.0,
                base: base_height + radius,
                radius,
            },
            Follower::Barrel { radius: scale, .. } => Geometry::Unrolled {
                scale,
                base: 0.0,
                radius,
            },
        }
    }

    /// How far the cam's frame moves per unit of θ where it moves straight; `None` where it turns.
    pub fn straight(&self) -> Option<f64> {
        match *self {
            Geometry::Unrolled { scale, .. } => Some(scale),
            _ => None,
        }
    }

    /// The contact at one instant.
    pub fn contact(&self, at: Svaj) -> Contact {
        match *self {
            Geometry::Flat { base } => flat([at.s, at.v, at.a], base),
            Geometry::FlatArm {
                pivot,
                side,
                offset,
                start,
            } => {
                let turn = (start + at.s).sin_cos();
                flat_arm([at.v, at.a], turn, pivot, side, offset)
            }
            Geometry::Circle {
                rise,
                offset,
                radius,
            } => circle([at.s, at.v, at.a], rise, offset, radius),
            Geometry::Arm {
                pivot,
                side,
                arm,
                start,
                radius,
            } => {
                let turn = (start + at.s).sin_cos();
                on_arm([at.v, at.a], turn, pivot, side, arm, radius)
            }
            Geometry::Unrolled {
                scale,
                base,
                radius,
            } => unrolled([at.s, at.v, at.a], scale, base, radius),
        }
    }

    /// The contacts of a whole batch: the same formulae, in loops that the compiler runs side by side.
    #[inline(always)]
    pub fn contacts(&self, batch: &Batch, out: &mut Contacts) {
        if batch.at_rest {
            out.fill(self.contact(Svaj {
                s: batch.s[0],
                ..Svaj::default()
            }));
            return;
        }
        let (s, v, a) = (&batch.s, &batch.v, &batch.a);
        match *self {
            Geometry::Flat { base } => {
                for k in 0..BATCH {
                    out.set(k, flat([s[k], v[k], a[k]], base));
                }
            }
            Geometry::FlatArm {
                pivot,
                side,
                offset,
                start,
            } => {
                let turns = turns(batch, start);
                for k in 0..BATCH {
                    let turn = (turns[0][k], turns[1][k]);
                    out.set(k, flat_arm([v[k], a[k]], turn, pivot, side, offset));
                }
            }
            Geometry::Circle {
                rise,
                offset,
                radius,
            } => {
                for k in 0..BATCH {
                    out.set(k, circle([s[k], v[k], a[k]], rise, offset, radius));
                }
            }
            Geometry::Arm {
                pivot,
                side,
                arm,
                start,
                radius,
            } => {
                let turns = turns(batch, start);
                for k in 0..BATCH {
                    let turn = (turns[0][k], turns[1][k]);
                    out.set(k, on_arm([v[k], a[k]], turn, pivot, side, arm, radius));
                }
            }
            Geometry::Unrolled {
                scale,
                base,
                radius,
            } => {
                for k in 0..BATCH {
                    out.set(k, unrolled([s[k], v[k], a[k]], scale, base, radius));
                }
            }
        }
        if !matches!(self, Geometry::Flat { .. }) {
            for tan in &mut out.pressure_angle {
                *tan = arc_tangent(*tan);
            }
        }
    }

    /// Signed curvature of the pitch curve, 1/m: finite where its radius is not.
    pub fn pitch_curvature(&self, at: Svaj) -> f64 {
        match *self {
            Geometry::Unrolled { scale, .. } => {
                let slope = at.v / scale;
                let square = 1.0 + slope * slope;
                -at.a / (scale * scale * square * square.sqrt())
            }
            _ => 1.0 / (self.contact(at).rho + self.radius()),
        }
    }

    /// Radius of the roller or arc.
    pub fn radius(&self) -> f64 {
        match *self {
            Geometry::Flat { .. } | Geometry::FlatArm { .. } => 0.0,
            Geometry::Circle { radius, .. }
            | Geometry::Arm { radius, .. }
            | Geometry::Unrolled { radius, .. } => radius,
        }
    }

    /// Place of the contact on the follower, m: along a flat face from the foot of the cam's centre
    /// (translating) or of the pivot (oscillating); along a mushroom's chord from the arc's middle.
    pub fn travel(&self, at: Svaj) -> f64 {
        match *self {
            Geometry::Flat { .. } => at.v,
            Geometry::FlatArm {
                pivot, side, start, ..
            } => pivot * (start + at.s).cos() / (1.0 + side * at.v),
            _ => {
                let tan = self.contact(at).tan_pressure;
                self.radius() * tan / (1.0 + tan * tan).sqrt()
            }
        }
    }
}

/// Contacts of a batch, field by field; entries beyond the batch's length mean nothing.
pub(super) struct Contacts {
    pub x: [f64; BATCH],
    pub y: [f64; BATCH],
    pub pitch_x: [f64; BATCH],
    pub pitch_y: [f64; BATCH],
    pub rho: [f64; BATCH],
    /// Signed, rad.
    pub pressure_angle: [f64; BATCH],
}

impl Contacts {
    pub fn new() -> Self {
        Contacts {
            x: [0.0; BATCH],
            y: [0.0; BATCH],
            pitch_x: [0.0; BATCH],
            pitch_y: [0.0; BATCH],
            rho: [0.0; BATCH],
            pressure_angle: [0.0; BATCH],
        }
    }

    /// Writes contact `k`, the tangent in place of its angle.
    #[inline(always)]
    fn set(&mut self, k: usize, c: Contact) {
        self.x[k] = c.point[0];
        self.y[k] = c.point[1];
        self.pitch_x[k] = c.pitch[0];
        self.pitch_y[k] = c.pitch[1];
        self.rho[k] = c.rho;
        self.pressure_angle[k] = c.tan_pressure;
    }

    /// One contact for all.
    #[inline(always)]
    fn fill(&mut self, c: Contact) {
        self.x.fill(c.point[0]);
        self.y.fill(c.point[1]);
        self.pitch_x.fill(c.pitch[0]);
        self.pitch_y.fill(c.pitch[1]);
        self.rho.fill(c.rho);
        self.pressure_angle.fill(arc_tangent(c.tan_pressure));
    }
}

/// sin ξ and cos ξ of a batch; a dwell asks once.
#[inline(always)]
fn turns(batch: &Batch, start: f64) -> [[f64; BATCH]; 2] {
    let mut out = [[0.0; BATCH]; 2];
    let mut known = (f64::NAN, (0.0, 1.0));
    for (k, s) in batch.s[..batch.len].iter().enumerate() {
        let angle = start + s;
        if angle != known.0 {
            known = (angle, angle.sin_cos());
        }
        (out[0][k], out[1][k]) = known.1;
    }
    out
}

#[inline(always)]
fn flat([s, v, a]: [f64; 3], base: f64) -> Contact {
    let point = [v, base + s];
    Contact {
        point,
        pitch: point,
        rho: base + s + a,
        tan_pressure: 0.0,
    }
}

/// Circle on a slide: C = (e, D + s), so t = (D + s, v − e) and t′ = (2v − e, a − D − s).
#[inline(always)]
fn circle([s, v, a]: [f64; 3], rise: f64, offset: f64, radius: f64) -> Contact {
    let (x, y) = (rise + s, v - offset);
    let square = x * x + y * y;
    let length = square.sqrt();
    let bend = y * (2.0 * v - offset) - x * (a - x);
    let unit = radius / length;
    Contact {
        point: [offset + y * unit, x - x * unit],
        pitch: [offset, x],
        rho: square * length / bend - radius,
        tan_pressure: y / x,
    }
}

/// Circle over an unrolled cam: pitch curve (scale·θ, base + s).
#[inline(always)]
fn unrolled([s, v, a]: [f64; 3], scale: f64, base: f64, radius: f64) -> Contact {
    let slope = v / scale;
    let square = 1.0 + slope * slope;
    let length = square.sqrt();
    let unit = radius / length;
    let height = base + s;
    let rho = -square * length * scale * scale / a - radius;
    Contact {
        point: [slope * unit, height - unit],
        pitch: [0.0, height],
        rho: if a == 0.0 { f64::INFINITY } else { rho },
        tan_pressure: slope,
    }
}

/// Oscillating flat face: n = (σ sin ξ, cos ξ) at ψ = π/2 − σξ − θ, p = f + c sin ξ.
#[inline(always)]
fn flat_arm(
    [v, a]: [f64; 2],
    (sin, cos): (f64, f64),
    pivot: f64,
    side: f64,
    offset: f64,
) -> Contact {
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
        rho,
        // From the foot of the pivot on the face the contact lies c cos ξ/(1 + σξ′) along it.
        tan_pressure: side * offset / (pivot * cos * speed) + 0.0,
    }
}

/// Circle on an arm: C = (σ(c − A cos ξ), A sin ξ).
#[inline(always)]
fn on_arm(
    [v, a]: [f64; 2],
    (sin, cos): (f64, f64),
    pivot: f64,
    side: f64,
    arm: f64,
    radius: f64,
) -> Contact {
    let (x, y) = (side * (pivot - arm * cos), arm * sin);
    let (x1, y1) = (side * arm * sin * v, arm * cos * v);
    let square_v = v * v;
    let x2 = side * arm * (cos * square_v + sin * a);
    let y2 = arm * (cos * a - sin * square_v);
    let t = [x1 + y, y1 - x];
    let rate = [x2 + 2.0 * y1 - x, y2 - 2.0 * x1 - y];
    let square = t[0] * t[0] + t[1] * t[1];
    let length = square.sqrt();
    let bend = t[1] * rate[0] - t[0] * rate[1];
    let unit = radius / length;
    // Motion (σ sin ξ, cos ξ) against the normal (−t₁, t₀).
    let push = t[0] * cos - side * t[1] * sin;
    let lean = side * t[0] * sin + t[1] * cos;
    Contact {
        point: [x + t[1] * unit, y - t[0] * unit],
        pitch: [x, y],
        rho: square * length / bend - radius,
        tan_pressure: lean / push,
    }
}
