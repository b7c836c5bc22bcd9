//! Numerical stability: failures of naive methods and results of gaitcam, with the number of correct digits. reports/stability.md describes the same.

mod fits;
mod numbers;
mod profiles;
mod programs;

use std::f64::consts::TAU;

use gaitcam::error::Result;
use gaitcam::scene;
use gaitcam::synth::Design;

fn design(changes: &[&str]) -> Result<Design> {
    gaitcam_test_support::design(scene::DEFAULT, changes)
}

fn finite(design: &Design) {
    let law = &design.cam.law;
    for i in 0..720 {
        let at = law.svaj(TAU * f64::from(i) / 720.0);
        assert!([at.s, at.v, at.a, at.j].iter().all(|x| x.is_finite()));
    }
    let f = &design.force;
    assert!(
        [f.rms_error_n, f.max_error_n, f.mean_n, f.min_n, f.max_n]
            .iter()
            .all(|x| x.is_finite())
    );
    assert!(
        design
            .checks
            .iter()
            .all(|c| c.worst.is_finite() && c.limit.is_finite()),
        "{:?}",
        design.checks
    );
}
