//! Contact forces and sliding for every follower, by virtual work.
//!
//! The follower has one freedom s, the cam one, θ. With the contact's unit normal n (towards the
//! follower) and G = ∂P/∂s, the velocity of the follower's own point there, a force N n and a friction
//! μ|N| along the rubbing give the force on that freedom Q = N n·G + μ|N| t·G; the shaft gives
//! T = (N n + μ|N| t)·U, U the velocity of the cam's own point per unit of θ. Without friction that is
//! T = Q·v. For an arm Q is the moment about its pivot, N·m, and v is in rad/rad; for a slide T is the
//! push along its travel, N.

use crate::cam::{Cam, Contact, Follower, Geometry};
use crate::law::Svaj;

/// The contact at one cam angle.
///
/// ```
/// use gaitcam::cam::Follower;
/// use gaitcam::dynamics::touch;
/// use gaitcam::law::Svaj;
///
/// // At rest on the base circle a face rubs at ω·Rb, and the force stands normal to it.
/// let at = Svaj { s: 0.0, v: 0.0, a: 0.0, j: 0.0 };
/// let found = touch(&Follower::FlatTranslating { base_radius: 0.03 }, 10.0, 0.0, at, 100.0);
/// assert!((found.normal - 100.0).abs() < 1e-12 && (found.sliding.abs() - 0.3).abs() < 1e-12);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Touch {
    /// Force normal to the surfaces, N.
    pub normal: f64,
    /// Sliding speed of the cam on the follower, m/s; 0 for a roller.
    pub sliding: f64,
    /// Mean speed of both surfaces relative to the contact (entraining speed), m/s.
    pub entraining: f64,
    /// Thrust across the guides, or along an arm towards its pivot, N.
    pub side_thrust: f64,
    /// Moment that tips a flat face about the guide's line through the cam's centre, N·m.
    pub tipping: f64,
    /// Torque of the shaft in the sense of growing θ, N·m (the push on a slide, N).
    pub torque: f64,
    /// Curvature of cam and follower together, 1/m.
    pub curvature: f64,
}

/// A follower with what does not change along its motion.
///
/// ```
/// use gaitcam::cam::Follower;
/// use gaitcam::dynamics::FollowerContact;
/// use gaitcam::law::Svaj;
///
/// // Without friction the torque is F·v.
/// let contact = FollowerContact::of(&Follower::FlatTranslating { base_radius: 0.03 });
/// let at = Svaj { s: 0.01, v: 0.02, a: 0.0, j: 0.0 };
/// assert_eq!(contact.torque(0.0, at, 100.0), 2.0);
/// // Friction acts at the height of the face.
/// assert!((contact.torque(0.1, at, 100.0) - 2.0 - 0.1 * 100.0 * 0.04).abs() < 1e-12);
/// ```
#[derive(Debug, Clone, Copy)]
pub struct FollowerContact {
    geometry: Geometry,
    pivot: Option<[f64; 2]>,
    /// +1 for a pivot on +x, −1 on −x.
    side: f64,
    /// Angle of the arm at s = 0.
    start: Option<f64>,
    is_flat: bool,
    /// Whether the surfaces rub.
    rubs: bool,
}

/// Forces at one contact.
struct Forces {
    normal: f64,
    /// Velocity along the tangent of the cam's point relative to the follower's, per unit of θ.
    rubbing: f64,
    /// Force on the follower.
    total: [f64; 2],
    torque: f64,
}

impl FollowerContact {
    /// The contact of a follower.
    pub fn of(follower: &Follower) -> FollowerContact {
        let pivot = follower.pivot();
        FollowerContact {
            geometry: Geometry::new(follower),
            pivot,
            side: pivot.map_or(1.0, |p| p[0].signum()),
            start: follower.start_angle(),
            is_flat: follower.is_flat(),
            rubs: rubs(follower),
        }
    }

    /// Torque of the shaft in the sense of growing θ, N·m, at one point of the motion, under `force` on the follower's
    /// freedom; friction is negative where the cam turns backwards.
    #[inline]
    pub fn torque(&self, friction: f64, at: Svaj, force: f64) -> f64 {
        if friction == 0.0 || !self.rubs {
            return force * at.v;
        }
        self.forces(&self.geometry.contact(at), friction, at, force)
            .torque
    }

    /// The contact at one point of the motion, the cam turning at `speed` rad/s.
    pub fn at(&self, speed: f64, friction: f64, at: Svaj, force: f64) -> Touch {
        let contact = self.geometry.contact(at);
        let Forces {
            normal,
            rubbing,
            total,
            torque,
        } = self.forces(&contact, friction, at, force);
        let rubbing = if self.rubs { rubbing } else { 0.0 };
        let across = match self.start {
            Some(start) => {
                let (sin, cos) = (start + at.s).sin_cos();
                [-self.side * cos, sin]
            }
            None => [1.0, 0.0],
        };
        let (walk, curvature) = self.walk(&contact, at);
        let is_slide = self.is_flat && self.pivot.is_none();
        Touch {
            normal,
            sliding: speed * rubbing,
            entraining: speed * (walk - 0.5 * rubbing),
            side_thrust: -dot(total, across),
            tipping: if is_slide { force * at.v } else { 0.0 },
            torque,
            curvature,
        }
    }

    /// A roller's own friction is in its bearing and is left out. Where friction locks the follower the normal force is
    /// infinite.
    #[inline]
    fn forces(&self, contact: &Contact, friction: f64, at: Svaj, force: f64) -> Forces {
        let (n, g) = (contact.normal, self.of_follower(contact.point));
        let cam = self.of_cam(contact.point);
        let tangent = [-n[1], n[0]];
        let relative = [cam[0] - at.v * g[0], cam[1] - at.v * g[1]];
        let rubbing = dot(relative, tangent);
        let mu = if self.rubs { friction } else { 0.0 };
        let drag = mu * rubbing.signum();
        // Under a negative force of the rigid model friction still opposes the sliding.
        let pressed = dot(n, g) + force.signum() * drag * dot(tangent, g);
        let normal = if force == 0.0 {
            0.0
        } else if pressed > 0.0 {
            force / pressed
        } else {
            f64::INFINITY.copysign(force)
        };
        let rub = drag * normal.abs();
        let total = [
            normal * n[0] + rub * tangent[0],
            normal * n[1] + rub * tangent[1],
        ];
        let torque = if mu == 0.0 {
            force * at.v
        } else {
            dot(total, cam)
        };
        Forces {
            normal,
            rubbing,
            total,
            torque,
        }
    }

    /// Velocity of the follower's point per unit of s.
    #[inline]
    fn of_follower(&self, point: [f64; 2]) -> [f64; 2] {
        match self.pivot {
            Some(c) => [
                self.side * (point[1] - c[1]),
                -self.side * (point[0] - c[0]),
            ],
            None => [0.0, 1.0],
        }
    }

    /// Velocity of the cam's point per unit of θ.
    #[inline]
    fn of_cam(&self, point: [f64; 2]) -> [f64; 2] {
        match self.geometry.straight() {
            Some(scale) => [-scale, 0.0],
            None => [-point[1], point[0]],
        }
    }

    /// Length of profile that the contact walks per unit of θ, signed, and the curvature of cam and follower together, 1/m.
    fn walk(&self, contact: &Contact, at: Svaj) -> (f64, f64) {
        if self.is_flat {
            // A face on an arm turns with it against the cam.
            let turning = 1.0 + self.pivot.map_or(0.0, |_| self.side * at.v);
            return (contact.rho * turning, 1.0 / contact.rho);
        }
        // The circle's centre moves along the pitch curve.
        let (own, cam) = (self.of_follower(contact.pitch), self.of_cam(contact.pitch));
        let length = (at.v * own[0] - cam[0]).hypot(at.v * own[1] - cam[1]);
        let radius = self.geometry.radius();
        let inner = 1.0 - radius * self.geometry.pitch_curvature(at);
        // 1/(1/κ − R) + 1/R = 1/(R·(1 − κR)).
        (length * inner, 1.0 / (radius * inner))
    }
}

/// The contact at one point of the motion of `follower`, under `force` on the follower's freedom (N; for
/// an arm the moment about its pivot, N·m), the cam turning at `speed` rad/s; backwards speed and friction
/// are negative.
pub fn touch(follower: &Follower, speed: f64, friction: f64, at: Svaj, force: f64) -> Touch {
    FollowerContact::of(follower).at(speed, friction, at, force)
}

/// Whether the cam slides on the follower; a roller rolls.
pub fn rubs(follower: &Follower) -> bool {
    follower.is_flat() || follower.kind().is_mushroom() || follower.roller_radius() == 0.0
}

/// Whether the follower is held from both sides and cannot lift off: the groove of a barrel, or a conjugate
/// pair.
pub fn held(cam: &Cam, conjugate: Option<&Cam>) -> bool {
    conjugate.is_some() || matches!(cam.follower, Follower::Barrel { .. })
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

#[cfg(test)]
pub(in crate::dynamics) mod tests;
