//! Contact forces and sliding for every follower, by virtual work.
//!
//! The follower has one freedom s, the cam one, θ. With the contact's unit normal n (towards the
//! follower) and G = ∂P/∂s, the velocity of the follower's own point there, a force N n and a friction
//! μ|N| along the rubbing give the force on that freedom Q = N n·G + μ|N| t·G; the shaft gives
//! T = (N n + μ|N| t)·U, U the velocity of the cam's own point per unit of θ. Without friction that is
//! T = Q·v. For an arm Q is the moment about its pivot, N·m, and v is in rad/rad; for a slide T is the
//! push along its travel, N.

use crate::cam::{Cam, Follower, Geometry};
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

/// The contact's geometry per unit of θ, fixed frame.
struct Place {
    /// Unit normal, towards the follower.
    normal: [f64; 2],
    /// Velocity of the follower's point per unit of s.
    follower: [f64; 2],
    /// Velocity of the cam's point per unit of θ.
    cam: [f64; 2],
    /// Length of profile that the contact walks per unit of θ, signed.
    walk: f64,
    /// Curvature of cam and follower together, 1/m.
    curvature: f64,
    /// Direction across the guide, or along the arm away from the pivot.
    across: [f64; 2],
    /// Whether the surfaces rub.
    rubs: bool,
}

/// The contact at one point of the motion of `follower`, under `force` on the follower's freedom (N; for
/// an arm the moment about its pivot, N·m), the cam turning at `speed` rad/s; backwards speed and friction
/// are negative.
///
/// A roller rolls: its own friction is in its bearing and is left out. Where friction locks the follower
/// the normal force is infinite.
pub fn touch(follower: &Follower, speed: f64, friction: f64, at: Svaj, force: f64) -> Touch {
    let place = place(follower, at);
    let (n, g) = (place.normal, place.follower);
    let tangent = [-n[1], n[0]];
    let relative = [place.cam[0] - at.v * g[0], place.cam[1] - at.v * g[1]];
    let rubbing = dot(relative, tangent);
    let mu = if place.rubs { friction } else { 0.0 };
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
    let flat = matches!(follower, Follower::FlatTranslating { .. });
    Touch {
        normal,
        sliding: if place.rubs { speed * rubbing } else { 0.0 },
        entraining: speed * (place.walk - if place.rubs { 0.5 * rubbing } else { 0.0 }),
        side_thrust: -dot(total, place.across),
        tipping: if flat { force * at.v } else { 0.0 },
        torque: if mu == 0.0 {
            force * at.v
        } else {
            dot(total, place.cam)
        },
        curvature: place.curvature,
    }
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

/// The contact's geometry, from the same formulas as the profile's.
fn place(follower: &Follower, at: Svaj) -> Place {
    let geometry = Geometry::new(follower);
    let contact = geometry.contact(at);
    let pivot = follower.pivot();
    let side = pivot.map_or(1.0, |p| p[0].signum());
    let of_follower = |p: [f64; 2]| match pivot {
        Some(c) => [side * (p[1] - c[1]), -side * (p[0] - c[0])],
        None => [0.0, 1.0],
    };
    let of_cam = |p: [f64; 2]| match geometry.straight() {
        Some(scale) => [-scale, 0.0],
        None => [-p[1], p[0]],
    };
    let across = match follower.start_angle() {
        Some(start) => {
            let (sin, cos) = (start + at.s).sin_cos();
            [-side * cos, sin]
        }
        None => [1.0, 0.0],
    };
    let (walk, curvature) = if follower.is_flat() {
        // A face on an arm turns with it against the cam.
        let turning = 1.0 + pivot.map_or(0.0, |_| side * at.v);
        (contact.rho * turning, 1.0 / contact.rho)
    } else {
        // The circle's centre moves along the pitch curve.
        let (own, cam) = (of_follower(contact.pitch), of_cam(contact.pitch));
        let length = (at.v * own[0] - cam[0]).hypot(at.v * own[1] - cam[1]);
        let radius = geometry.radius();
        let inner = 1.0 - radius * geometry.pitch_curvature(at);
        // 1/(1/κ − R) + 1/R = 1/(R·(1 − κR)).
        (length * inner, 1.0 / (radius * inner))
    };
    Place {
        normal: contact.normal,
        follower: of_follower(contact.point),
        cam: of_cam(contact.point),
        walk,
        curvature,
        across,
        rubs: rubs(follower),
    }
}

#[cfg(test)]
pub(in crate::dynamics) mod tests;
