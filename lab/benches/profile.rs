//! Time of a profile of 3600 points with curvature and pressure angle, for every follower.

use gaitcam::cam::{Cam, Follower};
use gaitcam::law::{Extent, Law, Rise, Segment, program};
use std::f64::consts::TAU;

fn main() {
    divan::main();
}

/// Law of rise, dwell, fall and dwell, a quarter turn each.
fn law(motion: Rise, lift: f64, extent: Extent, length: f64) -> Law {
    let quarter = |motion: Rise, lift: f64| Segment {
        motion,
        lift,
        angle: 0.25 * length,
    };
    program(
        &[
            quarter(motion.clone(), lift),
            quarter(Rise::Dwell, 0.0),
            quarter(motion, -lift),
            quarter(Rise::Dwell, 0.0),
        ],
        extent,
    )
    .expect("a quarter each fills the extent")
}

fn turn(motion: Rise, lift: f64) -> Law {
    law(motion, lift, Extent::TURN, TAU)
}

fn run(bencher: divan::Bencher, law: Law, follower: Follower) {
    let cam = Cam::new(law, follower).expect("the follower fits");
    bencher.bench(|| divan::black_box(&cam).profile(3600));
}

const CLASSICS: [&str; 4] = ["3-4-5", "cycloidal", "modified-sine", "modified-trapezoid"];

/// Acceleration at 3600 equal steps.
#[divan::bench(args = CLASSICS)]
fn law_searched(bencher: divan::Bencher, motion: &str) {
    let law = turn(Rise::from_name(motion).expect("in the catalogue"), 0.02);
    bencher.bench(|| {
        (0..3600)
            .map(|i| divan::black_box(&law).svaj(TAU * f64::from(i) / 3600.0).a)
            .sum::<f64>()
    });
}

/// Checks and composes a programme of rise, dwell, fall and dwell.
#[divan::bench(args = CLASSICS)]
fn programme(bencher: divan::Bencher, motion: &str) {
    let motion = Rise::from_name(motion).expect("in the catalogue");
    bencher.bench(|| turn(divan::black_box(&motion).clone(), 0.02));
}

#[divan::bench(args = ["3-4-5", "modified-sine"])]
fn flat_translating(bencher: divan::Bencher, motion: &str) {
    let motion = Rise::from_name(motion).expect("in the catalogue");
    run(
        bencher,
        turn(motion, 0.02),
        Follower::FlatTranslating { base_radius: 0.04 },
    );
}

#[divan::bench(args = ["3-4-5", "modified-sine"])]
fn roller_translating(bencher: divan::Bencher, motion: &str) {
    let motion = Rise::from_name(motion).expect("in the catalogue");
    run(
        bencher,
        turn(motion, 0.02),
        Follower::RollerTranslating {
            prime_radius: 0.05,
            offset: 0.005,
            roller_radius: 0.01,
        },
    );
}

#[divan::bench(args = ["3-4-5", "modified-sine"])]
fn roller_oscillating(bencher: divan::Bencher, motion: &str) {
    let motion = Rise::from_name(motion).expect("in the catalogue");
    run(
        bencher,
        turn(motion, 0.3),
        Follower::RollerOscillating {
            pivot_distance: 0.08,
            arm: 0.06,
            prime_radius: 0.05,
            roller_radius: 0.01,
        },
    );
}

#[divan::bench]
fn mushroom_translating(bencher: divan::Bencher) {
    run(
        bencher,
        turn(Rise::Poly345, 0.02),
        Follower::MushroomTranslating {
            prime_radius: 0.14,
            offset: 0.0,
            arc_radius: 0.1,
        },
    );
}

#[divan::bench]
fn flat_oscillating(bencher: divan::Bencher) {
    run(
        bencher,
        turn(Rise::Poly345, 0.2),
        Follower::FlatOscillating {
            pivot_distance: 0.1,
            face_offset: 0.01,
            base_radius: 0.04,
        },
    );
}

#[divan::bench]
fn translating_cam(bencher: divan::Bencher) {
    run(
        bencher,
        law(Rise::Poly345, 0.02, Extent::Length(0.2), 0.2),
        Follower::TranslatingCam {
            base_height: 0.02,
            roller_radius: 0.008,
        },
    );
}

#[divan::bench]
fn barrel(bencher: divan::Bencher) {
    run(
        bencher,
        turn(Rise::Poly345, 0.04),
        Follower::Barrel {
            radius: 0.03,
            roller_radius: 0.005,
        },
    );
}
