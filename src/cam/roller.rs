//! Roller followers: the pitch curve is the path of the roller's centre, the cam its inner parallel.
//!
//! With the centre C(θ) in the fixed frame, the pitch curve in the cam's frame is R(−θ)·C. Its tangent,
//! still seen in the fixed frame, is t = C′ − J·C and t's derivative C″ − 2J·C′ − C, J the quarter turn.
//! Traversed clockwise, its curvature is −det(t, t′)/|t|³, positive where convex.

use super::{Cam, Curvature, Follower};
use crate::law::Svaj;
use crate::poly::{Extreme, stand_in};

/// Relative accuracy of the stand-ins whose extremes are taken.
const STAND_IN: f64 = 1e-12;

/// Centre of the roller in the fixed frame with tangent t and its derivative t′ (see the module).
#[derive(Debug, Clone, Copy)]
pub(super) struct Pitch {
    pub centre: [f64; 2],
    pub tangent: [f64; 2],
    pub tangent_rate: [f64; 2],
}

impl Pitch {
    /// From C, C′, C″.
    fn new(c: [f64; 2], c1: [f64; 2], c2: [f64; 2]) -> Self {
        Pitch {
            centre: c,
            tangent: [c1[0] + c[1], c1[1] - c[0]],
            tangent_rate: [c2[0] + 2.0 * c1[1] - c[0], c2[1] - 2.0 * c1[0] - c[1]],
        }
    }

    /// Signed curvature of the pitch curve, 1/m.
    pub fn curvature(&self) -> f64 {
        let [tx, ty] = self.tangent;
        let [rx, ry] = self.tangent_rate;
        let square = tx * tx + ty * ty;
        (ty * rx - tx * ry) / (square * square.sqrt())
    }

    /// Outward unit normal of the cam at the contact, fixed frame.
    pub fn normal(&self) -> [f64; 2] {
        let [tx, ty] = self.tangent;
        let length = tx.hypot(ty);
        [-ty / length, tx / length]
    }
}

/// Roller centre of a translating follower: (e, √(Rp² − e²) + s).
pub(super) fn translating(at: Svaj, prime_radius: f64, offset: f64) -> Pitch {
    let rise = (prime_radius * prime_radius - offset * offset).sqrt();
    Pitch::new([offset, rise + at.s], [0.0, at.v], [0.0, at.a])
}

/// tan φ = (v − e)/(s + D) (FACTS §6).
pub(super) fn pressure_angle(at: Svaj, prime_radius: f64, offset: f64) -> f64 {
    let rise = (prime_radius * prime_radius - offset * offset).sqrt();
    (at.v - offset).atan2(rise + at.s)
}

pub(super) fn pressure_angle_extremes(cam: &Cam) -> (Extreme, Extreme) {
    let (e, rp) = (cam.follower.offset(), cam.follower.prime_radius());
    of_law(cam, |at| pressure_angle(at, rp, e))
}

pub(super) fn curvature(cam: &Cam, roller_radius: f64) -> Curvature {
    let (low, high) = of_law(cam, |at| pitch(&cam.follower, at).curvature());
    let finished = |k: f64| 1.0 / k - roller_radius;
    let convex = Extreme {
        at: high.at,
        value: finished(high.value),
    };
    let concave = (low.value < 0.0).then(|| Extreme {
        at: low.at,
        value: finished(low.value),
    });
    Curvature {
        convex: if high.value > 0.0 {
            convex
        } else {
            Extreme {
                at: high.at,
                value: f64::INFINITY,
            }
        },
        concave,
        undercut: high.value > 0.0 && convex.value < 0.0,
    }
}

/// The pitch curve's local geometry for any follower that carries a roller.
pub(super) fn pitch(follower: &Follower, at: Svaj) -> Pitch {
    match *follower {
        Follower::RollerTranslating {
            prime_radius,
            offset,
            ..
        } => translating(at, prime_radius, offset),
        Follower::FlatTranslating { base_radius } => {
            unreachable!("a flat face of base radius {base_radius} has no pitch curve")
        }
    }
}

/// Extremes over the law of a function of the motion.
fn of_law(cam: &Cam, f: impl Fn(Svaj) -> f64) -> (Extreme, Extreme) {
    let breaks = cam.law.breaks();
    stand_in(breaks, STAND_IN, |i, x| {
        f(cam
            .law
            .svaj_on(i, (x - breaks[i]) / (breaks[i + 1] - breaks[i])))
    })
    .extremes()
}
