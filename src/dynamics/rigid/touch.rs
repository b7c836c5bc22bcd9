//! Contact forces and sliding for every follower, by virtual work.
//!
//! The follower has one freedom s, the cam one, θ. With the contact's unit normal n (towards the
//! follower) and G = ∂P/∂s, the velocity of the follower's own point there, a force N n and a friction
//! μ|N| along the rubbing give the force on that freedom Q = N n·G + μ|N| t·G; the shaft gives
//! T = (N n + μ|N| t)·U, U the velocity of the cam's own point per unit of θ. Without friction that is
//! T = Q·v. For an arm Q is the moment about its pivot, N·m, and v is in rad/rad; for a slide T is the
//! push along its travel, N.

use crate::cam::{Arm, Cam, Follower};
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
/// an arm the moment about its pivot, N·m), the cam turning at `speed` rad/s ≥ 0.
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
    match *follower {
        Follower::FlatTranslating { .. }
        | Follower::FlatOscillating { .. }
        | Follower::MushroomTranslating { .. }
        | Follower::MushroomOscillating { .. } => true,
        _ => follower.roller_radius() == 0.0,
    }
}

/// Whether the follower is held from both sides and cannot lift off: the groove of a barrel, or a conjugate
/// pair.
pub fn held(cam: &Cam, conjugate: Option<&Cam>) -> bool {
    conjugate.is_some() || matches!(cam.follower, Follower::Barrel { .. })
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn place(follower: &Follower, at: Svaj) -> Place {
    if let Some(Arm { pivot: c, length }) = follower.arm() {
        let side = c.signum();
        let (sin, cos) = (follower.start_angle().unwrap_or(0.0) + at.s).sin_cos();
        let centre = [c - side * length * cos, length * sin];
        let (first, second) = (
            [side * length * sin, length * cos],
            [side * length * cos, -length * sin],
        );
        return circle(follower, at, centre, first, second, Some(c));
    }
    match *follower {
        Follower::FlatTranslating { base_radius } => {
            let d = base_radius + at.s;
            Place {
                normal: [0.0, 1.0],
                follower: [0.0, 1.0],
                cam: [-d, at.v],
                walk: d + at.a,
                curvature: 1.0 / (d + at.a),
                across: [1.0, 0.0],
                rubs: true,
            }
        }
        Follower::FlatOscillating {
            pivot_distance,
            face_offset,
            ..
        } => swinging_face(follower, at, pivot_distance, face_offset),
        Follower::TranslatingCam { .. } => unrolled(follower, at, 1.0),
        Follower::Barrel { radius, .. } => unrolled(follower, at, radius),
        // On an arm: above.
        Follower::RollerTranslating { .. }
        | Follower::MushroomTranslating { .. }
        | Follower::RollerOscillating { .. }
        | Follower::MushroomOscillating { .. } => {
            let centre = [follower.offset(), follower.start_height() + at.s];
            circle(follower, at, centre, [0.0, 1.0], [0.0, 0.0], None)
        }
    }
}

/// A circle whose centre moves along C(s) with the derivatives C′ and C″, about a pivot on the x axis
/// where there is one. t = C′v − J·C is the pitch curve's tangent (see the cam's geometry).
fn circle(
    follower: &Follower,
    at: Svaj,
    centre: [f64; 2],
    first: [f64; 2],
    second: [f64; 2],
    pivot: Option<f64>,
) -> Place {
    let radius = follower.roller_radius();
    let rate = first.map(|x| x * at.v);
    let bend = [0, 1].map(|k| second[k] * at.v * at.v + first[k] * at.a);
    let t = [rate[0] + centre[1], rate[1] - centre[0]];
    let turn = [
        bend[0] + 2.0 * rate[1] - centre[0],
        bend[1] - 2.0 * rate[0] - centre[1],
    ];
    let square = dot(t, t);
    let length = square.sqrt();
    let pitch = (t[1] * turn[0] - t[0] * turn[1]) / (square * length);
    let normal = [-t[1] / length, t[0] / length];
    let point = [0, 1].map(|k| centre[k] - radius * normal[k]);
    let (own, across) = match pivot {
        None => ([0.0, 1.0], [1.0, 0.0]),
        Some(c) => {
            let arm = [centre[0] - c, centre[1]];
            let long = dot(arm, arm).sqrt();
            let turn = -c.signum();
            (
                [-turn * point[1], turn * (point[0] - c)],
                arm.map(|x| x / long),
            )
        }
    };
    Place {
        normal,
        follower: own,
        cam: [-point[1], point[0]],
        walk: length * (1.0 - radius * pitch),
        // 1/(1/κ − R) + 1/R = 1/(R·(1 − κR)).
        curvature: 1.0 / (radius * (1.0 - pitch * radius)),
        across,
        rubs: rubs(follower),
    }
}

/// A circle over a profile that slides by −x: pitch curve (scale·θ, base + s).
fn unrolled(follower: &Follower, at: Svaj, scale: f64) -> Place {
    let radius = follower.roller_radius();
    let slope = at.v / scale;
    let length = (1.0 + slope * slope).sqrt();
    let pitch = -at.a / (scale * scale * length.powi(3));
    Place {
        normal: [-slope / length, 1.0 / length],
        follower: [0.0, 1.0],
        cam: [-scale, 0.0],
        walk: scale * length * (1.0 - radius * pitch),
        curvature: 1.0 / (radius * (1.0 - pitch * radius)),
        across: [1.0, 0.0],
        rubs: rubs(follower),
    }
}

/// Oscillating flat face: n = (σ sin ξ, cos ξ), the contact at p·n + (dp/dψ)·n⊥ (see the cam's geometry).
fn swinging_face(follower: &Follower, at: Svaj, pivot: f64, offset: f64) -> Place {
    let (c, side) = (pivot.abs(), pivot.signum());
    let (sin, cos) = (follower.start_angle().unwrap_or(0.0) + at.s).sin_cos();
    let v = side * at.v;
    let slow = 1.0 / (1.0 + v);
    let p = offset + c * sin;
    let along = -side * c * cos * v * slow;
    let rho = offset + c * (sin * (1.0 + 2.0 * v) + cos * at.a * slow) * slow * slow;
    let normal = [side * sin, cos];
    let point = [
        p * normal[0] - along * cos,
        p * normal[1] + along * side * sin,
    ];
    Place {
        normal,
        follower: [side * point[1], -side * (point[0] - pivot)],
        cam: [-point[1], point[0]],
        walk: rho * (1.0 + v),
        curvature: 1.0 / rho,
        across: [-side * cos, sin],
        rubs: true,
    }
}

#[cfg(test)]
pub(in crate::dynamics) mod tests;
