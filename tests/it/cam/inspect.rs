//! Manufactured cams with known centre, zero angle and deviation. The fit of measured points must return these values.

use std::f64::consts::TAU;

use gaitcam::cam::{Cam, Deviation, Follower, Inspection};
use gaitcam::error::{CamInputError, Error};
use gaitcam::law::Law;
use gaitcam::sweep::MadeCam;
use gaitcam::synth::Design;

/// Rotation of the cam in the measuring frame, rad, and its centre, m.
const TURN: f64 = 2.1;
const CENTRE: [f64; 2] = [0.123, -0.045];
/// Number of measured points.
const POINTS: usize = 360;

fn roller() -> Cam {
    let law = Law::harmonic(0.01, &[(0.006, 0.004), (0.001, -0.002)]);
    let follower = Follower::RollerTranslating {
        prime_radius: 0.04,
        offset: 0.005,
        roller_radius: 0.008,
    };
    Cam::new(law, follower).unwrap()
}

fn flat(base_radius: f64) -> Cam {
    // Harmonic 1 shifts the outline under a flat face, harmonic 2 alone would repeat after half a turn.
    let terms = [(0.006, 0.004), (0.001, -0.001), (0.0005, 0.0003)];
    let law = Law::harmonic(0.01, &terms);
    let follower = Follower::FlatTranslating { base_radius };
    Cam::new(law, follower).unwrap()
}

fn arms() -> [Cam; 2] {
    let law = Law::harmonic(0.1, &[(0.06, 0.04), (0.005, -0.01)]);
    let roller = Follower::RollerOscillating {
        pivot_distance: -0.1,
        arm: 0.08,
        prime_radius: 0.05,
        roller_radius: 0.01,
    };
    let flat = Follower::FlatOscillating {
        pivot_distance: 0.12,
        face_offset: 0.005,
        base_radius: 0.05,
    };
    [roller, flat].map(|follower| Cam::new(law.clone(), follower).unwrap())
}

/// Point of the cam in the coordinates of the measuring machine.
fn seen([x, y]: [f64; 2]) -> [f64; 2] {
    let (sin, cos) = TURN.sin_cos();
    [CENTRE[0] + cos * x - sin * y, CENTRE[1] + sin * x + cos * y]
}

/// Deviations of a cam manufactured within a tolerance: waves of 2 to 12 lobes whose amplitude falls with the square of their number. Rotation and
/// shift are removed, so that the fit must return these deviations.
fn made(cam: &Cam, size: f64) -> Vec<f64> {
    let profile = cam.profile(POINTS);
    let wave = |theta: f64| -> f64 {
        let lobe = |n: u32| (f64::from(n) * (theta + f64::from(n * n))).cos() / f64::from(n * n);
        size * (2..=12).map(lobe).sum::<f64>()
    };
    let mut out: Vec<f64> = profile.iter().map(|p| wave(p.theta)).collect();
    // How the distance of each point changes by shifts and by a turn.
    let modes: Vec<[f64; 3]> = profile
        .iter()
        .map(|p| {
            let [nx, ny] = cam.normal(p);
            [nx, ny, 30.0 * (p.x * ny - p.y * nx)]
        })
        .collect();
    // Taken away one after the other, again and again: they converge on their common part.
    for _ in 0..2000 {
        for k in 0..3 {
            let own: f64 = modes.iter().map(|m| m[k] * m[k]).sum();
            let part: f64 = modes.iter().zip(&out).map(|(m, d)| m[k] * d).sum();
            for (d, m) in out.iter_mut().zip(&modes) {
                *d -= part / own * m[k];
            }
        }
    }
    out
}

/// Centres of the probing ball of radius `ball` on the manufactured cam, in shuffled order.
fn measured(cam: &Cam, deviations: &[f64], ball: f64) -> Vec<[f64; 2]> {
    let profile = cam.profile(POINTS);
    (0..POINTS)
        .map(|i| 77 * i % POINTS)
        .map(|i| {
            let (p, n) = (&profile[i], cam.normal(&profile[i]));
            let off = deviations[i] + ball;
            seen([p.x + off * n[0], p.y + off * n[1]])
        })
        .collect()
}

fn assert_recovered(found: &Inspection, deviations: &[f64]) {
    assert!((found.turn - TURN).abs() < 1e-8, "{}", found.turn);
    for (found, truth) in found.centre.iter().zip(CENTRE) {
        assert!((found - truth).abs() < 1e-9, "{found}");
    }
    for d in &found.deviations {
        let truth = deviations[77 * d.row % POINTS];
        assert!((d.normal - truth).abs() < 1e-9, "{d:?}: {truth}");
    }
}

#[test]
fn centre_zero_angle_and_deviation_are_recovered_to_a_nanometre() {
    let [roller_arm, flat_arm] = arms();
    // On a base circle of a nanometre the cam is as large as its lift.
    for cam in [roller(), flat(0.04), flat(1e-9), roller_arm, flat_arm] {
        for size in [0.0, 2e-5] {
            let deviations = made(&cam, size);
            for ball in [0.0, 0.001] {
                let points = measured(&cam, &deviations, ball);
                let found = cam.inspect(&points, ball).unwrap();
                assert_recovered(&found, &deviations);
                assert!(found.alike.is_empty());
            }
        }
    }
}

#[test]
fn a_cam_that_repeats_itself_fits_at_every_repetition() {
    let law = Law::harmonic(0.005, &[(0.0, 0.0), (0.0, 0.0), (0.005, 0.0)]);
    let follower = Follower::RollerTranslating {
        prime_radius: 0.05,
        offset: 0.0,
        roller_radius: 0.008,
    };
    let cam = Cam::new(law, follower).unwrap();
    let found = cam
        .inspect(&measured(&cam, &[0.0; POINTS], 0.0), 0.0)
        .unwrap();
    assert_eq!(found.alike.len(), 2);
    for turn in found.alike.iter().chain([&found.turn]) {
        let thirds = (turn - TURN) / (TAU / 3.0);
        assert!((thirds - thirds.round()).abs() < 1e-7, "{turn}");
    }
}

fn fault(result: Result<Inspection, Error>) -> CamInputError {
    let error = result.unwrap_err();
    error
        .fault::<CamInputError>()
        .cloned()
        .expect("a fault of the cam")
}

#[test]
fn points_that_say_nothing_about_this_cam_are_refused() {
    let cam = roller();
    let points = measured(&cam, &[0.0; POINTS], 0.0);
    let few = cam.inspect(&points[..11], 0.0);
    assert!(matches!(
        fault(few),
        CamInputError::MeasuredFew {
            points: 11,
            least: 12
        }
    ));
    let mut bad = points.clone();
    bad[6][1] = f64::NAN;
    assert!(matches!(
        fault(cam.inspect(&bad, 0.0)),
        CamInputError::MeasuredNotFinite { row: 7 }
    ));
    assert!(matches!(
        fault(flat(0.04).inspect(&points, 0.0)),
        CamInputError::MeasuredOther { .. }
    ));
    // Other units: laid on one another, no point is farther from the profile than both together are wide.
    for scale in [3.0, 10.0, 25.4, 1e3] {
        let other: Vec<[f64; 2]> = points.iter().map(|p| p.map(|x| scale * x)).collect();
        let CamInputError::MeasuredOther { distance, high, .. } = fault(cam.inspect(&other, 0.0))
        else {
            panic!("{scale}");
        };
        let reach = other.iter().map(|p| p[0].hypot(p[1])).fold(0.0, f64::max);
        assert!(
            distance.value <= 2.0 * (reach + high.value),
            "{scale}: {distance:?}"
        );
    }
    // s = e (1 + sin θ) under a flat face is an eccentric circle.
    let disc = Cam::new(
        Law::harmonic(0.01, &[(0.0, 0.01)]),
        Follower::FlatTranslating { base_radius: 0.02 },
    )
    .unwrap();
    let round = disc.inspect(&measured(&disc, &[0.0; POINTS], 0.0), 0.0);
    assert!(matches!(fault(round), CamInputError::MeasuredCircle));
}

/// Cams without mirror symmetry, on a slide and on an arm, with a roller and a flat face.
fn lopsided() -> [Cam; 4] {
    let [roller_arm, flat_arm] = arms();
    [roller(), flat(0.04), roller_arm, flat_arm]
}

#[test]
fn points_of_the_mirror_image_are_said_to_be_those() {
    for cam in lopsided() {
        for size in [0.0, 5e-6] {
            let points = measured(&cam, &made(&cam, size), 0.0);
            let mirrored: Vec<[f64; 2]> = points.iter().map(|[x, y]| [-x, *y]).collect();
            let CamInputError::MeasuredMirror { distance, mirrored } =
                fault(cam.inspect(&mirrored, 0.0))
            else {
                panic!("{}: not mirrored", cam.follower.name());
            };
            assert!(distance.value > 10.0 * mirrored.value && mirrored.value <= size + 1e-9);
        }
    }
}

#[test]
fn points_far_off_the_others_are_outliers_and_do_not_move_the_fit() {
    for cam in lopsided() {
        for size in [0.0, 2e-6] {
            let deviations = made(&cam, size);
            let mut points = measured(&cam, &deviations, 0.0);
            let far = [(30, 5e-3), (200, -4e-3), (201, 4e-4)];
            for (row, off) in far {
                let [x, y] = [points[row][0] - CENTRE[0], points[row][1] - CENTRE[1]];
                let r = x.hypot(y);
                points[row] = [points[row][0] + off * x / r, points[row][1] + off * y / r];
            }
            let found = cam.inspect(&points, 0.0).unwrap();
            let mut rows: Vec<usize> = (found.deviations.iter())
                .filter(|d| d.is_outlier)
                .map(|d| d.row)
                .collect();
            rows.sort_unstable();
            assert_eq!(rows, far.map(|f| f.0), "{}", cam.follower.name());
            // Three points less: the fit is no longer the truth itself.
            assert!((found.turn - TURN).abs() < 1e-8 + 0.1 * size / 0.01);
            for d in found.kept() {
                let truth = deviations[77 * d.row % POINTS];
                assert!(
                    (d.normal - truth).abs() < 1e-9 + 0.1 * size,
                    "{d:?}: {truth}"
                );
            }
            assert!(found.rms() < 1e-9 + 2.0 * size && found.deviations.len() == POINTS);
        }
    }
}

#[test]
fn a_part_without_points_is_reported_and_leaves_the_made_cam_unknown() {
    let mut design = footbridge();
    for cam in lopsided() {
        let points = measured(&cam, &made(&cam, 2e-6), 0.0);
        // In the order of the profile.
        let points: Vec<[f64; 2]> = (0..POINTS)
            .map(|k| points[(0..POINTS).find(|i| 77 * i % POINTS == k).unwrap()])
            .collect();
        design.cam = cam.clone();
        for share in [4, 2] {
            let part = cam.inspect(&points[..POINTS / share], 0.0).unwrap();
            let [from, to] = part.unmeasured.expect("a part without points");
            let last = TAU * (POINTS / share - 1) as f64 / POINTS as f64;
            assert!(
                (from - last).abs() < 0.02 && to.min(TAU - to) < 0.02,
                "{from} {to}"
            );
            assert!(MadeCam::of(&design, &part).is_none());
        }
        for step in [1, 9] {
            let all: Vec<[f64; 2]> = points.iter().copied().step_by(step).collect();
            let found = cam.inspect(&all, 0.0).unwrap();
            assert_eq!(found.unmeasured, None, "{} {step}", cam.follower.name());
            assert!(MadeCam::of(&design, &found).is_some());
        }
    }
}

#[test]
fn a_disc_with_a_second_sine_of_a_micrometre_is_no_circle() {
    for (base_radius, small) in [(0.02, 1e-3), (0.05, 1e-5), (0.1, 1e-6)] {
        for harmonic in [2, 3] {
            let mut terms = vec![(0.0, 0.0); harmonic];
            terms[0].1 = 0.01;
            terms[harmonic - 1].1 = small;
            let follower = Follower::FlatTranslating { base_radius };
            let cam = Cam::new(Law::harmonic(0.01 + small, &terms), follower).unwrap();
            let points = measured(&cam, &[0.0; POINTS], 0.0);
            let found = cam.inspect(&points, 0.0).unwrap();
            // Harmonic n alone repeats after an nth of a turn.
            let repeats = (found.turn - TURN) / (TAU / harmonic as f64);
            assert!(
                (repeats - repeats.round()).abs() < 1e-6,
                "{small} {harmonic}: {repeats}"
            );
            // Scatter twenty times as large hides it.
            let rough = |i: usize| 20.0 * small * (37.0 * i as f64).sin();
            let scatter: Vec<f64> = (0..POINTS).map(rough).collect();
            let rough = cam.inspect(&measured(&cam, &scatter, 0.0), 0.0);
            assert!(small > 1e-4 || matches!(fault(rough), CamInputError::MeasuredCircle));
        }
    }
}

fn footbridge() -> Design {
    gaitcam_test_support::design::<&str>(gaitcam::scene::DEFAULT, &[]).unwrap()
}
#[test]
fn the_force_of_a_made_cam_is_that_of_its_waves() {
    let mut design = footbridge();
    design.cam = flat(0.04);
    let size = 5e-6;
    let deviations = (0..POINTS)
        .map(|row| {
            let theta = TAU * row as f64 / POINTS as f64;
            Deviation {
                row,
                theta,
                normal: size * (7.0 * theta + 0.4).cos(),
                is_outlier: false,
            }
        })
        .collect();
    let inspection = Inspection {
        turn: 0.0,
        centre: [0.0; 2],
        deviations,
        alike: Vec::new(),
        unmeasured: None,
    };
    let made = MadeCam::of(&design, &inspection).unwrap();
    assert_eq!(made.waves, 7);
    assert!(made.left < 1e-12);
    // M (g + ω² a) with a″ = −49 δ cos(7θ + 0.4) added.
    let drive = &design.problem.drive;
    let target = design.target().unwrap();
    let n = 20_000;
    let (mut square, mut least, mut top) = (0.0, f64::INFINITY, 0.0_f64);
    for i in 0..n {
        let theta = TAU * f64::from(i) / f64::from(n);
        let a = flat(0.04).law.svaj(theta).a - 49.0 * size * (7.0 * theta + 0.4).cos();
        let force = drive.rest_force + drive.mass * drive.speed * drive.speed * a;
        square += (force - target.at(theta)).powi(2) / f64::from(n);
        least = least.min(force);
        top = top.max(drive.speed * drive.speed * a.abs());
    }
    let found = made.made;
    assert!((found.rms_error_n.unwrap() / square.sqrt() - 1.0).abs() < 1e-9);
    assert!((found.min_n - least).abs() < 1e-5 * drive.rest_force);
    assert!((found.acceleration / top - 1.0).abs() < 1e-6);
    // M g = −M ω² min a at lift-off.
    let a = (least - drive.rest_force) / (drive.mass * drive.speed * drive.speed);
    let liftoff = (-drive.rest_force / (drive.mass * a)).sqrt();
    assert!((found.liftoff_speed.unwrap() / liftoff - 1.0).abs() < 1e-6);
}

#[test]
fn a_deviation_reaches_the_follower_through_the_lever_of_its_normal() {
    let [roller_arm, flat_arm] = arms();
    let mut design = footbridge();
    for cam in [roller(), roller_arm, flat_arm] {
        // A cam cut to another law, seen against the first one.
        let size = 1e-4 * cam.law.stroke();
        let other = {
            let mut terms = vec![(0.0, 0.0); 7];
            let [(a, b), (c, d)] = match cam.follower.pivot() {
                None => [(0.006, 0.004), (0.001, -0.002)],
                Some(_) => [(0.06, 0.04), (0.005, -0.01)],
            };
            (terms[0], terms[1], terms[6]) = ((a, b), (c, d), (size, 0.0));
            let mean = if cam.follower.pivot().is_none() {
                0.01
            } else {
                0.1
            };
            Cam {
                law: Law::harmonic(mean, &terms),
                follower: cam.follower,
            }
        };
        let points = measured(&other, &[0.0; POINTS], 0.0);
        let found = cam.inspect(&points, 0.0).unwrap();
        design.cam = cam.clone();
        let made = MadeCam::of(&design, &found).unwrap();
        for i in 0..100 {
            let theta = TAU * f64::from(i) / 100.0;
            let moved = made.law.svaj(theta).s - cam.law.svaj(theta).s;
            let truth = size * (7.0 * theta).cos();
            // The turn and shift of the fit take a little of it.
            assert!(
                (moved - truth).abs() < 0.1 * size,
                "{theta}: {moved} {truth}"
            );
        }
    }
}
