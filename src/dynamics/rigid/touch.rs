//! Contact forces and sliding for every follower, by virtual work.
//!
//! The follower has the coordinate s, and the cam has the coordinate θ. The unit normal n of the contact points towards the follower. G =
//! ∂P/∂s is the derivative of the position P of the follower's contact point with respect to s. U is the derivative of the position of the
//! cam's contact point with respect to θ. The contact force is the sum of a normal force N n and a friction force μ|N| t along the sliding
//! direction t. The force on the follower is Q = (N n + μ|N| t)·G. The shaft torque is T = (N n + μ|N| t)·U. Without friction T = Q·v. For
//! an arm, Q is the moment about its pivot, N·m, and v is in rad/rad. For a translating cam, T is the force along its travel, N.

use crate::cam::{Cam, Contact, Follower, Geometry, Kind};
use crate::law::Svaj;

/// Forces, velocities and curvature of the contact at one cam angle.
///
/// ```
/// use gaitcam::cam::Follower;
/// use gaitcam::dynamics::touch;
/// use gaitcam::law::Svaj;
///
/// // On the base circle, the face slides at the speed ω·Rb, and the normal force equals the force on the follower.
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
    /// Lateral force on the guides, or force along an arm towards its pivot, N.
    pub side_thrust: f64,
    /// Moment that tilts a translating flat face, N·m: the force multiplied by the distance of the contact from the line of the guide. It
    /// is 0 for other followers.
    pub tipping: f64,
    /// Torque of the shaft in the direction of increasing θ, N·m; for a translating cam the force along its travel, N.
    pub torque: f64,
    /// Sum of the curvatures of cam and follower, 1/m.
    pub curvature: f64,
}

/// Contact formulas of a follower, with constants that are computed once.
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
    /// Side of the pivot: +1 on +x, −1 on −x.
    side: f64,
    /// Angle of the arm at s = 0, rad.
    start: Option<f64>,
    is_flat: bool,
    /// Whether the surfaces slide on each other; false for a roller.
    rubs: bool,
}

/// Forces at one contact point.
struct Forces {
    normal: f64,
    /// Tangential velocity of the cam's contact point relative to the follower's contact point, per unit of θ.
    rubbing: f64,
    /// Total force of the cam on the follower (normal force and friction), fixed frame, N.
    total: [f64; 2],
    torque: f64,
}

/// Contact forces for one kind of follower.
trait Pressed: Kind {
    /// Contact and forces at one point of the motion, with friction between the surfaces. The normal force is infinite if friction locks the
    /// follower.
    fn forces(&self, friction: f64, at: Svaj, force: f64) -> (Contact, Forces);

    /// Torques at many points of the motion for given forces, in a loop that the compiler vectorises.
    fn torques(&self, friction: f64, motion: &[Svaj], forces: &[f64], torques: &mut [f64]);
}

impl<K: Kind> Pressed for K {
    #[inline(always)]
    fn forces(&self, friction: f64, at: Svaj, force: f64) -> (Contact, Forces) {
        let contact = self.contact([at.s, at.v, at.a]);
        let n = contact.normal;
        let tangent = [-n[1], n[0]];
        let [g, cam] = self.velocities(contact.point);
        let rubbing = dot([cam[0] - at.v * g[0], cam[1] - at.v * g[1]], tangent);
        let drag = friction * 1.0_f64.copysign(rubbing);
        // Under a negative force of the rigid model, friction also opposes the sliding.
        let pressed = dot(n, g) + drag * 1.0_f64.copysign(force) * dot(tangent, g);
        // Where friction locks the follower, the divisor is zero, and the normal force is infinite.
        let pressed = if pressed > 0.0 { pressed } else { 0.0 };
        let normal = if force == 0.0 { 0.0 } else { force / pressed };
        let rub = if drag == 0.0 {
            0.0
        } else {
            drag * normal.abs()
        };
        let total = [
            normal * n[0] + rub * tangent[0],
            normal * n[1] + rub * tangent[1],
        ];
        // Cam and follower have the same velocity along the normal, so only friction adds to F·v.
        let torque = force * at.v + rub * rubbing;
        let forces = Forces {
            normal,
            rubbing,
            total,
            torque,
        };
        (contact, forces)
    }

    fn torques(&self, friction: f64, motion: &[Svaj], forces: &[f64], torques: &mut [f64]) {
        for ((at, force), torque) in motion.iter().zip(forces).zip(torques) {
            *torque = self.forces(friction, *at, *force).1.torque;
        }
    }
}

impl FollowerContact {
    /// Prepares the contact formulas of a follower.
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

    fn kind(&self) -> &dyn Pressed {
        match &self.geometry {
            Geometry::Flat(kind) => kind,
            Geometry::FlatOnArm(kind) => kind,
            Geometry::Circle(kind) => kind,
            Geometry::CircleOnArm(kind) => kind,
            Geometry::Unrolled(kind) => kind,
        }
    }

    /// Torque of the shaft in the direction of increasing θ, N·m, at one point of the motion, for `force` on the follower. `friction` is negative if
    /// the cam turns backwards.
    pub fn torque(&self, friction: f64, at: Svaj, force: f64) -> f64 {
        let mut torque = [0.0];
        self.fill(friction, &[at], &[force], &mut torque);
        torque[0]
    }

    /// Computes [`FollowerContact::torque`] at many points of the motion, each with its force.
    pub fn torques(&self, friction: f64, motion: &[Svaj], forces: &[f64]) -> Vec<f64> {
        let mut torques = vec![0.0; motion.len().min(forces.len())];
        self.fill(friction, motion, forces, &mut torques);
        torques
    }

    fn fill(&self, friction: f64, motion: &[Svaj], forces: &[f64], torques: &mut [f64]) {
        if friction != 0.0 && self.rubs {
            return self.kind().torques(friction, motion, forces, torques);
        }
        for ((at, force), torque) in motion.iter().zip(forces).zip(torques) {
            *torque = force * at.v;
        }
    }

    /// Contact at one point of the motion, for `force` on the follower and the cam speed `speed`, rad/s.
    pub fn at(&self, speed: f64, friction: f64, at: Svaj, force: f64) -> Touch {
        // The friction of a roller acts in its bearing and is neglected.
        let friction = if self.rubs { friction } else { 0.0 };
        let (contact, forces) = self.kind().forces(friction, at, force);
        let rubbing = if self.rubs { forces.rubbing } else { 0.0 };
        let across = match self.start {
            Some(start) => {
                let (sin, cos) = libm::sincos(start + at.s);
                [-self.side * cos, sin]
            }
            None => [1.0, 0.0],
        };
        let (walk, curvature) = self.walk(&contact, at);
        let is_slide = self.is_flat && self.pivot.is_none();
        Touch {
            normal: forces.normal,
            sliding: speed * rubbing,
            entraining: speed * (walk - 0.5 * rubbing),
            side_thrust: -dot(forces.total, across),
            tipping: if is_slide { force * at.v } else { 0.0 },
            torque: forces.torque,
            curvature,
        }
    }

    /// Signed speed of the contact along the profile per unit of θ, m/rad, and sum of the curvatures of cam and follower, 1/m.
    fn walk(&self, contact: &Contact, at: Svaj) -> (f64, f64) {
        if self.is_flat {
            // The face turns with the arm. For a pivot on +x, it turns in the direction opposite to the cam.
            let turning = 1.0 + self.pivot.map_or(0.0, |_| self.side * at.v);
            return (contact.rho * turning, 1.0 / contact.rho);
        }
        // The centre of the circle moves along the pitch curve.
        let [own, cam] = self.kind().velocities(contact.pitch);
        let length = libm::hypot(at.v * own[0] - cam[0], at.v * own[1] - cam[1]);
        let radius = self.geometry.radius();
        let inner = 1.0 - radius * self.geometry.pitch_curvature(at);
        // With the curvature κ of the pitch curve and the roller radius R: 1/(1/κ − R) + 1/R = 1/(R·(1 − κR)).
        (length * inner, 1.0 / (radius * inner))
    }
}

/// Contact at one point of the motion of `follower`. `force` acts on the follower, N; for an arm, it is the moment about the pivot, N·m.
/// `speed` is the cam speed, rad/s. Speed and friction are negative for backward rotation.
pub fn touch(follower: &Follower, speed: f64, friction: f64, at: Svaj, force: f64) -> Touch {
    FollowerContact::of(follower).at(speed, friction, at, force)
}

/// Whether the cam slides on the follower; false for a roller.
pub fn rubs(follower: &Follower) -> bool {
    follower.is_flat() || follower.kind().is_mushroom() || follower.roller_radius() == 0.0
}

/// Whether the follower is constrained from both sides and cannot lift off: in the groove of a barrel, or by a conjugate pair.
pub fn held(cam: &Cam, conjugate: Option<&Cam>) -> bool {
    conjugate.is_some() || matches!(cam.follower, Follower::Barrel { .. })
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

#[cfg(test)]
pub(in crate::dynamics) mod tests;
