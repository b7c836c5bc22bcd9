use super::*;
use crate::cam::{Cam, Follower};
use crate::drive::{Drive, DriveKind};
use crate::dynamics::reason::{ForceMargin, LiftoffMargin, ModelReason, Vibration};
use crate::dynamics::thesis;
use crate::dynamics::{Face, Machine, Train};
use std::f64::consts::{PI, TAU};

fn scene(cam: &Cam, speed: f64) -> Run {
    Run {
        cam: cam.clone(),
        drive: thesis::real(speed),
        profile: cam.profile(1440),
        target: None,
        machine: Machine::default(),
    }
}

#[test]
fn rigid_and_contact_agree_on_the_thesis_cams_to_1e_6_newtons() {
    for cam in [thesis::eccentric(), thesis::double_harmonic()] {
        for speed in [thesis::SPEED, -thesis::SPEED, 20.0, 23.0] {
            let run = scene(&cam, speed);
            let (rigid, contact) = (
                simulate(&run, Model::Rigid).unwrap(),
                simulate(&run, Model::Contact).unwrap(),
            );
            assert!(!rigid.contact_lost && !contact.contact_lost);
            for (a, b) in rigid.rows.iter().zip(&contact.rows) {
                let law = run.drive.force(cam.law.svaj(a.theta));
                assert!(
                    (a.contact_force - b.contact_force).abs() < 1e-6,
                    "{a:?} {b:?}"
                );
                assert!(
                    (a.contact_force - law).abs() < 1e-6,
                    "{} {law}",
                    a.contact_force
                );
                assert!(
                    (a.torque - b.torque).abs() < 1e-8 && (a.theta - b.theta).abs() < 1e-12,
                    "{a:?} {b:?}"
                );
            }
            assert!((rigid.force.min - contact.force.min).abs() < 1e-12);
            assert!((rigid.torque.mean - contact.torque.mean).abs() < 1e-9);
        }
    }
}

#[test]
fn the_forces_of_campillos_cams_are_the_closed_forms() {
    for (cam, low, high) in [
        (thesis::eccentric(), 8.4588, 11.1612),
        (thesis::double_harmonic(), 7.40791, 11.16117),
    ] {
        let out = simulate(&scene(&cam, thesis::SPEED), Model::Contact).unwrap();
        assert!((out.force.min - low).abs() < 5e-5 && (out.force.max - high).abs() < 5e-5);
    }
}

#[test]
fn the_force_is_independent_of_the_number_of_points_beyond_second_order() {
    let cam = thesis::double_harmonic();
    let worst = |n: usize| {
        let run = Run {
            profile: cam.profile(n),
            ..scene(&cam, 23.0)
        };
        let out = simulate(&run, Model::Contact).unwrap();
        out.rows
            .iter()
            .map(|r| (r.contact_force - run.drive.force(cam.law.svaj(r.theta))).abs())
            .fold(0.0, f64::max)
    };
    // The error of a second-order interpolation of a would be (step²/8)·max|s''''|·Mω². Here s'''' is h/2·(π/β)⁴·5.
    let second_order = |n: usize| {
        let step = TAU / n as f64;
        step * step / 8.0 * 0.005 * (4.0_f64 / 3.0).powi(4) * 5.0 * 23.0 * 23.0
    };
    let errors: Vec<f64> = [360, 720, 1440, 2880, 5760]
        .iter()
        .map(|&n| worst(n))
        .collect();
    for (e, n) in errors.iter().zip([360, 720, 1440, 2880, 5760]) {
        assert!(*e < 0.1 * second_order(n), "{errors:?}");
    }
    assert!(
        errors[0] / errors[1] > 4.0 && errors[1] / errors[2] > 4.0,
        "{errors:?}"
    );
}

#[test]
fn reversed_rotation_mirrors_the_torque_and_keeps_the_force() {
    let cam = thesis::double_harmonic();
    let (there, back) = (
        simulate(&scene(&cam, 20.0), Model::Rigid).unwrap(),
        simulate(&scene(&cam, -20.0), Model::Rigid).unwrap(),
    );
    for (a, b) in there.rows.iter().zip(&back.rows) {
        assert!((a.theta - b.theta).abs() < 1e-12, "{a:?} {b:?}");
        assert!(
            (a.contact_force - b.contact_force).abs() < 1e-8,
            "{a:?} {b:?}"
        );
        assert!((a.torque - b.torque).abs() < 1e-10 && (a.power + b.power).abs() < 1e-8);
    }
    // The double harmonic is symmetric, so reversed rotation gives the same fraction without contact.
    let (a, b) = (
        simulate(&scene(&cam, 27.0), Model::Contact).unwrap(),
        simulate(&scene(&cam, -27.0), Model::Contact).unwrap(),
    );
    assert!((a.lost_fraction - b.lost_fraction).abs() < 1e-9);
    let friction = |speed: f64| {
        let mut run = scene(&cam, speed);
        run.machine.friction = 0.2;
        simulate(&run, Model::Contact).unwrap().torque.mean * speed
    };
    assert!(friction(20.0) > 0.0 && (friction(20.0) - friction(-20.0)).abs() < 1e-6);
}

#[test]
fn the_shaft_pays_for_what_the_impacts_lose() {
    // The mean torque, multiplied by the angle of one period, equals ½ m (u² − e²u²), summed over its impacts with the approach speeds u.
    for (cam, speed, e) in [
        (thesis::eccentric(), 35.0, 0.0),
        (thesis::double_harmonic(), 27.0, 0.5),
    ] {
        let mut run = scene(&cam, speed);
        run.machine.restitution = e;
        let out = simulate(&run, Model::Contact).unwrap();
        let hits: Vec<_> = out.impacts.iter().filter(|i| i.at < TAU).collect();
        let lost: f64 = hits
            .iter()
            .map(|i| 0.5 * (i.speed.powi(2) - i.pulse.rebound.powi(2)))
            .sum();
        assert!(
            (out.torque.mean * TAU - lost).abs() < 1e-9,
            "{} {lost}",
            out.torque.mean * TAU
        );
        assert!(lost > 0.0 && out.contact_lost);
    }
}

#[test]
fn the_target_error_is_measured_in_newtons() {
    let cam = thesis::eccentric();
    let mut run = scene(&cam, thesis::SPEED);
    run.target = Some(
        (0..360)
            .map(|i| run.drive.force(cam.law.svaj(f64::from(i).to_radians())) + 0.25)
            .collect(),
    );
    for model in [Model::Rigid, Model::Contact] {
        let error = simulate(&run, model).unwrap().force.rms_error.unwrap();
        assert!((error - 0.25).abs() < 1e-4, "{error}");
    }
    run.target = Some(vec![f64::NAN; 10]);
    assert!(simulate(&run, Model::Rigid).is_err());
}

#[test]
fn auto_is_rigid_where_rigid_is_enough_and_says_the_numbers() {
    let cam = thesis::double_harmonic();
    let mut run = scene(&cam, thesis::SPEED);
    run.machine.train = Some(Train::from_frequency(&run.drive, 80.0, 0.05).unwrap());
    let out = simulate(&run, Model::Auto).unwrap();
    assert_eq!(out.model, Model::Rigid);
    let ModelReason::HardlyVibrates {
        vibration: Vibration::Harmonics { frequency, .. },
        margin: ForceMargin::SmallestForce { liftoff, .. },
        ..
    } = out.why
    else {
        panic!("{:?}", out.why);
    };
    assert!((frequency.value - 80.0).abs() < 1e-9);
    assert!(
        matches!(liftoff, LiftoffMargin::LiftoffAt { liftoff, .. } if (liftoff.value - 23.49).abs() < 5e-3)
    );
    assert_eq!(out.next.as_ref().unwrap().model, Model::Flexible);

    run.machine.train = Some(Train::from_frequency(&run.drive, 12.0, 0.05).unwrap());
    let out = simulate(&run, Model::Auto).unwrap();
    assert_eq!(out.model, Model::Flexible);
    assert!(
        matches!(out.why, ModelReason::Vibrates { .. }),
        "{:?}",
        out.why
    );

    run.drive.speed = 23.0;
    let out = simulate(&run, Model::Auto).unwrap();
    assert_eq!(out.model, Model::Contact);
    assert!(
        matches!(
            out.why,
            ModelReason::LowForce { .. } | ModelReason::NearLiftoff { .. }
        ),
        "{:?}",
        out.why
    );
    run.machine.train = None;
    run.drive.speed = thesis::SPEED;
    let out = simulate(&run, Model::Auto).unwrap();
    assert_eq!(
        (out.model, out.next.unwrap().model),
        (Model::Rigid, Model::Contact)
    );
}

#[test]
fn the_forecast_of_auto_is_the_difference_the_flexible_run_makes() {
    let cam = thesis::double_harmonic();
    let mut run = scene(&cam, thesis::SPEED);
    run.machine.train = Some(Train::from_frequency(&run.drive, 25.0, 0.03).unwrap());
    run.target = Some(
        simulate(&run, Model::Rigid)
            .unwrap()
            .rows
            .iter()
            .map(|r| r.contact_force)
            .collect(),
    );
    let flexible = simulate(&run, Model::Flexible).unwrap();
    let percent = 100.0 * flexible.force.rms_error.unwrap() / 9.81;
    let out = simulate(&run, Model::Auto).unwrap();
    let (ModelReason::Vibrates { vibration, .. } | ModelReason::HardlyVibrates { vibration, .. }) =
        out.why
    else {
        panic!("{:?}", out.why);
    };
    assert!(
        matches!(vibration, Vibration::Harmonics { part, .. } if (100.0 * part.value - percent).abs() < 1e-3),
        "{vibration:?} {percent}"
    );
}

#[test]
fn a_hydraulic_machine_runs_under_every_model() {
    let cam = thesis::double_harmonic();
    let mut run = scene(&cam, 12.0);
    run.drive = Drive::hydraulic(1e9, 0.02, 12.0);
    for model in [Model::Rigid, Model::Contact, Model::Auto] {
        let out = simulate(&run, model).unwrap();
        assert!(!out.contact_lost, "{:?}", out.force);
        let most = run.drive.spring_rate * 0.01;
        assert!((out.force.max - most).abs() < 1e-6 * most);
        assert_eq!(out.liftoff_speed, None);
    }
    assert!(simulate(&run, Model::Flexible).is_err());
    run.machine.train = Some(Train {
        stiffness: 9.0 * run.drive.spring_rate,
        damping: 0.0,
    });
    let out = simulate(&run, Model::Flexible).unwrap();
    assert!((out.force.max / (0.9 * run.drive.spring_rate * 0.01) - 1.0).abs() < 1e-6);
}

#[test]
fn two_cams_strike_where_one_takes_over_from_the_other() {
    let cam = thesis::double_harmonic();
    let mut run = scene(&cam, thesis::SPEED);
    run.machine.second_cam = Some(std::f64::consts::PI);
    let out = simulate(&run, Model::Auto).unwrap();
    assert_eq!(out.model, Model::Contact);
    assert!(!out.contact_lost && out.impacts.len() >= 2);
    for model in [Model::Rigid, Model::Contact] {
        run.drive.speed = -thesis::SPEED;
        assert!(simulate(&run, model).is_ok());
    }
}

#[test]
fn machines_that_cannot_be_are_refused() {
    let good = scene(&thesis::eccentric(), 10.0);
    let refuse = |change: &dyn Fn(&mut Run)| {
        let mut run = good.clone();
        change(&mut run);
        assert!(simulate(&run, Model::Auto).is_err());
    };
    refuse(&|r| r.drive.mass = f64::NAN);
    refuse(&|r| r.drive.mass = -1.0);
    refuse(&|r| r.machine.friction = -0.1);
    refuse(&|r| r.machine.restitution = 1.5);
    refuse(&|r| r.profile.truncate(700));
    refuse(&|r| r.drive.speed = f64::INFINITY);
}

#[test]
fn a_slow_or_standing_shaft_gives_the_static_force_in_every_model() {
    let cam = thesis::double_harmonic();
    let mut run = scene(&cam, 0.0);
    run.drive = Drive {
        kind: DriveKind::FixedAxis,
        rest_force: 5.0,
        spring_rate: 800.0,
        damping: 3.0,
        mass: 1.0,
        speed: 0.0,
        lever: 1.0,
    };
    run.machine.train = Some(Train {
        stiffness: 1e9,
        damping: 10.0,
    });
    for speed in [0.0, -1e-9, 1e-300] {
        run.drive.speed = speed;
        for model in [Model::Rigid, Model::Flexible, Model::Contact, Model::Auto] {
            let out = simulate(&run, model).unwrap();
            assert!(
                (out.force.max - 13.0).abs() < 1e-4,
                "{speed} {model:?} {}",
                out.force.max
            );
            assert!(!out.contact_lost);
        }
    }
}

#[test]
fn an_emitted_roller_cam_presses_as_its_law_says_and_lifts_off_with_it() {
    // A knife edge determines only heights, so a spline also gives its slopes. Where the fourth derivative jumps, the order is one lower.
    for (roller_radius, near) in [(0.01, 1e-6), (0.0, 1e-5)] {
        let cam = Cam {
            law: thesis::double_harmonic().law,
            follower: crate::cam::Follower::RollerTranslating {
                prime_radius: 0.04,
                offset: 0.005,
                roller_radius,
            },
        };
        let run = scene(&cam, 20.0);
        let out = simulate(&run, Model::Contact).unwrap();
        for r in &out.rows {
            let law = run.drive.force(cam.law.svaj(r.theta));
            assert!(
                (r.contact_force - law).abs() < near,
                "{roller_radius} {} {law}",
                r.contact_force
            );
            assert!(
                r.normal_force >= r.contact_force && (r.sliding == 0.0) == (roller_radius > 0.0)
            );
        }
        assert!((out.liftoff_speed.unwrap() - 23.490690).abs() < 5e-7);
        assert!(
            simulate(&scene(&cam, 27.0), Model::Auto)
                .unwrap()
                .contact_lost
        );
    }
}

#[test]
fn hertz_pressure_of_the_run_is_that_of_its_worst_angle() {
    use crate::dynamics::hertz;
    let cam = thesis::double_harmonic();
    let mut run = scene(&cam, thesis::SPEED);
    run.machine.face = Some(Face {
        length: 0.01,
        cam: hertz::STEEL,
        follower: hertz::STEEL,
    });
    let found = simulate(&run, Model::Rigid).unwrap().hertz.unwrap();
    let star = hertz::modulus(hertz::STEEL, hertz::STEEL);
    let worst = (0..1440)
        .map(|i| cam.law.svaj(TAU * f64::from(i) / 1440.0))
        .map(|at| hertz::line(run.drive.force(at), 0.01, 1.0 / (0.03 + at.s + at.a), star).pressure)
        .fold(0.0, f64::max);
    assert!((found.contact.pressure / worst - 1.0).abs() < 1e-9);
    assert!(simulate(&run, Model::Auto).unwrap().hertz.is_some());
}

#[test]
fn width_and_shear_depth_of_the_worst_contact_carry_its_force() {
    use crate::dynamics::hertz;
    let law = thesis::double_harmonic().law;
    let flat = Follower::FlatTranslating { base_radius: 0.03 };
    let roller = Follower::RollerTranslating {
        prime_radius: 0.05,
        offset: 0.004,
        roller_radius: 0.01,
    };
    for follower in [flat, roller] {
        let cam = Cam::new(law.clone(), follower).unwrap();
        let mut run = scene(&cam, thesis::SPEED);
        run.machine.face = Some(Face {
            length: 0.01,
            cam: hertz::STEEL,
            follower: hertz::STEEL,
        });
        for model in [Model::Rigid, Model::Contact] {
            let worst = simulate(&run, model).unwrap().hertz.unwrap();
            let contact = worst.contact;
            // The pressure is semi-elliptic over the half-width b: N = π b p₀ L/2 (Johnson 1985, eq. 4.45).
            let carried = 0.5 * PI * contact.half_width * contact.pressure * 0.01;
            let at = cam.law.svaj(worst.theta);
            let normal = run.drive.force(at) / cam.point(worst.theta).pressure_angle.cos();
            let apart = (carried / normal - 1.0).abs();
            assert!(apart < 1e-4, "{follower:?} {model:?}: {carried} {normal}");
            assert!((contact.shear_depth / contact.half_width - 0.786).abs() < 1e-12);
        }
    }
}

#[test]
fn friction_turns_a_face_on_a_base_circle_without_radius_too() {
    let law = thesis::eccentric().law;
    let law = law.raised(0.002 - law.extremes(0).0.value);
    for base_radius in [0.0, 0.001, 0.03] {
        let follower = Follower::FlatTranslating { base_radius };
        let cam = Cam {
            law: law.clone(),
            follower,
        };
        let mut run = scene(&cam, 11.624);
        run.machine.friction = 0.12;
        let outcome = simulate(&run, Model::Rigid).unwrap();
        let rows = &outcome.rows;
        let mean = rows.iter().map(|row| row.torque).sum::<f64>() / rows.len() as f64;
        assert!(mean > 1e-4);
        assert!(
            (outcome.torque.mean / mean - 1.0).abs() < 1e-6,
            "{base_radius}"
        );
        let most = rows.iter().map(|row| row.torque).fold(f64::MIN, f64::max);
        assert!(
            (outcome.torque.max / most - 1.0).abs() < 1e-5,
            "{base_radius}"
        );
    }
}
