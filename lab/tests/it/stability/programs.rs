//! Programs at the limit of feasibility.

use std::f64::consts::{PI, TAU};

use gaitcam::drive::Drive;
use gaitcam::error::Place;
use gaitcam::force::{Feet, model};
use gaitcam::law::Law;
use gaitcam_lab::tiers::{Between, Bound, Task};

use super::{design, finite};

/// A repeated demand is rank-deficient and has no effect. Two different demands lead to an error that names both.
#[test]
fn equal_demands_are_taken_once_and_contradictions_are_named() {
    let twice = |second: &str| {
        let point = |lift: &str| format!("{{ angle = \"90 deg\", lift = \"{lift}\" }}");
        design(&[&format!("law.point=[{}, {}]", point("5 mm"), point(second))])
    };
    let good = twice("5 mm").unwrap();
    finite(&good);
    assert!((good.cam.law.svaj(0.5 * PI).s - 0.005).abs() < 1e-9);
    let refusal = twice("6 mm").unwrap_err();
    assert_eq!(refusal.code(), "synth-no-law", "{refusal}");
    assert_eq!(refusal.place, Place::Key("law.point".to_string()));
}

/// A rise of 20 mm and a return in one turn require an acceleration of 16 h/T² (theory §1, Favard). Limits just above, at and below this minimum lead
/// to a design or an error, and never to a wrong design.
#[test]
fn a_program_on_the_edge_of_feasibility_is_answered_either_way() {
    let period: f64 = 1.0 / 1.85;
    let least = 16.0 * 0.02 / (period * period);
    let with = |most: f64| {
        design(&[
            "law.point=[{ angle = \"0 deg\", lift = \"0 mm\" }, { angle = \"180 deg\", lift = \"20 mm\" }]",
            &format!("limits.acceleration={most} m/s^2"),
            "law.spans=16",
        ])
        .unwrap()
    };
    let builds = |most: f64| with(most).infeasible.is_none();
    let (mut low, mut high) = (0.9 * least, 2.0 * least);
    assert!(!builds(low) && builds(high));
    for _ in 0..10 {
        let mid = 0.5 * (low + high);
        if builds(mid) {
            high = mid;
        } else {
            low = mid;
        }
    }
    assert!(
        high >= least * (1.0 - 1e-9) && high < 1.2 * least,
        "{high} {least}"
    );
    for most in [low, high, high * (1.0 + 1e-6)] {
        let answer = with(most);
        finite(&answer);
        if answer.infeasible.is_none() {
            let (down, up) = answer.cam.law.extremes(2);
            let worst = up.value.max(-down.value) * answer.problem.drive.speed.powi(2);
            assert!(worst <= most * (1.0 + 1e-6), "{worst} {most}");
        }
    }
}

/// One jerk sample per span does not enforce the limit. Rows, cones and the exchange do (theory §9).
#[test]
fn samples_break_the_limit_that_rows_cones_and_exchange_keep() {
    let target = model("young", Some(1.85), 700.0, Feet::Both).unwrap();
    let drive = Drive::moving_axis(target.mean_n() / 9.81, 9.81, TAU / target.period_s);
    let free = Task {
        target: &target,
        drive,
        degree: 5,
        spans: 32,
        bounds: &[],
    };
    let jerk = |law: &Law| {
        let (low, high) = law.extremes(3);
        high.value.max(-low.value)
    };
    let most = 0.6 * jerk(&free.free().unwrap());
    let bounds = [Bound { order: 3, most }];
    let task = Task {
        bounds: &bounds,
        ..free
    };
    let conic = |b| jerk(&task.conic(b).unwrap().solve(1e-9).unwrap()) / most;
    assert!(conic(Between::Samples(1)) > 1.1);
    assert!(conic(Between::Coefficients) < 1.0 + 1e-7);
    assert!(conic(Between::Cone) < 1.0 + 1e-7);
    assert!(jerk(&task.exchange().unwrap()) / most <= 1.0 + 1e-9);
}

/// A dwell of 1e-9 rad between two demands leads to a singular system, which is rejected as such.
#[test]
fn a_dwell_of_a_thousand_millionth_of_a_radian_is_refused() {
    // This position is at no break of the maximum number of spans, which are 0.9° apart.
    let dwell = "law.dwell=[{ from = \"90.1 deg\", to = \"90.1000000573 deg\" }]";
    let refusal = design(&[dwell]).unwrap_err();
    assert_eq!(refusal.code(), "synth-no-law", "{refusal}");
    // A dwell of a thousandth of a radian is accepted.
    let answer = design(&["law.dwell=[{ from = \"90 deg\", to = \"90.0573 deg\" }]"]).unwrap();
    finite(&answer);
    let v = answer.cam.law.svaj(0.5 * PI + 5e-4).v;
    assert!(v.abs() < 1e-9, "{v}");
}
