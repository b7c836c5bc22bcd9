//! Simulations of every follower: with the rigid model for all, with the contact model for those that can lift off.

use super::*;
use crate::cam::{Cam, Closure, Conjugate, Follower};
use crate::drive::Drive;
use crate::dynamics::Machine;
use crate::dynamics::reason::RunNote;
use crate::dynamics::rigid::touch::tests::everything;
use crate::law::Law;

fn law(stroke: f64) -> Law {
    Law::harmonic(0.5 * stroke, &[(-0.5 * stroke, 0.0)])
}

fn run(cam: Cam, speed: f64) -> Run {
    let drive = Drive {
        spring_rate: 400.0,
        rest_force: 6.0,
        ..crate::dynamics::thesis::ideal(speed)
    };
    Run {
        profile: cam.profile(1440),
        cam,
        drive,
        target: None,
        machine: Machine::default(),
    }
}

#[test]
fn every_follower_runs_rigid_and_in_contact_alike_below_lift_off() {
    for (follower, stroke) in everything() {
        let cam = Cam {
            law: law(stroke),
            follower,
        };
        let input = run(cam, 5.0);
        let what = follower.name();
        let rigid = simulate(&input, Model::Rigid).unwrap();
        let contact = simulate(&input, Model::Contact).unwrap();
        assert!(!contact.contact_lost, "{what}");
        for (i, (a, b)) in rigid.rows.iter().zip(&contact.rows).enumerate() {
            let at = input.cam.law.svaj(a.theta);
            let force = input.drive.force(at);
            assert!((a.contact_force - force).abs() < 1e-6, "{what} row {i}");
            assert!(
                (a.contact_force - b.contact_force).abs() < 1e-6,
                "{what} row {i}"
            );
            assert!((a.torque - force * at.v).abs() < 1e-6, "{what} row {i}");
        }
        // Without friction, the mean torque over the turn is zero.
        let range = rigid.torque.max - rigid.torque.min;
        assert!(rigid.torque.mean.abs() < 1e-10 * range, "{what}");
    }
}

#[test]
fn every_follower_lifts_off_where_its_own_force_ends() {
    for (follower, stroke) in everything() {
        let cam = Cam {
            law: law(stroke),
            follower,
        };
        // For s = h/2 (1 − cos θ), lift-off occurs at the top.
        let input = run(cam, 5.0);
        let d = input.drive;
        let half = 0.5 * stroke;
        // At θ = π: F = F₀ + 2kh/2 − mω²h/2 = 0.
        let expected = ((d.rest_force + 2.0 * d.spring_rate * half) / (d.mass * half)).sqrt();
        let rigid = simulate(&input, Model::Rigid).unwrap();
        let own = rigid.liftoff_speed.unwrap();
        assert!(
            (own / expected - 1.0).abs() < 1e-6,
            "{}: {own} {expected}",
            follower.name()
        );
        for (factor, lost) in [(0.999, false), (1.01, true)] {
            let mut fast = input.clone();
            fast.drive.speed = expected * factor;
            let out = simulate(&fast, Model::Contact).unwrap();
            assert_eq!(out.contact_lost, lost, "{} at {factor}", follower.name());
        }
    }
}

#[test]
fn rubbing_costs_work_and_rolling_does_not() {
    for (follower, stroke) in everything() {
        let mut input = run(
            Cam {
                law: law(stroke),
                follower,
            },
            5.0,
        );
        input.machine.friction = 0.1;
        let out = simulate(&input, Model::Rigid).unwrap();
        let rolls = !follower.is_flat() && follower.name().starts_with("roller");
        let range = out.torque.max - out.torque.min;
        assert_eq!(out.torque.mean < 1e-9 * range, rolls, "{}", follower.name());
        let contact = simulate(&input, Model::Contact).unwrap();
        assert!(
            (contact.torque.mean - out.torque.mean).abs() < 1e-6 * range,
            "{}: {} {}",
            follower.name(),
            contact.torque.mean,
            out.torque.mean
        );
    }
}

#[test]
fn a_pair_never_lifts_off_and_says_which_cam_bears() {
    let first = Cam {
        law: law(0.02),
        follower: Follower::RollerTranslating {
            prime_radius: 0.06,
            offset: 0.0,
            roller_radius: 0.01,
        },
    };
    let pair = Conjugate::new(&first, Closure::SecondBaseRadius(0.06), None).unwrap();
    let mut input = run(first, 60.0);
    input.drive.spring_rate = 0.0;
    input.machine.conjugate = Some(pair.second.clone());
    let out = simulate(&input, Model::Auto).unwrap();
    assert_eq!(out.model, Model::Rigid);
    assert!(!out.contact_lost && out.liftoff_speed.is_none());
    assert!(out.force.min < 0.0);
    let bears = |n: &RunNote| matches!(n, RunNote::SecondCamBears { .. });
    assert!(out.notes.iter().any(bears), "{:?}", out.notes);
    for (i, row) in out.rows.iter().enumerate() {
        assert!(row.normal_force >= 0.0, "{i}");
        // Both cams act on the same coordinate s: (N n)·G is the force for either cam.
        if row.contact_force < 0.0 {
            let p = pair.second.point(row.theta);
            let expected = -row.contact_force / p.pressure_angle.cos();
            assert!((row.normal_force - expected).abs() < 1e-6, "{i}");
        }
    }
    let refused = simulate(&input, Model::Contact).unwrap_err().to_string();
    assert!(refused.contains("on both sides"), "{refused}");
}

#[test]
fn slides_and_grooves_run_rigid_and_say_why_not_in_contact() {
    for (cam, word) in crate::dynamics::rigid::touch::tests::slides()
        .into_iter()
        .zip(["turns once per cycle", "on both sides"])
    {
        let input = run(cam, 3.0);
        let out = simulate(&input, Model::Auto).unwrap();
        assert_eq!(out.model, Model::Rigid);
        let (start, length) = input.cam.law.extent();
        // Where the jerk of the programme jumps, the spline through the points deviates by a fraction of a step.
        let slack = 3e-3 * out.force.max.abs().max(out.force.min.abs());
        for row in &out.rows {
            assert!(row.theta >= start - 1e-12 && row.theta <= start + length + 1e-12);
            let at = input.cam.law.svaj(row.theta);
            assert!((row.contact_force - input.drive.force(at)).abs() < slack);
        }
        let refused = simulate(&input, Model::Contact).unwrap_err().to_string();
        assert!(refused.contains(word), "{refused}");
    }
}

/// Maximum normal force and maximum lateral force over the exact law, for one cam or for the more loaded cam of a pair.
fn true_loads(input: &Run) -> [f64; 2] {
    const POINTS: usize = 100_000;
    let follower = |cam: &Cam, at, force| {
        let friction = input.machine.friction * input.drive.speed.signum();
        crate::dynamics::touch(&cam.follower, input.drive.speed, friction, at, force)
    };
    let length = input.cam.law.extent().1;
    let loads = (0..POINTS).map(|i| {
        let theta = length * i as f64 / POINTS as f64;
        let at = input.cam.law.svaj(theta);
        let force = input.drive.force(at);
        match &input.machine.conjugate {
            Some(second) if force < 0.0 => follower(second, second.law.svaj(theta), -force),
            _ => follower(&input.cam, at, force),
        }
    });
    loads.fold([0.0; 2], |[normal, side], touch| {
        [
            touch.normal.abs().max(normal),
            touch.side_thrust.abs().max(side),
        ]
    })
}

#[test]
fn the_largest_loads_are_those_between_the_rows_whatever_the_follower() {
    let mut inputs: Vec<Run> = everything()
        .into_iter()
        .map(|(follower, stroke)| {
            // The maxima of the force are not at rows.
            let half = 0.5 * stroke;
            let law = Law::harmonic(half, &[(-0.8 * half, 0.31 * half), (0.1 * half, 0.0)]);
            let mut input = run(Cam { law, follower }, 5.0);
            input.profile = input.cam.profile(720);
            input.machine.friction = 0.1;
            input
        })
        .collect();
    let first = Cam {
        law: law(0.02),
        follower: Follower::RollerTranslating {
            prime_radius: 0.06,
            offset: 0.004,
            roller_radius: 0.01,
        },
    };
    let pair = Conjugate::new(&first, Closure::SecondBaseRadius(0.06), None).unwrap();
    let mut both = run(first, 60.0);
    both.drive.spring_rate = 0.0;
    both.machine.conjugate = Some(pair.second);
    inputs.push(both);
    let mut missed = 0;
    for input in &inputs {
        for speed in [1.0, -1.0] {
            let mut input = input.clone();
            input.drive.speed *= speed;
            let what = input.cam.follower.name();
            let out = simulate(&input, Model::Rigid).unwrap();
            let told = [out.loads.normal_force, out.loads.side_thrust];
            let of_rows = out.rows.iter().fold([0.0_f64; 2], |[normal, side], row| {
                [
                    row.normal_force.abs().max(normal),
                    row.side_thrust.abs().max(side),
                ]
            });
            for ((told, truth), row) in told.into_iter().zip(true_loads(&input)).zip(of_rows) {
                let scale = truth.max(1e-6);
                assert!(
                    (told - truth).abs() < 1e-6 * scale,
                    "{what} {speed}: {told} {truth} {row}"
                );
                missed += usize::from((row - truth).abs() > 2e-6 * scale);
            }
        }
    }
    assert!(missed > 4, "rows alone are right in all but {missed}");
}
