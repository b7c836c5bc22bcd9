//! Optima of small problems compared with closed forms.

use super::*;
use crate::synth::families;
use crate::synth::qp::{self, PROVED};
use crate::synth::report::solver::SolverReport;
use crate::synth::samples::{FLAT, amplitude, one_wave};
use crate::units::G;

/// One harmonic with a limit of half the acceleration that it requires.
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
    let error = ForceReport::of(&problem, &law).rms_error_n;
    assert!((error / missing - 1.0).abs() < 1e-6);
}

/// tan φ = A sin θ/(D + A − A cos θ) is maximum for sin φ = A/(D + A). The lift is measured from the point at which the law touches its base circle,
/// which is arbitrary for one wave.
#[test]
fn a_pressure_angle_leaves_the_wave_of_its_sine() {
    let cam = "follower = \"roller-translating\"\nroller_radius = \"1 mm\"\noffset = \"0 mm\"\n\
               prime_radius = \"30 mm\"";
    let problem = one_wave(cam, "pressure_angle = \"20 deg\"");
    let found = families::law(&problem, &Search::default()).unwrap().ok();
    let found = found.unwrap();
    let sine = 20.0_f64.to_radians().sin();
    let wanted = 0.03 * sine / (1.0 - sine);
    assert!(wanted < amplitude(&problem));
    let stroke = found.law.stroke();
    assert!((0.5 * stroke / wanted - 1.0).abs() < 1e-6, "{stroke}");
    assert!(found.solver.certified);
}

/// All touching angles are equally good: the bound over the turn is the optimum.
#[test]
fn the_bound_over_all_touching_angles_is_the_optimum_of_a_wave() {
    let mut wave = Quadratic::zero(&qp::Basis::Harmonic { count: 1 });
    let pull = [0.0, 0.03, 0.04];
    for (i, pull) in pull.into_iter().enumerate() {
        // ½ mean (a² + b²) of the second derivative is ¼ of these squares.
        wave.hessian.add(i, i, if i == 0 { 0.0 } else { 0.5 });
        wave.gradient[i] = -0.5 * pull;
    }
    let basis = qp::Basis::Harmonic { count: 1 };
    let mut program = Program::new(basis, wave.clone(), Vec::new(), 0.01);
    qp::sizes::declare(&mut program);
    // s + 2 a ≥ −(D + 2 A): of s = A (1 − cos θ) it is least, −2 A, where θ = 0, and A ≤ 0.02 leaves 1 − 0.02/0.05.
    let mut limit = Limit::on(Criterion::BaseCircle, [-1.0, 0.0, 2.0, 0.0, 0.0]).at_most(0.04);
    limit.from_reference = true;
    program.limits.push(limit);
    let formulation = Formulation {
        force: wave.clone(),
        program,
        stiffness: Some(1.0),
        above_base_circle: None,
        pieces: 2,
    };
    let found = at_best_angle(formulation).ok().unwrap();
    let [_, a, b] = found.solution.x[..] else {
        panic!("one wave has three numbers");
    };
    assert!((a.hypot(b) / 0.02 - 1.0).abs() < 1e-6, "{a} {b}");
    // In the direction that the objective draws to.
    assert!((a / b - 0.75).abs() < 1e-3);
    let value = found.formulation.program.merit(&found.solution);
    let bound = found.bound.unwrap();
    assert!(bound <= value && value - bound < 1e-6 * value.abs());
}
