use super::*;
use crate::cam::Cam;
use crate::dynamics::rigid::touch::{Touch, touch};

use crate::drive::DriveKind;
use crate::dynamics::thesis;
use crate::law::{Extent, Rise, Segment, program};
use crate::units::G;

fn spring_loaded(speed: f64) -> Drive {
    // Theory §10: k = 5000 N/m, preload kδ with δ = 0.01 m, m = 1 kg. The lift is measured from the lowest point.
    Drive {
        kind: DriveKind::FixedAxis,
        rest_force: 5000.0 * 0.01,
        spring_rate: 5000.0,
        damping: 0.0,
        mass: 1.0,
        speed,
        lever: 1.0,
    }
}

fn touch_at(cam: &Cam, drive: &Drive, friction: f64, theta: f64) -> Touch {
    let at = cam.law.svaj(theta);
    touch(&cam.follower, drive.speed, friction, at, drive.force(at))
}

#[test]
fn thesis_cams_lift_off_at_31_320920_and_23_490690() {
    // theory §10, g = 9.81.
    let eccentric = liftoff_speed(&thesis::eccentric().law, &thesis::real(11.624)).unwrap();
    assert!(
        (eccentric / (G / 0.01).sqrt() - 1.0).abs() < 1e-12,
        "{eccentric}"
    );
    assert!((eccentric - 31.320920).abs() < 5e-7);
    let double = liftoff_speed(&thesis::double_harmonic().law, &thesis::real(11.624)).unwrap();
    assert!((double - 23.490690).abs() < 5e-7, "{double}");
}

#[test]
fn spring_loaded_eccentric_jumps_at_122_474() {
    // Theory §10: ω = √(k(2e + δ)/(m e)), because the spring is compressed by 2e + δ at the top.
    let law = Law::harmonic(0.01, &[(0.0, 0.01)]);
    for speed in [50.0, -50.0] {
        let jump = liftoff_speed(&law, &spring_loaded(speed)).unwrap();
        assert!((jump - 15000.0_f64.sqrt()).abs() < 1e-9, "{jump}");
    }
}

#[test]
fn damping_moves_the_jump_as_the_quadratic_says() {
    let law = Law::harmonic(0.01, &[(0.0, 0.01)]);
    let drive = Drive {
        damping: 30.0,
        ..spring_loaded(10.0)
    };
    let jump = liftoff_speed(&law, &drive).unwrap();
    let lowest = |speed: f64| {
        Drive { speed, ..drive }
            .force_curve(&law)
            .extremes()
            .0
            .value
    };
    assert!(lowest(jump * (1.0 - 1e-7)) > 0.0 && lowest(jump * (1.0 + 1e-7)) < 0.0);
}

#[test]
fn a_machine_without_mass_never_jumps_and_one_pulled_off_jumps_at_rest() {
    let law = Law::harmonic(0.01, &[(0.0, 0.01)]);
    let hydraulic = Drive::hydraulic(1e9, 0.02, 12.0);
    assert_eq!(liftoff_speed(&law, &hydraulic), None);
    let pulled = Drive {
        rest_force: -200.0,
        ..spring_loaded(10.0)
    };
    assert_eq!(liftoff_speed(&law, &pulled), Some(0.0));
}

/// Check of the minimum force for s = A (1 + cos θ) without preload: A ω² (m − c²/(2k)) to first order.
#[test]
fn damping_without_a_preload_lifts_off_at_any_speed() {
    let law = Law::harmonic(0.01, &[(0.01, 0.0)]);
    let of = |mass: f64| Drive {
        rest_force: 0.0,
        spring_rate: 100.0,
        damping: 20.0,
        mass,
        ..spring_loaded(1.0)
    };
    for (mass, lifts) in [(0.0, true), (1.5, true), (2.5, false)] {
        let drive = of(mass);
        let jump = liftoff_speed(&law, &drive);
        assert_eq!(jump == Some(0.0), lifts, "{mass} {jump:?}");
        assert_eq!(drive.force_extremes(&law).0.value < 0.0, lifts, "{mass}");
    }
}

#[test]
fn damping_alone_lifts_off_where_the_follower_moves_fastest_against_it() {
    // F₀ + c ω v = 0 at ω v = −|ω| e.
    let law = Law::harmonic(0.01, &[(0.0, 0.01)]);
    for speed in [10.0, -10.0] {
        let drive = Drive {
            mass: 0.0,
            spring_rate: 0.0,
            damping: 30.0,
            ..spring_loaded(speed)
        };
        let jump = liftoff_speed(&law, &drive).unwrap();
        assert!((jump - 50.0 / (30.0 * 0.01)).abs() < 1e-9, "{jump}");
    }
}

#[test]
fn a_steep_rise_under_much_damping_jumps_where_its_force_first_vanishes() {
    // Damping increases the force on the rise, where inertia reduces it most. The fall is slow.
    let segment = |lift: f64, degrees: f64| Segment {
        motion: Rise::Poly345,
        lift,
        angle: degrees.to_radians(),
    };
    let law = program(&[segment(0.01, 30.0), segment(-0.01, 330.0)], Extent::TURN).unwrap();
    let drive = Drive {
        spring_rate: 0.0,
        damping: 400.0,
        ..spring_loaded(10.0)
    };
    let jump = liftoff_speed(&law, &drive).unwrap();
    let lowest = |speed: f64| Drive { speed, ..drive }.force_extremes(&law).0.value;
    assert!(lowest(jump * (1.0 - 1e-7)) > 0.0 && lowest(jump * (1.0 + 1e-7)) < 0.0);
}

#[test]
fn a_jump_of_the_acceleration_pulls_from_its_own_side() {
    // A cycloidal rise ends where the harmonic fall begins with −h π²/(2 β²). The second case has the opposite order.
    let segment = |motion: Rise, lift: f64, degrees: f64| Segment {
        motion,
        lift,
        angle: degrees.to_radians(),
    };
    let (gentle, sudden) = (Rise::Cycloidal, Rise::SimpleHarmonic);
    for (rise, fall) in [
        ((&gentle, 270.0), (&sudden, 90.0)),
        ((&sudden, 90.0), (&gentle, 270.0)),
    ] {
        let segments = [
            segment(rise.0.clone(), 0.01, rise.1),
            segment(fall.0.clone(), -0.01, fall.1),
        ];
        let law = program(&segments, Extent::TURN).unwrap();
        let jump = liftoff_speed(&law, &spring_loaded(10.0)).unwrap();
        // At the top, the spring force is 50 N + 5000 N/m · 10 mm.
        let pull = 0.5 * 0.01 * 4.0;
        assert!((jump - (100.0_f64 / pull).sqrt()).abs() < 1e-9, "{jump}");
    }
}

#[test]
fn a_pull_at_rest_counts_from_a_millionth_of_the_largest_force() {
    // A lift of 0 to 20 mm against 5000 N/m gives at most 100 N.
    let law = Law::harmonic(0.01, &[(0.0, 0.01)]);
    let at_rest = |rest_force: f64| {
        let drive = Drive {
            rest_force,
            ..spring_loaded(10.0)
        };
        liftoff_speed(&law, &drive) == Some(0.0)
    };
    assert!(at_rest(-1.1e-4) && !at_rest(-0.9e-4));
}

#[test]
fn lossless_torque_integrates_to_zero_to_1e_10_of_its_range() {
    for cam in [thesis::eccentric(), thesis::double_harmonic()] {
        let drive = Drive {
            spring_rate: 800.0,
            ..thesis::real(20.0)
        };
        let torque = torque_curve(&cam.law, &drive, 0.0, 0.03).unwrap();
        let (low, high) = torque.extremes();
        let range = high.value - low.value;
        assert!(
            torque.integral().abs() < 1e-10 * range,
            "{}",
            torque.integral()
        );
    }
}

#[test]
fn thesis_friction_torque_is_equation_27() {
    let cam = thesis::eccentric();
    let drive = thesis::real(thesis::SPEED);
    let at = cam.law.svaj(0.7);
    let force = thesis::MASS * (G + thesis::SPEED.powi(2) * at.a);
    let expected = 0.1 * force * (0.03 + at.s) + force * at.v;
    let torque = touch_at(&cam, &drive, 0.1, 0.7).torque;
    assert!((torque - expected).abs() < 1e-15);
}

#[test]
fn torque_with_friction_is_the_contacts_own_at_every_angle_and_in_both_turns() {
    let cam = thesis::eccentric();
    for speed in [20.0, -20.0] {
        let drive = Drive {
            spring_rate: 800.0,
            damping: 5.0,
            ..thesis::real(speed)
        };
        let curve = torque_curve(&cam.law, &drive, 0.1, reach(&cam.follower)).unwrap();
        for k in 0..12 {
            let theta = 0.5 * f64::from(k);
            // T = F (v ± μ (Rb + s)), theory §10.
            let at = cam.law.svaj(theta);
            let rub = 0.1 * speed.signum() * (reach(&cam.follower) + at.s);
            let known = drive.force(at) * (at.v + rub);
            assert!((curve.eval(theta) - known).abs() < 1e-12, "{theta}");
            // `touch_at` evaluates a cam that turns forwards.
            let own = touch_at(&cam, &drive, 0.1, theta).torque;
            assert!(speed < 0.0 || (own - known).abs() < 1e-12, "{theta}: {own}");
        }
    }
}

#[test]
fn torque_with_friction_is_no_polynomial_where_the_force_changes_sign() {
    let law = thesis::eccentric().law;
    let lost = liftoff_speed(&law, &thesis::real(10.0)).unwrap();
    for (part, friction, is_polynomial) in [
        (1.01, 0.1, false),
        (1.01, 0.0, true),
        (0.99, 0.1, true),
        (0.99, 0.0, true),
    ] {
        let curve = torque_curve(&law, &thesis::real(part * lost), friction, 0.03);
        assert_eq!(curve.is_some(), is_polynomial, "{part} {friction}");
    }
}

#[test]
fn thesis_eccentric_slides_at_0_465_metres_per_second() {
    // Theory §3: the sliding speed at 90° is 0.465 m/s. The entraining speed is ω(d + 2a)/2 = ω(0.04 − 0.02)/2.
    let at = touch_at(
        &thesis::eccentric(),
        &thesis::real(11.624),
        0.0,
        0.5 * std::f64::consts::PI,
    );
    assert!((at.sliding - 0.46496).abs() < 1e-9);
    assert!((at.entraining - 11.624 * 0.01).abs() < 1e-12);
}

#[test]
fn a_flat_face_is_tipped_by_its_force_on_the_arm_of_the_contact() {
    // The contact point of an eccentric disc is at the distance e cos θ from the line of the guide.
    let (cam, drive) = (thesis::eccentric(), thesis::real(20.0));
    let at = touch_at(&cam, &drive, 0.0, 0.7);
    let force = drive.force(cam.law.svaj(0.7));
    assert!((at.tipping.abs() - force * 0.01 * 0.7_f64.cos()).abs() < 1e-12);
}

#[test]
fn entraining_speed_of_a_concentric_roller_is_the_cam_surface_speed() {
    let cam = Cam {
        law: Law::harmonic(0.0, &[]),
        follower: Follower::RollerTranslating {
            prime_radius: 0.05,
            offset: 0.0,
            roller_radius: 0.01,
        },
    };
    let at = touch_at(&cam, &thesis::real(10.0), 0.0, 1.0);
    assert!((at.entraining - 0.4).abs() < 1e-12 && at.side_thrust.abs() < 1e-12);
}

#[test]
fn entraining_speed_of_a_roller_is_the_walk_of_the_contact_along_the_profile() {
    let cam = Cam {
        law: thesis::double_harmonic().law,
        follower: Follower::RollerTranslating {
            prime_radius: 0.05,
            offset: 0.006,
            roller_radius: 0.012,
        },
    };
    let h = 1e-5;
    for theta in [0.4, 1.5, 3.0] {
        let (p, q) = (cam.point(theta - h), cam.point(theta + h));
        let walk = (q.x - p.x).hypot(q.y - p.y) / (2.0 * h) * 10.0;
        let at = touch_at(&cam, &thesis::real(10.0), 0.0, theta);
        assert!(
            (at.entraining.abs() - walk).abs() < 1e-6,
            "{} {walk}",
            at.entraining
        );
    }
}

#[test]
fn the_least_preload_touches_its_margin() {
    let law = Law::harmonic(0.01, &[(0.0, 0.01)]);
    let drive = spring_loaded(130.0);
    let with = |d: Drive| d.force_curve(&law).extremes().0.value;
    let preload = least_preload(&law, &drive, 3.0);
    assert!(
        (with(Drive {
            rest_force: preload,
            ..drive
        }) - 3.0)
            .abs()
            < 1e-9
    );
}
