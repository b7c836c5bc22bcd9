//! Profiles, curvature, pressure angles, sizes, and infeasible cams.

mod geometry;
mod inspect;
mod papers;
mod put_back;
mod radii;
mod random;
mod refused;

use gaitcam::cam::{Cam, Follower};
use gaitcam_test_support::turn;

/// Translating roller follower.
fn roller(prime_radius: f64, offset: f64, roller_radius: f64) -> Follower {
    Follower::RollerTranslating {
        prime_radius,
        offset,
        roller_radius,
    }
}

/// Every oscillating follower, with its pivot on either side.
fn oscillating() -> Vec<Cam> {
    let law = turn(&[
        ("cycloidal", 0.15, 90.0),
        ("dwell", 0.0, 90.0),
        ("3-4-5", -0.15, 110.0),
        ("dwell", 0.0, 70.0),
    ]);
    let mut out = Vec::new();
    for pivot_distance in [0.1, -0.1] {
        for follower in [
            Follower::RollerOscillating {
                pivot_distance,
                arm: 0.08,
                prime_radius: 0.05,
                roller_radius: 0.01,
            },
            Follower::MushroomOscillating {
                pivot_distance,
                arm: 0.12,
                prime_radius: 0.09,
                arc_radius: 0.03,
            },
            Follower::FlatOscillating {
                pivot_distance,
                face_offset: 0.006,
                base_radius: 0.04,
            },
        ] {
            out.push(Cam::new(law.clone(), follower).unwrap());
        }
    }
    out
}
