//! Limiting cases of [`simulate`]: noise, reversed rotation, no damping, resonance.

use super::*;
use crate::cam::Cam;
use crate::drive::Drive;
use crate::dynamics::reason::{ForceMargin, ModelReason};
use crate::dynamics::thesis;
use crate::dynamics::{Machine, Train};
use crate::law::{Extent, Law, Rise, Segment, program};
use crate::wording::Language;
use std::f64::consts::{PI, TAU};

fn run(cam: &Cam, speed: f64, train: Option<Train>) -> Run {
    Run {
        profile: cam.profile(1440),
        cam: cam.clone(),
        drive: thesis::real(speed),
        target: None,
        machine: Machine {
            train,
            ..Machine::default()
        },
    }
}

/// A cam with an asymmetric lift.
fn leaning() -> Cam {
    Cam {
        law: Law::harmonic(0.012, &[(0.0, 0.008), (0.002, 0.001), (0.0, -0.0006)]),
        ..thesis::eccentric()
    }
}

/// Force of a flexible follower at a cam angle, from the gain of every harmonic of [`leaning`]: M g − M n²ω² Re[Y (k₁ + i c₁ nω)/(k₁ − M n²ω² + i c₁
/// nω) e^{inθ}]. A negative ω turns the cam backwards.
fn leaning_force(theta: f64, speed: f64, stiffness: f64, damping: f64) -> f64 {
    let mut force = thesis::MASS * crate::units::G;
    for (k, (cos, sin)) in [(0.0, 0.008), (0.002, 0.001), (0.0, -0.0006)]
        .into_iter()
        .enumerate()
    {
        let nw = (k + 1) as f64 * speed;
        let inertia = thesis::MASS * nw * nw;
        let (a, b) = (stiffness, damping * nw);
        let (c, d) = (stiffness - inertia, damping * nw);
        let square = c * c + d * d;
        let (re, im) = ((a * c + b * d) / square, (b * c - a * d) / square);
        // Complex amplitude Y = cos − i sin.
        let (y_re, y_im) = (cos * re + sin * im, cos * im - sin * re);
        let phase = (k + 1) as f64 * theta;
        force -= inertia * (y_re * phase.cos() - y_im * phase.sin());
    }
    force
}

#[test]
fn a_flexible_run_is_the_closed_form_forwards_backwards_and_without_damping() {
    let cam = leaning();
    for ratio in [0.0, 0.05] {
        let train = Train::from_frequency(&thesis::real(thesis::SPEED), 9.0, ratio).unwrap();
        let Train { stiffness, damping } = train;
        for speed in [thesis::SPEED, -thesis::SPEED] {
            let out = simulate(&run(&cam, speed, Some(train)), Model::Flexible).unwrap();
            for row in &out.rows {
                let exact = leaning_force(row.theta, speed, stiffness, damping);
                assert!(
                    (row.contact_force - exact).abs() < 1e-6,
                    "{ratio} {speed} {row:?} {exact}"
                );
            }
        }
    }
    // Reversed rotation gives another force curve, because damping shifts its phase in the opposite direction.
    let train = Train::from_frequency(&thesis::real(thesis::SPEED), 9.0, 0.05).unwrap();
    let [there, back] = [1.0, -1.0].map(|sign| {
        let out = simulate(
            &run(&cam, sign * thesis::SPEED, Some(train)),
            Model::Flexible,
        );
        out.unwrap().rows[200].contact_force
    });
    assert!((there - back).abs() > 1e-3);
}

#[test]
fn resonance_is_named_by_every_way_to_it_and_a_hair_beside_it_is_a_large_number() {
    let cam = leaning();
    let natural = |ratio: f64| {
        let hertz = ratio * thesis::SPEED / TAU;
        Train::from_frequency(&thesis::real(thesis::SPEED), hertz, 0.0).unwrap()
    };
    for model in [Model::Flexible, Model::Auto] {
        let message = simulate(&run(&cam, thesis::SPEED, Some(natural(3.0))), model)
            .unwrap_err()
            .to_string();
        assert!(
            message.contains("resonance") && message.contains(" 3 times"),
            "{message}"
        );
    }
    for beside in [1e-3, -1e-3, 1e-6, -1e-6] {
        let train = natural(3.0 * (1.0 + beside));
        let out = simulate(&run(&cam, thesis::SPEED, Some(train)), Model::Flexible).unwrap();
        // Only the third harmonic grows: M 9ω² 0.6 mm/|1 − 1/(1 + b)²| ≈ M 9ω² 0.6 mm/(2 |b|), with the relative distance b from resonance.
        let own = thesis::MASS * (3.0 * thesis::SPEED).powi(2) * 0.0006 / (2.0 * f64::abs(beside));
        let half = 0.5 * (out.force.max - out.force.min);
        assert!((half / own - 1.0).abs() < 0.05, "{beside} {half} {own}");
        assert!(out.contact_lost);
    }
}

/// Rise, dwell, fall and dwell, with a noise of one micrometre on every point.
#[test]
fn noise_in_a_dwell_rings_no_more_than_its_own_acceleration() {
    let segment = |motion: &str, lift: f64| Segment {
        motion: Rise::from_name(motion).unwrap(),
        lift,
        angle: 0.5 * PI,
    };
    let parts = [
        segment("dwell", 0.0),
        segment("4-5-6-7", 0.01),
        segment("dwell", 0.0),
        segment("4-5-6-7", -0.01),
    ];
    let cam = Cam {
        law: program(&parts, Extent::TURN).unwrap(),
        ..thesis::eccentric()
    };
    let train = Train::from_frequency(&thesis::real(thesis::SPEED), 40.0, 0.05).unwrap();
    let clean = simulate(&run(&cam, thesis::SPEED, Some(train)), Model::Flexible).unwrap();
    let mut noisy = run(&cam, thesis::SPEED, Some(train));
    let mut seed = 2024_u64;
    let mut noise = || {
        seed = seed
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        ((seed >> 33) as f64 / f64::from(1_u32 << 31) - 1.0) * 1e-6
    };
    for p in &mut noisy.profile {
        p.x += noise();
        p.y += noise();
    }
    let apart = |out: &Outcome| {
        out.rows
            .iter()
            .zip(&clean.rows)
            .filter(|(_, b)| b.theta < 0.5 * PI - 0.05)
            .map(|(a, b)| (a.contact_force - b.contact_force).abs())
            .fold(0.0, f64::max)
    };
    for model in [Model::Flexible, Model::Contact, Model::Rigid] {
        let out = simulate(&noisy, model).unwrap();
        assert!(!out.contact_lost && out.force.min > 5.0, "{model:?}");
    }
    let rough = simulate(&noisy, Model::Flexible).unwrap();
    // In the rigid model, ω²M·1 µm/step is 0.03 N, and the curvature of the spline triples it. The natural frequency of the train, 40 Hz,
    // is far below the 2600 points per second, so the train transmits less.
    assert!(apart(&rough) < 0.05, "{}", apart(&rough));
}

#[test]
fn the_torque_of_an_emitted_profile_integrates_to_zero_too() {
    for cam in [thesis::eccentric(), thesis::double_harmonic(), leaning()] {
        for model in [Model::Rigid, Model::Contact] {
            let out = simulate(&run(&cam, thesis::SPEED, None), model).unwrap();
            let range = out.torque.max - out.torque.min;
            let bound = if model == Model::Rigid { 1e-10 } else { 1e-8 };
            assert!(
                (out.torque.mean * TAU).abs() < bound * range,
                "{model:?} {:e} of {range}",
                out.torque.mean
            );
        }
    }
}

#[test]
fn a_machine_without_force_is_said_to_have_none() {
    let mut none = run(&leaning(), 3.0, None);
    none.drive = Drive {
        mass: 0.0,
        rest_force: 0.0,
        ..none.drive
    };
    let out = simulate(&none, Model::Auto).unwrap();
    assert!(
        matches!(
            out.why,
            ModelReason::NothingVibrates {
                margin: ForceMargin::NoForce
            }
        ),
        "{:?}",
        out.why
    );
    // A pure inertia force has equal positive and negative parts.
    none.drive.mass = 1.0;
    let out = simulate(&none, Model::Auto).unwrap();
    let why = out.why.sentence(Language::En);
    assert!(out.contact_lost && !why.contains('–'), "{why}");
}

/// Fluid on a cam with a dwell. In the dwell, the lift of the emitted points is zero within the error of their spline. This error must not
/// count as a lift-off.
#[test]
fn a_dwell_known_to_rounding_is_no_pull() {
    let segment = |motion: &str, lift: f64| Segment {
        motion: Rise::from_name(motion).unwrap(),
        lift,
        angle: 2.0 * PI / 3.0,
    };
    let parts = [
        segment("dwell", 0.0),
        segment("3-4-5", 0.03),
        segment("3-4-5", -0.03),
    ];
    let cam = Cam {
        law: program(&parts, Extent::TURN).unwrap(),
        ..thesis::eccentric()
    };
    let mut fluid = run(&cam, 12.566, None);
    fluid.drive = Drive::hydraulic(1.2e10, 0.019, 12.566);
    let out = simulate(&fluid, Model::Auto).unwrap();
    assert_eq!(
        (out.model, out.liftoff_speed),
        (Model::Rigid, None),
        "{:?}",
        out.why
    );
}

/// Simple-harmonic rise and fall of 30 mm in 120° each, with dwells of 60°, on a spring.
fn spring_loaded(preload: f64) -> Run {
    let part = |motion: &str, lift: f64, degrees: f64| Segment {
        motion: Rise::from_name(motion).unwrap(),
        lift,
        angle: degrees.to_radians(),
    };
    let parts = [
        part("simple-harmonic", 0.03, 120.0),
        part("dwell", 0.0, 60.0),
        part("simple-harmonic", -0.03, 120.0),
        part("dwell", 0.0, 60.0),
    ];
    let cam = Cam {
        law: program(&parts, Extent::TURN).unwrap(),
        follower: crate::cam::Follower::FlatTranslating { base_radius: 0.06 },
    };
    let drive = Drive {
        kind: crate::drive::DriveKind::FixedAxis,
        rest_force: preload,
        spring_rate: 2000.0,
        ..thesis::ideal(20.0)
    };
    Run::new(cam, drive, 1440)
}

#[test]
fn a_jump_of_acceleration_brings_no_false_lift_off() {
    // Lift-off at the top: F₀ + k h = m ω² ½ h (π/β)².
    for preload in [1.0, 3.0, 10.0] {
        let out = simulate(&spring_loaded(preload), Model::Rigid).unwrap();
        let exact = ((preload + 60.0) / 0.03375_f64).sqrt();
        let got = out.liftoff_speed.unwrap();
        assert!(
            (got / exact - 1.0).abs() < 1e-6,
            "{preload} N: {got} {exact}"
        );
        assert!(!out.contact_lost);
        // F = F₀ + k s + m ω² a is minimum at the end of the fall.
        assert!((out.force.min - preload).abs() < 1e-6, "{}", out.force.min);
    }
}

#[test]
fn a_force_that_touches_zero_in_a_dwell_is_no_lift_off() {
    let out = simulate(&spring_loaded(0.0), Model::Contact).unwrap();
    assert!(!out.contact_lost, "{}", out.lost_fraction);
    let exact = (60.0 / 0.03375_f64).sqrt();
    let got = out.liftoff_speed.unwrap();
    assert!((got / exact - 1.0).abs() < 1e-6, "{got} {exact}");
}
