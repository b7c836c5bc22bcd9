//! Limiting cases of contact models: Zeno bouncing, grazing, few points, stiff contacts, no mass, no speed, noise.

use super::tests::{emitted, rests, run_cam};
use super::*;
use crate::dynamics::recover::recover;
use crate::dynamics::{rigid, thesis};
use crate::law::Law;
use std::f64::consts::PI;

#[test]
fn zeno_bouncing_ends_in_contact_every_turn() {
    for e in [0.2, 0.6, 0.9] {
        let run = run_cam(&thesis::double_harmonic(), &thesis::real(24.5), e);
        assert!(run.settle.is_some() && !rests(&run).is_empty(), "{e}");
    }
}

#[test]
fn a_grazing_force_is_no_flight() {
    // At the lift-off speed computed for the recovered lift, the minimum force is zero.
    let cam = thesis::eccentric();
    let own = rigid::liftoff_speed(
        &emitted(&cam, 1440, &thesis::real(20.0))[0].law,
        &thesis::real(20.0),
    )
    .unwrap();
    let run = run_cam(&cam, &thesis::real(own), 0.5);
    assert!(
        run.lost_fraction() < 1e-6 && run.turns <= 2,
        "{} {run:?}",
        run.lost_fraction()
    );
}

#[test]
fn the_landing_does_not_depend_on_the_number_of_points() {
    // theory §10 eccentric at 35 rad/s: the landing converges faster than second order.
    let exact = 204.980_906_f64;
    let at = |n: usize| {
        let drive = thesis::real(35.0);
        let run = run(
            &emitted(&thesis::double_harmonic(), n, &drive),
            &drive,
            0.0,
            &Limits::default(),
        );
        run.impacts[0].at
    };
    let reference = at(23040);
    let errors: Vec<f64> = [90, 180, 360, 720]
        .iter()
        .map(|&n| (at(n) - reference).abs())
        .collect();
    for pair in errors.windows(2) {
        assert!(pair[0] / pair[1] > 4.0, "{errors:?}");
    }
    let drive = thesis::real(35.0);
    let run = run(
        &emitted(&thesis::eccentric(), 360, &drive),
        &drive,
        0.0,
        &Limits::default(),
    );
    assert!((run.impacts[0].at.to_degrees() - exact).abs() < 1e-5);
}

#[test]
fn two_cams_hand_over_at_the_crossing_with_the_step_of_their_slopes() {
    // theory §3: two equal double harmonics 180° apart; s(θ) = s(θ + π) where one falls and the other rises.
    let cam = thesis::double_harmonic();
    let drive = thesis::real(thesis::SPEED);
    let one = recover(&cam.follower, &cam.profile(1440)).unwrap().law;
    let other = one.ahead(-PI);
    let surfaces = [Surface::new(one, &drive), Surface::new(other, &drive)];
    let run = run(&surfaces, &drive, 0.0, &Limits::default());
    assert_eq!((run.settle.is_some(), run.period), (true, 1));
    let hits: Vec<&Impact> = run.steady_impacts().collect();
    assert_eq!(hits.len(), 2);
    // By the symmetry of s about 135°, the crossings are at 135° ± 90°, which is 45° and 225°.
    for (hit, at) in hits.iter().zip([45.0, 225.0]) {
        assert!(
            (hit.at.to_degrees().rem_euclid(360.0) - at).abs() < 1e-6,
            "{}",
            hit.at.to_degrees()
        );
        let v = cam.law.svaj(45.0_f64.to_radians()).v;
        assert!((hit.speed - 2.0 * v * thesis::SPEED).abs() < 1e-8);
    }
}

#[test]
fn a_machine_without_mass_parts_where_it_would_pull_and_returns_without_a_blow() {
    let law = Law::harmonic(0.0, &[(0.0, 0.01)]);
    let drive = Drive::hydraulic(1e9, 0.02, 12.0);
    let run = run(
        &[Surface::new(law, &drive)],
        &drive,
        0.5,
        &Limits::default(),
    );
    assert!((run.lost_fraction() - 0.5).abs() < 1e-12 && run.impacts.is_empty());
}

#[test]
fn a_mass_pulled_away_is_said_to_have_escaped() {
    let drive = Drive {
        rest_force: -5.0,
        ..thesis::real(10.0)
    };
    let run = run_cam(&thesis::eccentric(), &drive, 0.5);
    assert!(run.escaped && run.settle.is_none());
}

#[test]
fn at_no_speed_or_nearly_none_the_contact_simply_rests() {
    for speed in [0.0, 1e-300, 1e-9] {
        let run = run_cam(&thesis::double_harmonic(), &thesis::real(speed), 0.5);
        assert_eq!(
            (run.settle, run.period, run.lost_fraction()),
            (Some(0), 1, 0.0)
        );
    }
}

#[test]
fn a_dwell_with_a_micrometre_of_noise_neither_lifts_nor_rattles() {
    let cam = thesis::double_harmonic();
    let drive = thesis::real(thesis::SPEED);
    let mut points = cam.profile(1440);
    let mut seed = 12345_u64;
    let mut noise = || {
        seed = seed
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        ((seed >> 33) as f64 / f64::from(1_u32 << 31) - 1.0) * 1e-6
    };
    for p in &mut points {
        p.x += noise();
        p.y += noise();
    }
    let curve = recover(&cam.follower, &points).unwrap();
    assert!(curve.mismatch < 3e-6);
    let run = run(
        &[Surface::new(curve.law.clone(), &drive)],
        &drive,
        0.5,
        &Limits::default(),
    );
    assert_eq!(run.lost_fraction(), 0.0);
    let worst = |law: &Law| {
        (0..720)
            .map(|i| law.svaj(f64::from(i) * PI / 360.0 + 1e-3))
            .zip((0..720).map(|i| cam.law.svaj(f64::from(i) * PI / 360.0 + 1e-3)))
            .map(|(a, b)| (drive.force(a) - drive.force(b)).abs())
            .fold(0.0, f64::max)
    };
    // The rigid force changes by ω²M·noise/step ≈ 0.03 N, multiplied by the gain of the spline.
    assert!(worst(&curve.law) < 0.15, "{}", worst(&curve.law));
}
