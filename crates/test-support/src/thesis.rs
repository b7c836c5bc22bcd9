//! Both cams of Campillo de Blas (2017) (theory §3) and the data of its machine.

use gaitcam::cam::{Cam, Follower};
use gaitcam::drive::{Drive, DriveKind};
use gaitcam::law::{Law, Wave};
use gaitcam::poly::PiecewisePoly;
use gaitcam::units::G;
use std::f64::consts::{PI, TAU};

/// Speed of the shaft, rad/s: 1.85 steps per second.
pub const SPEED: f64 = 11.624;
/// Mass of the shaft block, kg.
pub const MASS: f64 = 1.0;
/// Radius of the base circle, m.
pub const BASE_RADIUS: f64 = 0.03;
/// Eccentricity of the circle, and lift of the double harmonic, m.
pub const LIFT: f64 = 0.01;

/// Circle of radius 30 mm about a centre at a distance of 10 mm: d = r + e sin θ.
pub fn eccentric() -> Cam {
    Cam {
        law: Law::harmonic(0.0, &[(0.0, LIFT)]),
        follower: Follower::FlatTranslating {
            base_radius: BASE_RADIUS,
        },
    }
}

/// Double harmonic: rise of 10 mm in 135°, fall in 135°, dwell of 90°.
pub fn double_harmonic() -> Cam {
    let beta = 0.75 * PI;
    let half = 0.5 * LIFT;
    let waves = |sign: f64| {
        let wave = |rate: f64, cos: f64| Wave {
            rate,
            cos,
            sin: 0.0,
        };
        vec![wave(PI / beta, sign * half), wave(TAU / beta, 0.25 * half)]
    };
    let breaks = vec![0.0, beta, 2.0 * beta, TAU];
    let poly = PiecewisePoly::new(breaks, 0, vec![0.75 * half, 0.75 * half, 0.0]);
    Cam {
        law: Law::with_waves(poly, vec![waves(-1.0), waves(1.0), Vec::new()], true),
        follower: Follower::FlatTranslating {
            base_radius: BASE_RADIUS,
        },
    }
}

/// The "real" machine: the shaft block moves on the cam (eq. 22).
pub fn real(speed: f64) -> Drive {
    Drive::moving_axis(MASS, G, speed)
}

/// The "ideal" machine: fixed axis with only the mass (eq. 15).
pub fn ideal(speed: f64) -> Drive {
    Drive {
        kind: DriveKind::FixedAxis,
        rest_force: 0.0,
        spring_rate: 0.0,
        damping: 0.0,
        mass: MASS,
        speed,
        lever: 1.0,
    }
}
