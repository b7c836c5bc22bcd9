//! Minimum errors of harmonics compared with an independent conic program.

use std::f64::consts::TAU;

use clarabel::algebra::CscMatrix;
use clarabel::solver::{DefaultSettingsBuilder, DefaultSolver, IPSolver, SupportedConeT};
use gaitcam::force::Walker;

use super::{force, people, with};

/// Root of the minimum mean square of the worst part of the walkers, by one cone each over the harmonics of the force: minimise α + Σ s_w/((1 − part)
/// n) with u_w² ‖γ_w c − y_w‖² ≤ α + s_w and s_w ≥ 0 (Rockafellar and Uryasev 2000). Part 0 is the mean; a part that contains one walker is the
/// worst. `unit` is u_w.
fn least_by_cones(
    people: &[(Walker, Vec<(f64, f64)>)],
    harmonics: usize,
    part: f64,
    unit: impl Fn(&Walker) -> f64,
) -> f64 {
    let count = people.len();
    let (alpha, columns) = (2 * harmonics, 2 * harmonics + 1 + count);
    let (mut entries, mut b, mut cones) = (Vec::new(), Vec::new(), Vec::new());
    for w in 0..count {
        entries.push((b.len(), alpha + 1 + w, -1.0));
        b.push(0.0);
    }
    cones.push(SupportedConeT::NonnegativeConeT(count));
    for (w, (walker, waves)) in people.iter().enumerate() {
        let gamma = (TAU / walker.curve.period_s).powi(2) / 100.0;
        let u = unit(walker);
        // x² ≤ q as ‖(q − 1, 2x)‖ ≤ q + 1.
        for sign in [1.0, -1.0] {
            entries.extend([(b.len(), alpha, -1.0), (b.len(), alpha + 1 + w, -1.0)]);
            b.push(sign);
        }
        for (n, (c, s)) in waves.iter().enumerate() {
            for (k, y) in [(0, c), (1, s)] {
                if n < harmonics {
                    entries.push((b.len(), 2 * n + k, -2.0 * u * gamma));
                }
                b.push(-2.0 * u * y);
            }
        }
        cones.push(SupportedConeT::SecondOrderConeT(2 + 2 * waves.len()));
    }
    let (i, j, values) = entries.into_iter().collect();
    let a = CscMatrix::new_from_triplets(b.len(), columns, i, j, values);
    let mut q = vec![0.0; columns];
    q[alpha] = 1.0;
    q[alpha + 1..].fill(1.0 / ((1.0 - part) * count as f64));
    let settings = DefaultSettingsBuilder::default()
        .verbose(false)
        .tol_gap_abs(1e-13)
        .tol_gap_rel(1e-12)
        .tol_feas(1e-12)
        .build()
        .unwrap();
    let p = CscMatrix::zeros((columns, columns));
    let mut solver = DefaultSolver::new(&p, &q, &a, &b, &cones, settings).unwrap();
    solver.solve();
    let x = &solver.solution.x;
    let least: f64 = q.iter().zip(x).map(|(q, x)| q * x).sum();
    (0.5 * least).sqrt()
}

#[test]
fn the_least_error_in_percent_and_in_newtons_is_that_of_a_conic_program_of_its_own() {
    for (count, spread) in [(12, 1.0), (60, 0.4), (200, 0.15)] {
        let people = people(count, 6, spread);
        let force = force(&people);
        let mean = people.iter().map(|p| p.0.curve.mean_n()).sum::<f64>() / count as f64;
        for (robust, part) in [
            ("mean", 0.0),
            ("cvar 0.75", 0.75),
            ("worst", 1.0 - 1.0 / count as f64),
        ] {
            for error in ["relative", "absolute"] {
                let scene = with(&[
                    ("law.family", "harmonic"),
                    ("law.harmonics", "4"),
                    ("law.robust", robust),
                    ("law.error", error),
                ]);
                let own = scene.design_for(&force).unwrap().population.unwrap();
                let unit = |w: &Walker| match error {
                    "absolute" => w.curve.mean_n() / mean,
                    _ => 1.0,
                };
                let other = 100.0 * least_by_cones(&people, 4, part, unit);
                let what = format!("{count} {robust} {error}");
                assert!(own.gap <= 1e-6, "{what}: gap {}", own.gap);
                let off = own.objective_percent / other - 1.0;
                assert!(
                    off.abs() < 1e-6,
                    "{what}: {} {other}",
                    own.objective_percent
                );
                if robust == "worst" {
                    let worst = match error {
                        "absolute" => 100.0 * own.worst_n / mean,
                        _ => own.worst_percent,
                    };
                    assert!(
                        (worst / other - 1.0).abs() < 1e-6,
                        "{what}: {worst} {other}"
                    );
                    let errors = own.each.iter().map(|e| e.measured(scene.law.error));
                    let errors: Vec<f64> = errors.collect();
                    assert_eq!(
                        errors[own.worst],
                        errors.iter().copied().fold(0.0, f64::max)
                    );
                }
            }
        }
    }
}
