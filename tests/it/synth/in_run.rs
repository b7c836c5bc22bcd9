//! A run is checked against the limits of its scene.

use std::f64::consts::TAU;

use gaitcam::cam::Verdict;
use gaitcam::drive::Drive;
use gaitcam::dynamics::{Model, Outcome, Row, simulate};
use gaitcam::scene::{self, MachineSpec};
use gaitcam::synth::{Design, Reason};
use gaitcam_test_support::{design_of, designed, designs, scene_file};

/// Run of a cam on a drive.
fn run(design: &Design, drive: Drive) -> Outcome {
    let machine = MachineSpec::default();
    simulate(&design.emitted(&machine, drive).unwrap(), Model::Rigid).unwrap()
}

fn most(run: &Outcome, value: impl Fn(&Row) -> f64) -> f64 {
    run.rows.iter().map(value).fold(f64::NEG_INFINITY, f64::max)
}

/// Largest value of each limit in a run, from its rows only. Velocity and acceleration are differences of the lift.
fn shown(run: &Outcome) -> Vec<(&'static str, f64, &'static str)> {
    let rows = &run.rows;
    let n = rows.len();
    let slope = |values: &[f64]| -> Vec<f64> {
        let turn = rows[0].speed.recip() * TAU / n as f64;
        let at = |i: usize| (values[(i + 1) % n] - values[(i + n - 1) % n]) / (2.0 * turn);
        (0..n).map(at).collect()
    };
    let lift: Vec<f64> = rows.iter().map(|row| row.lift).collect();
    let (v, a) = (slope(&lift), slope(&slope(&lift)));
    let largest = |values: &[f64]| values.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    vec![
        ("force_max", most(run, |row| row.contact_force), "N"),
        ("torque", most(run, |row| row.torque.abs()), "N m"),
        ("power", most(run, |row| row.power.abs()), "W"),
        ("velocity", largest(&v), "m/s"),
        ("acceleration", largest(&a), "m/s^2"),
    ]
}

#[test]
fn a_run_that_breaks_one_limit_is_unacceptable() {
    let text = scene_file("footbridge");
    let plain = ["accuracy.rms=none", "law.spans=12"];
    let design = design_of(&text, &plain);
    let drive = design.problem.drive;
    let own = shown(&run(&design, drive));
    for faster in [0.8, 1.0, 1.1, 1.25] {
        let drive = Drive {
            speed: faster * drive.speed,
            ..drive
        };
        let values = shown(&run(&design, drive));
        for ((name, value, _), (_, limit, unit)) in values.into_iter().zip(&own) {
            // Two per cent: no run at a speed that is tried lies so near to its limit.
            let limit = 1.02 * limit;
            let limited = design_of(
                &text,
                &[&plain[..], &[&format!("limits.{name}={limit} {unit}")]].concat(),
            );
            let run = run(&limited, drive);
            let judged = limited.on_drive(drive).judged_in(&run);
            let is_broken = value > limit;
            assert_eq!(
                judged.verdict == Verdict::Unacceptable,
                is_broken,
                "{name} at {faster}: {value} of {limit}"
            );
            let check = judged
                .checks
                .iter()
                .find(|c| c.name.name() == name)
                .unwrap();
            assert_eq!(check.pass, !is_broken, "{name}");
        }
    }
}

#[test]
fn what_is_said_of_a_broken_limit_has_the_number_of_the_run() {
    // The prescribed law breaks the limit at its own speed too.
    let design = design_of(
        &scene_file("thesis_iteration_4"),
        &["limits.force_max=10 N"],
    );
    let drive = design.problem.drive;
    let faster = Drive {
        speed: 1.3 * drive.speed,
        ..drive
    };
    let run = run(&design, faster);
    let judged = design.on_drive(faster).judged_in(&run);
    let check = judged.checks.iter().find(|c| c.name.name() == "force_max");
    let most = most(&run, |row| row.contact_force);
    assert!((check.unwrap().worst - most).abs() < 1e-3);
    let said = judged.reasons.iter().any(|reason| match reason {
        Reason::LimitBroken { value, .. } => (value.value - most).abs() < 1e-3,
        _ => false,
    });
    assert!(said, "{:?}", judged.reasons);
}

#[test]
fn mean_power_and_rate_of_the_torque_are_those_of_the_run() {
    let design = design_of(
        &scene_file("footbridge"),
        &[
            "drive.kind=fixed-axis",
            "drive.mass=71 kg",
            "drive.spring_rate=5 N/mm",
            "drive.damping=300 N s/m",
            "accuracy.rms=none",
            "limits.power_mean=1000 W",
            "limits.torque_rate=1000 N m/rad",
        ],
    );
    let drive = Drive {
        speed: 1.1 * design.problem.drive.speed,
        ..design.problem.drive
    };
    let run = run(&design, drive);
    // By the law alone: F·v at fine angles.
    let n = 36_000;
    let torque = |i: i32| {
        let at = design
            .cam
            .law
            .svaj(TAU * f64::from(i.rem_euclid(n)) / f64::from(n));
        drive.force(at) * at.v
    };
    let mean = drive.speed * (0..n).map(torque).sum::<f64>() / f64::from(n);
    let step = TAU / f64::from(n);
    let rates = (0..n).map(|i| ((torque(i + 1) - torque(i - 1)) / (2.0 * step)).abs());
    let steepest = rates.fold(0.0, f64::max);
    let judged = design.on_drive(drive).judged_in(&run);
    assert!(mean > 1.0);
    for (name, own) in [("power_mean", mean), ("torque_rate", steepest)] {
        let check = judged
            .checks
            .iter()
            .find(|c| c.name.name() == name)
            .unwrap();
        assert!(
            (check.worst / own - 1.0).abs() < 1e-3,
            "{name}: {} {own}",
            check.worst
        );
    }
}

#[test]
fn a_run_on_the_machine_of_the_design_has_its_verdict() {
    // Three scenes read their force from files.
    let of_file = ["heel_tester", "heel_tester_fitted", "measured_walk"];
    let names = scene::SCENES.iter().map(|scene| scene.name);
    let designs = names.filter(|name| !of_file.contains(name)).map(designed);
    for design in designs.chain([designs::heel_tester()]) {
        if design.infeasible.is_some() || design.shaft.is_some() {
            continue;
        }
        let run = run(&design, design.problem.drive);
        assert_eq!(
            design.clone().judged_in(&run).verdict,
            design.verdict,
            "{}",
            design.problem.name
        );
    }
}

#[test]
fn a_law_for_constant_speed_is_judged_under_its_motor() {
    // Ripple of 320 %: five times the weight.
    let motor = [
        "machine.motor.slope=1 N m s/rad",
        "machine.inertia=0.02 kg m^2",
        "law.shaft=constant",
    ];
    for limit in ["limits.force_max=1100 N", "limits.torque=17 N m"] {
        let design = design_of(&scene_file("footbridge"), &[&motor[..], &[limit]].concat());
        assert_eq!(design.verdict, Verdict::Unacceptable, "{limit}");
        assert!(
            design.checks.iter().filter(|c| !c.pass).count() >= 2,
            "{limit}"
        );
    }
}
