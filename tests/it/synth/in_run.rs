//! A run is judged by the limits of its scene.

use gaitcam::cam::Verdict;
use gaitcam::drive::Drive;
use gaitcam::dynamics::{Model, Outcome, Row, simulate};
use gaitcam::scene::{self, MachineSpec};
use gaitcam::synth::Design;
use gaitcam_test_support::{design_of, designed, designs, scene_file};

/// The run of a cam on a drive.
fn run(design: &Design, drive: Drive) -> Outcome {
    let machine = MachineSpec::default();
    simulate(&design.emitted(&machine, drive).unwrap(), Model::Rigid).unwrap()
}

fn most(run: &Outcome, value: impl Fn(&Row) -> f64) -> f64 {
    run.rows.iter().map(value).fold(f64::NEG_INFINITY, f64::max)
}

/// The largest value of each limit in a run by its rows alone; velocity and acceleration by differences of the lift.
fn shown(run: &Outcome) -> Vec<(&'static str, f64, &'static str)> {
    let rows = &run.rows;
    let n = rows.len();
    let slope = |values: &[f64]| -> Vec<f64> {
        let turn = rows[0].speed.recip() * std::f64::consts::TAU / n as f64;
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
