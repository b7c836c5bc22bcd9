//! Objectives on the target: bands, weights, largest error, free phase. Every result is compared with a dense scan or a second solution.

use std::f64::consts::TAU;

use gaitcam::force::{ForceCurve, ReadOptions, force_curve};
use gaitcam::scene;
use gaitcam::synth::{Design, synthesise};
use gaitcam_test_support::young;

pub fn read(changes: &[&str]) -> gaitcam::scene::Scene {
    gaitcam_test_support::scene(scene::DEFAULT, changes).unwrap()
}

pub fn solved(changes: &[&str], target: &ForceCurve) -> Design {
    synthesise(&read(changes), Some(target)).unwrap()
}

/// Force minus target at many angles, N.
fn errors(design: &Design) -> Vec<f64> {
    let target = design.target().unwrap();
    (0..100_000)
        .map(|i| TAU * f64::from(i) / 100_000.0)
        .map(|x| design.problem.drive.force(design.cam.law.svaj(x)) - target.at(x))
        .collect()
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0_f64, |m, v| m.max(v.abs()))
}

pub fn mean_square_jerk(design: &Design) -> f64 {
    (0..20_000)
        .map(|i| design.cam.law.svaj(TAU * f64::from(i) / 20_000.0).j.powi(2))
        .sum::<f64>()
        / 20_000.0
}

#[test]
fn a_smaller_mass_gives_the_alternating_part_alone() {
    // M s̈ = W a cos θ, so s = −W a/(M ω²) cos θ, whatever share of the weight M is.
    let (weight, share, mass, period) = (700.0, 0.2, 60.0, 1.0 / 1.85);
    let n = 720;
    let force = |i: i32| weight * (1.0 + share * (TAU * f64::from(i) / f64::from(n)).cos());
    let target = ForceCurve::from_samples("", period, (0..n).map(force).collect()).unwrap();
    let changes = ["drive.mass=60 kg", "law.family=harmonic", "law.harmonics=1"];
    let plain = solved(&changes, &target);
    assert_eq!(plain.reasons[0].code(), "reason-mean-force");
    let design = solved(
        &[&changes[..], &["gait.scale=alternating"]].concat(),
        &target,
    );
    assert_eq!(design.verdict.name(), "acceptable", "{:?}", design.reasons);
    let omega = TAU / period;
    let stroke = 2.0 * weight * share / (mass * omega * omega);
    assert!((design.cam.law.stroke() / stroke - 1.0).abs() < 1e-6);
    let mean = mass * gaitcam::units::G;
    assert!((design.force.target_mean_n - mean).abs() < 1e-6);
    assert!((design.force.mean_n - mean).abs() < 1e-6);
    assert!(design.force.rms_error_n < 1e-3);
    // Codes quote the part of the walker's weight, not of the machine's.
    let factors = design.load_factors();
    assert!((factors[0].achieved - share).abs() < 1e-6, "{factors:?}");
    assert_eq!((factors.len(), factors[0].of_step), (6, 1.0));
}

#[test]
fn the_load_factors_of_a_written_cycle_are_parts_of_its_mean_whoever_walks() {
    // F = W (1 + 0.4 sin θ + 0.2 sin 2θ): the file says nothing of a walker.
    let lines = (0..=200).map(|i| {
        let t = TAU * f64::from(i) / 200.0;
        let force = 750.0 * (1.0 + 0.4 * t.sin() + 0.2 * (2.0 * t).sin());
        format!("{},{force}\n", 0.526 * f64::from(i) / 200.0)
    });
    let text = format!(
        "# cycle, period_s = 0.526\ntime_s,force_n\n{}",
        lines.collect::<String>()
    );
    for feet in ["one", "both", "left", "right", "total"] {
        let scene = format!(
            "[gait]\nfile = \"cycle.csv\"\nfeet = \"{feet}\"\n[drive]\nkind = \"moving-axis\"\n"
        );
        let scene = gaitcam_test_support::scene(&scene, &[] as &[&str]).unwrap();
        let (path, options) = ("cycle.csv".as_ref(), ReadOptions::default());
        let of = scene.gait.as_ref().unwrap().feet;
        let force = force_curve(path, text.as_bytes(), &options, of).unwrap();
        let design = scene.design_for(&force).unwrap();
        let factors = design.load_factors();
        for (factor, wanted) in factors.iter().zip([0.4, 0.2]) {
            assert!((factor.target - wanted).abs() < 1e-3, "{feet}: {factor:?}");
        }
    }
}

#[test]
fn inside_a_band_the_law_is_smoother_than_the_nearest_one() {
    let target = young();
    let near = solved(&["law.spans=16"], &target);
    let inside = solved(&["law.spans=16", "gait.band=20 N"], &target);
    assert!(
        inside.infeasible.is_none() && inside.checks.iter().all(|c| c.pass),
        "{:?}",
        inside.checks
    );
    let worst = largest(&errors(&inside));
    assert!(
        worst <= 20.0 + 1e-6 && worst > 19.99,
        "the band binds and holds: {worst}"
    );
    assert!(mean_square_jerk(&inside) < 0.95 * mean_square_jerk(&near));
    assert!(inside.binding.iter().any(|b| b.limit.name() == "band"));
}

#[test]
fn the_band_of_a_recording_is_its_spread() {
    let mut target = young();
    let n = target.force_n.len();
    let spread: Vec<f64> = (0..n)
        .map(|i| 12.0 + 6.0 * (TAU * i as f64 / n as f64).sin())
        .collect();
    target.spread_n = Some(spread.clone());
    let design = solved(&["gait.band=spread"], &target);
    assert!(design.infeasible.is_none());
    let errors = errors(&design);
    for (i, e) in errors.iter().enumerate() {
        let half = 12.0 + 6.0 * (TAU * i as f64 / errors.len() as f64).sin();
        assert!(e.abs() <= half + 1e-3, "{i}: {e} of {half}");
    }
    // Without a spread there is nothing to stay inside of.
    let error = synthesise(&read(&["gait.band=spread"]), Some(&young())).unwrap_err();
    assert!(error.to_string().contains("gait.band"), "{error}");
}

#[test]
fn a_band_too_narrow_says_how_much_wider() {
    let target = young();
    let narrow = solved(&["law.spans=6", "gait.band=0.4 N"], &target);
    let conflict = narrow
        .infeasible
        .expect("six spans cannot follow within 0.4 N");
    let wider = conflict
        .relaxations
        .iter()
        .find(|r| r.limit.name() == "band")
        .unwrap();
    assert!((wider.from - 0.4).abs() < 1e-9, "{wider:?}");
    let to = wider.to.unwrap();
    let enough = format!("gait.band={} N", to * (1.0 + 1e-6));
    let less = format!("gait.band={} N", to * (1.0 - 1e-3));
    assert!(
        solved(&["law.spans=6", &enough], &target)
            .infeasible
            .is_none(),
        "{to}"
    );
    assert!(
        solved(&["law.spans=6", &less], &target)
            .infeasible
            .is_some(),
        "{to}"
    );
}

#[test]
fn the_least_largest_error_is_below_that_of_least_squares_and_touches_often() {
    let target = young();
    let squares = solved(&["law.spans=10"], &target);
    let peak = solved(&["law.spans=10", "law.minimise=peak-force-error"], &target);
    let (a, b) = (errors(&squares), errors(&peak));
    assert!(largest(&b) < largest(&a), "{} {}", largest(&b), largest(&a));
    assert!(peak.force.rms_error_n >= squares.force.rms_error_n);
    // The largest error is a convex function of the law: where no line through it leads down, it is least.
    let top = largest(&b);
    for k in 0..20 {
        let other = solved(&["law.spans=10"], &target.begun_at(0.3 * f64::from(k)));
        let forces = |d: &Design, i: usize| {
            d.problem
                .drive
                .force(d.cam.law.svaj(TAU * i as f64 / 10_000.0))
        };
        for step in [-0.02, -1e-3, 1e-3, 0.02] {
            let beside = (0..10_000).fold(0.0_f64, |m, i| {
                m.max((b[10 * i] + step * (forces(&other, i) - forces(&peak, i))).abs())
            });
            assert!(
                beside > top * (1.0 - 1e-5),
                "{k} {step}: {beside} below {top}"
            );
        }
    }
    let proof = peak.solver.certificate.unwrap();
    assert!(proof.relative_gap < 1e-5, "{proof:?}");
    assert!((peak.force.max_error_n / top - 1.0).abs() < 1e-6);
}

#[test]
fn a_heavier_phase_is_followed_more_closely() {
    let target = young();
    let square =
        |d: &Design, from: usize, to: usize| errors(d)[from..to].iter().map(|e| e * e).sum::<f64>();
    let plain = solved(&["law.spans=8"], &target);
    let weight = r#"gait.weight=[{from="0 deg", to="60 deg", weight=20.0}]"#;
    let heavy = solved(&["law.spans=8", weight, "accuracy.rms=none"], &target);
    let end = 100_000 / 6;
    assert!(square(&heavy, 0, end) < 0.7 * square(&plain, 0, end));
    assert!(heavy.force.rms_error_n > plain.force.rms_error_n);
    // A weight on the whole cycle changes nothing but the unit.
    let all = r#"gait.weight=[{from="0 deg", to="360 deg", weight=3.0}]"#;
    let same = solved(&["law.spans=8", all], &target);
    for (a, b) in plain.coefficients.iter().zip(&same.coefficients) {
        assert!((a - b).abs() < 1e-9 * plain.cam.law.stroke(), "{a} {b}");
    }
}

#[test]
fn a_free_phase_finds_the_shift_of_the_force() {
    // A rest of 40° ties the law to the cam's angles.
    let dwell = r#"law.dwell=[{from="0 deg", to="40 deg"}]"#;
    let base = ["law.spans=16", dwell, "accuracy.rms=50 %"];
    let target = young();
    let free = solved(&[base[0], base[1], base[2], "gait.phase=free"], &target);
    for degrees in (0..360).step_by(15) {
        let phase = format!("gait.phase={degrees} deg");
        let fixed = solved(&[base[0], base[1], base[2], &phase], &target);
        assert!(
            free.force.rms_error_n <= fixed.force.rms_error_n * (1.0 + 1e-9),
            "{degrees}: {} {}",
            free.force.rms_error_n,
            fixed.force.rms_error_n
        );
    }
    let shifted = target.begun_at(1.0);
    let again = solved(&[base[0], base[1], base[2], "gait.phase=free"], &shifted);
    let turn = (free.problem.phase - again.problem.phase - 1.0).rem_euclid(TAU);
    // Two humps of equal shape leave two phases of nearly one error.
    assert!((again.force.rms_error_n / free.force.rms_error_n - 1.0).abs() < 1e-3);
    assert!(
        turn.min(TAU - turn) < 1e-3 || (turn - TAU / 2.0).abs() < 0.1,
        "{turn}"
    );
}
