//! Optima of few numbers against closed forms.

use super::*;
use crate::synth::families;
use crate::synth::samples::{FLAT, amplitude, one_wave};
use crate::units::G;

/// One harmonic under half of the acceleration that it needs.
fn clipped() -> SolverReport {
    let problem = one_wave(FLAT, &format!("acceleration = \"{} m/s^2\"", 0.15 * G));
    let law = families::law(&problem, &Search::default()).unwrap();
    law.ok().unwrap().solver
}

#[test]
fn a_convex_optimum_is_proved_by_its_multipliers() {
    let report = clipped();
    assert!(report.certified && report.doubt.is_none());
    let proof = report.certificate.unwrap();
    assert!(proof.relative_gap < PROVED, "{}", proof.relative_gap);
}

#[test]
fn half_the_acceleration_costs_the_square_of_half_the_wave() {
    let problem = one_wave(FLAT, &format!("acceleration = \"{} m/s^2\"", 0.15 * G));
    let law = families::law(&problem, &Search::default()).unwrap().ok();
    let law = law.unwrap().law;
    assert!((law.stroke() / amplitude(&problem) - 1.0).abs() < 1e-6);
    let missing = 0.15 * problem.target_mean() / 2.0_f64.sqrt();
    let error = limits::force_report(&problem, &law).rms_error_n;
    assert!((error / missing - 1.0).abs() < 1e-6);
}
