//! Profiles of 3600 points.

use std::f64::consts::TAU;
use std::hint::black_box;

use gaitcam::cam::{Cam, Follower};
use gaitcam::law::{Extent, Law};

use super::cases::turn;
use super::table::Report;
use crate::timing::{Times, times};

pub(crate) fn roller(report: &mut Report) {
    let cam = Cam {
        law: turn("3-4-5", 0.02, Extent::TURN, TAU),
        follower: Follower::RollerTranslating {
            prime_radius: 0.05,
            offset: 0.005,
            roller_radius: 0.01,
        },
    };
    let seconds = times(|| black_box(&cam).profile(3600));
    report.time(
        "main job",
        "roller profile of 3600 points, curvature and pressure angle",
        1e-4,
        seconds,
    );
}

pub(crate) fn followers(report: &mut Report) {
    let slowest = others()
        .into_iter()
        .map(|(law, follower)| {
            let cam = Cam { law, follower };
            times(|| black_box(&cam).profile(3600))
        })
        .reduce(Times::or)
        .expect("six followers");
    report.time(
        "cams",
        "profile of 3600 points, the slowest of six other followers",
        150e-6,
        slowest,
    );
}

/// A law and a follower of every other kind.
fn others() -> [(Law, Follower); 6] {
    let straight = 0.2;
    [
        (
            turn("3-4-5", 0.3, Extent::TURN, TAU),
            Follower::RollerOscillating {
                pivot_distance: 0.08,
                arm: 0.06,
                prime_radius: 0.05,
                roller_radius: 0.01,
            },
        ),
        (
            turn("3-4-5", 0.2, Extent::TURN, TAU),
            Follower::FlatOscillating {
                pivot_distance: 0.1,
                face_offset: 0.01,
                base_radius: 0.04,
            },
        ),
        (
            turn("3-4-5", 0.02, Extent::TURN, TAU),
            Follower::FlatTranslating { base_radius: 0.04 },
        ),
        (
            turn("3-4-5", 0.02, Extent::TURN, TAU),
            Follower::MushroomTranslating {
                prime_radius: 0.14,
                offset: 0.0,
                arc_radius: 0.1,
            },
        ),
        (
            turn("3-4-5", 0.02, Extent::Length(straight), straight),
            Follower::TranslatingCam {
                base_height: 0.02,
                roller_radius: 0.008,
            },
        ),
        (
            turn("3-4-5", 0.04, Extent::TURN, TAU),
            Follower::Barrel {
                radius: 0.03,
                roller_radius: 0.005,
            },
        ),
    ]
}
