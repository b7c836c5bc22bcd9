//! A recorded walk: its response against direct integration, and cams that follow its steps.

use std::f64::consts::TAU;

use gaitcam::Scene;
use gaitcam::drive::{Motor, TorqueLine};
use gaitcam::dynamics::{Bounds, Followed, ProgrammeRun, Run};
use gaitcam::error::DynamicsError;
use gaitcam::force::{Feet, ForceCurve, ReadOptions, Walk, force_curve};
use gaitcam::scene::{built_in, read, set};
use gaitcam::synth::Design;

const WALK: &[u8] = include_bytes!("../../../data/recordings/made_long_walk.csv");
const FREE: Bounds = Bounds {
    acceleration: f64::INFINITY,
    force_min: 0.0,
};

fn recorded() -> ForceCurve {
    let options = ReadOptions::default();
    force_curve("walk.csv".as_ref(), WALK, &options, Feet::Both).unwrap()
}

fn designed() -> (Scene, Design) {
    let mut table = built_in("measured_walk").unwrap().toml.parse().unwrap();
    set(&mut table, "gait.file=walk.csv").unwrap();
    let scene = read(&table).unwrap();
    let design = scene.design_for(&recorded()).unwrap();
    (scene, design)
}

fn followed(run: &Run, walk: &Walk, bounds: Bounds) -> Followed {
    Followed::new(run, walk, 2, 0.0, walk.middle(), bounds).unwrap()
}

#[test]
fn the_generated_walk_has_the_statistics_of_its_generator() {
    let walk = recorded().walk.unwrap();
    let of = walk.variability();
    // 96 steps of 1/1.9 s with a variation of 2.5 %: standard errors of 0.2 % of the variation and 0.1 of the correlation.
    assert_eq!((of.strides, of.runs), (48, 1));
    assert!((of.step_time_s * 1.9 - 1.0).abs() < 0.01);
    assert!(
        (of.step_time_cv - 0.025).abs() < 0.004,
        "{}",
        of.step_time_cv
    );
    assert!(
        (of.autocorrelation - 0.3).abs() < 0.25,
        "{}",
        of.autocorrelation
    );
    assert!(!walk.changes_pace());
}

#[test]
fn a_cam_that_follows_a_walk_has_its_steps_and_its_response() {
    let (scene, design) = designed();
    let walk = design.walk().unwrap();
    let run = design
        .emitted(&scene.machine, design.problem.drive)
        .unwrap();
    let found = followed(&run, &walk, FREE);
    assert!(found.step_error_s < 1e-9);
    assert!(!found.run.contact_lost);
    let turns = found.run.angle[found.run.angle.len() - 1] / TAU;
    assert!((turns - 48.0).abs() < 1e-4);
    let ratio = design.walker().unwrap().resonance[1].ratio;
    assert!(ratio > 1.1, "{ratio}");
    for of in found.misfits {
        assert!(
            of.misfit < 0.15 && (of.peak_ratio - 1.0).abs() < 0.1,
            "{of:?}"
        );
    }
}

#[test]
fn a_bound_on_the_acceleration_is_kept() {
    let (scene, design) = designed();
    let walk = design.walk().unwrap();
    let run = design
        .emitted(&scene.machine, design.problem.drive)
        .unwrap();
    let most = |found: &Followed| {
        found
            .run
            .acceleration
            .iter()
            .fold(0.0, |m: f64, a| m.max(a.abs()))
    };
    let free = followed(&run, &walk, FREE);
    let bound = 0.25 * most(&free);
    let slow = followed(
        &run,
        &walk,
        Bounds {
            acceleration: bound,
            ..FREE
        },
    );
    assert!(most(&slow) <= bound * (1.0 + 1e-9) && most(&slow) > 0.9 * bound);
    assert!(slow.step_error_s > free.step_error_s);
    let high = Bounds {
        force_min: 1e4,
        ..FREE
    };
    let fault = Followed::new(&run, &walk, 2, 0.0, 0.5, high).unwrap_err();
    assert!(matches!(
        fault.fault::<DynamicsError>(),
        Some(DynamicsError::ProgrammeContact { .. })
    ));
}

#[test]
fn a_motor_under_the_commanded_speed_turns_as_prescribed() {
    let (scene, design) = designed();
    let walk = design.walk().unwrap();
    let mut run = design
        .emitted(&scene.machine, design.problem.drive)
        .unwrap();
    let motor = Motor {
        line: TorqueLine::Slope(20.0),
        nominal: None,
        inertia: 0.5,
        friction: 0.5,
        gear: 1.0,
        efficiency: 1.0,
    };
    run.machine.motor = Some(motor.clone());
    let found = followed(&run, &walk, FREE);
    let own = ProgrammeRun::new(&run, &found.programme, found.run.angle[0]).unwrap();
    let off = own
        .speed
        .iter()
        .zip(&found.run.speed)
        .map(|(a, b)| (a / b - 1.0).abs());
    assert!(off.fold(0.0, f64::max) < 5e-3);
    // The command runs ahead by what the motor needs for its torque.
    let ahead = found
        .programme
        .speed
        .iter()
        .zip(&found.run.speed)
        .zip(&found.run.torque);
    for ((command, speed), torque) in ahead {
        assert!((20.0 * (command - speed) - torque).abs() < 1e-6);
    }
    let slowest = found
        .programme
        .speed
        .iter()
        .copied()
        .fold(f64::INFINITY, f64::min);
    run.machine.motor = Some(Motor {
        nominal: Some(slowest),
        ..motor
    });
    let fault = Followed::new(&run, &walk, 2, 0.0, 0.5, FREE).unwrap_err();
    assert!(matches!(
        fault.fault::<DynamicsError>(),
        Some(DynamicsError::ProgrammeMotor { .. })
    ));
}
