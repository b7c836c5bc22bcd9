//! Electronic cams, read back by code that is independent of the program.

use std::f64::consts::TAU;

use gaitcam::scene::{self, built_in};
use gaitcam::synth::Design;
use gaitcam_cad::ecam::{Dialect, make};

fn footbridge() -> Design {
    built_in("footbridge")
        .unwrap()
        .scene()
        .unwrap()
        .design()
        .unwrap()
}

/// Numbers of a text between `before` and one of the characters `,);`.
fn numbers(text: &str, before: &str) -> Vec<f64> {
    let parts = text.split(before).skip(1);
    parts
        .map(|p| p.split([',', ')', ';']).next().unwrap().parse().unwrap())
        .collect()
}

/// Second derivative of the quintic through two ends, from its monomial form.
fn bend(h: f64, p: [f64; 3], q: [f64; 3], x: f64) -> f64 {
    let (d, v, w) = (
        q[0] - p[0] - p[1] * h - 0.5 * p[2] * h * h,
        q[1] - p[1] - p[2] * h,
        q[2] - p[2],
    );
    let c3 = (10.0 * d - 4.0 * v * h + 0.5 * w * h * h) / h.powi(3);
    let c4 = (-15.0 * d + 7.0 * v * h - w * h * h) / h.powi(4);
    let c5 = (6.0 * d - 3.0 * v * h + 0.5 * w * h * h) / h.powi(5);
    p[2] + 6.0 * c3 * x + 12.0 * c4 * x * x + 20.0 * c5 * x.powi(3)
}

#[test]
fn quintic_dialects_carry_a_law_of_degree_five_exactly_at_its_own_breaks() {
    let design = footbridge();
    let spans = design.cam.law.breaks().len() - 1;
    for (dialect, names) in [
        (Dialect::Codesys, ["dX := ", "dY := ", "dV := ", "dA := "]),
        (
            Dialect::Twincat,
            [
                "MasterPos := ",
                "SlavePos := ",
                "SlaveVelo := ",
                "SlaveAcc := ",
            ],
        ),
    ] {
        let made = make(&design, dialect, None).unwrap();
        assert_eq!(made.intervals, spans);
        assert!(made.replayed.share < 1e-12, "{}", made.replayed.share);
        let [x, y, v, a] = names.map(|name| numbers(&made.text, name));
        for value in x.iter().chain(&y).chain(&v).chain(&a) {
            assert!(*value == 0.0 || value.abs() > 1e-15, "{value}");
        }
        assert_eq!(x.len(), spans + 1);
        for i in 0..spans {
            let (h, at) = (x[i + 1] - x[i], |k: usize| [y[k], v[k], a[k]]);
            let middle = bend(h, at(i), at(i + 1), 0.5 * h);
            // mm/deg² to m/rad².
            let own = middle * 1e-3 * (360.0 / TAU).powi(2);
            let law = design.cam.law.svaj((x[i] + 0.5 * h).to_radians()).a;
            assert!((own - law).abs() < 1e-12, "{own} {law}");
        }
    }
}

#[test]
fn singles_cost_less_than_a_hundred_thousandth_of_the_weight_at_few_points_and_are_refused_at_many()
{
    let design = footbridge();
    let segments = make(&design, Dialect::Segments, None).unwrap();
    assert!(
        segments.replayed.share < 1e-5,
        "{}",
        segments.replayed.share
    );
    let chosen = make(&design, Dialect::Rockwell, None).unwrap();
    assert!(chosen.replayed.share < 0.005, "{}", chosen.replayed.share);
    let refused = make(&design, Dialect::Rockwell, Some(3600)).unwrap_err();
    assert_eq!(refused.code(), "write-ecam-points");
    let better = format!("--points {}", chosen.intervals);
    assert!(refused.to_string().contains(&better), "{refused}");
    make(&design, Dialect::Rockwell, Some(chosen.intervals)).unwrap();
}

#[test]
fn every_built_in_law_is_carried_within_the_stated_bound_or_refused_for_a_jump_of_its_acceleration()
{
    let (mut carried, mut refused) = (0, 0);
    for scene in &scene::SCENES {
        // Those that need no recording.
        let Ok(design) = scene.scene().and_then(|s| s.design()) else {
            continue;
        };
        if design.infeasible.is_some() {
            continue;
        }
        for dialect in Dialect::ALL {
            match make(&design, dialect, None) {
                Ok(made) => {
                    carried += 1;
                    assert!(
                        made.replayed.share <= 0.05,
                        "{} {dialect:?}",
                        design.problem.name
                    );
                    let total = made.replayed.error.unwrap_or(0.0);
                    assert!(
                        total
                            <= design.force.newtons(&design.problem.drive).rms_error_n
                                + made.replayed.added.unwrap_or(0.0)
                                + 1e-6 * total
                    );
                }
                Err(error) => {
                    refused += 1;
                    assert_eq!(
                        error.code(),
                        "write-ecam-law",
                        "{} {dialect:?}",
                        design.problem.name
                    );
                    let jumps = design
                        .cam
                        .law
                        .joints()
                        .iter()
                        .any(|j| j.jump.a.abs() > 1e-9);
                    assert!(jumps, "{} {dialect:?}: {error}", design.problem.name);
                }
            }
        }
    }
    println!("{carried} carried, {refused} refused");
    assert!(carried >= 60, "{carried}");
}

#[test]
fn intervals_out_of_range_and_laws_for_a_motor_are_refused_with_their_key() {
    let design = footbridge();
    for asked in [0, 1, 3, 32_767] {
        let error = make(&design, Dialect::Codesys, Some(asked)).unwrap_err();
        assert_eq!(error.code(), "write-ecam-intervals");
    }
    let motor = [
        "machine.motor.slope=10 N m s/rad",
        "machine.inertia=0.5 kg m^2",
    ];
    let design = gaitcam_test_support::design(scene::DEFAULT, &motor).unwrap();
    let error = make(&design, Dialect::Codesys, None).unwrap_err();
    assert_eq!(
        (error.code(), error.place.to_string()),
        ("write-ecam-of-motor".into(), "law.shaft: ".into())
    );
}
