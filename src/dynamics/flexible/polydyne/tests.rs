use super::*;
use crate::dynamics::thesis;
use crate::law::{Extent, Rise, Segment, program};
use crate::poly::SplineSpace;
use std::f64::consts::{PI, TAU};

fn machine() -> Drive {
    Drive {
        spring_rate: 700.0,
        damping: 6.0,
        ..thesis::real(20.0)
    }
}

fn train(damping: f64) -> Train {
    Train {
        stiffness: 9000.0,
        damping,
    }
}

/// A smooth closed lift of about 20 mm as a periodic spline.
fn spline(degree: usize) -> Law {
    let space = SplineSpace::periodic_uniform(degree, 24, TAU);
    let x: Vec<f64> = (0..24)
        .map(|i| {
            let t = TAU * f64::from(i) / 24.0;
            0.01 * (t.sin() + 0.3 * (2.0 * t).cos() + 0.05 * (5.0 * t).sin())
        })
        .collect();
    Law::from_poly(space.spline(&x), true)
}

#[test]
fn harmonics_reach_the_end_exactly_with_and_without_damping() {
    let wanted = Law::harmonic(0.003, &[(0.0, 0.01), (0.002, 0.0), (0.0, -0.0003)]);
    for damping in [0.0, 40.0] {
        let (drive, train) = (machine(), train(damping));
        let cam = polydyne(&wanted, &drive, &train).unwrap();
        let steady = flexible::steady(&finely(&cam), &drive, &train).unwrap();
        for (t, x) in steady.theta.iter().zip(&steady.deflection) {
            let end = cam.svaj(*t).s + x;
            assert!((end - wanted.svaj(*t).s).abs() < 1e-12, "{damping} {t}");
        }
        let miss = end_error(&cam, &wanted, &drive, &train).unwrap();
        assert!(miss.force_max < 1e-9 && miss.lift.value < 1e-12, "{miss:?}");
    }
}

#[test]
fn an_undamped_spline_reaches_the_end_exactly() {
    let (drive, wanted) = (machine(), spline(5));
    let cam = polydyne(&wanted, &drive, &train(0.0)).unwrap();
    let miss = end_error(&cam, &wanted, &drive, &train(0.0)).unwrap();
    let plain = end_error(&wanted, &wanted, &drive, &train(0.0)).unwrap();
    assert!(miss.force_max < 1e-9, "{miss:?}");
    assert!(plain.force_rms > 0.1, "{plain:?}");
    // The cam's acceleration stays continuous.
    let size = cam.extremes(2).1.value;
    assert!(cam.joints().iter().all(|j| j.jump.a.abs() < 1e-9 * size));
}

/// Motion of the end of the follower for a cam, by the fourth-order Runge–Kutta method, over several turns until it is periodic.
fn end_by_steps(cam: &Law, drive: &Drive, train: &Train) -> Vec<(f64, f64)> {
    const STEPS: usize = 20_000;
    let w = drive.speed;
    let rate = |t: f64, [y, v]: [f64; 2]| {
        let at = cam.svaj(t);
        let push = train.stiffness * (at.s - y) + train.damping * w * (at.v - v);
        let pull = drive.rest_force + drive.spring_rate * y + drive.damping * w * v;
        [v, (push - pull) / (drive.mass * w * w)]
    };
    let step = TAU / STEPS as f64;
    let mut z = [cam.svaj(0.0).s, cam.svaj(0.0).v];
    let mut out = Vec::new();
    for turn in 0..40 {
        for i in 0..STEPS {
            let t = step * i as f64;
            if turn == 39 && i % 50 == 0 {
                out.push((t, z[0]));
            }
            let ahead = |k: [f64; 2], part: f64| [0, 1].map(|n| z[n] + part * step * k[n]);
            let a = rate(t, z);
            let b = rate(t + 0.5 * step, ahead(a, 0.5));
            let c = rate(t + 0.5 * step, ahead(b, 0.5));
            let d = rate(t + step, ahead(c, 1.0));
            z = [0, 1].map(|n| z[n] + step / 6.0 * (a[n] + 2.0 * (b[n] + c[n]) + d[n]));
        }
    }
    out
}

#[test]
fn a_damped_spline_reaches_the_end_by_an_independent_integration() {
    let drive = machine();
    // ζ = c₁/(2√(k₁m)) from 1e-4 to 0.5.
    for (degree, damping) in [(5, 0.02), (5, 9.5), (7, 9.5), (7, 40.0), (9, 95.0)] {
        let (wanted, train) = (spline(degree), train(damping));
        let cam = polydyne(&wanted, &drive, &train).unwrap();
        let worst = (end_by_steps(&cam, &drive, &train).into_iter())
            .map(|(t, y)| (y - wanted.svaj(t).s).abs())
            .fold(0.0, f64::max);
        assert!(worst < 2e-9, "{degree} {damping}: {worst}");
        let miss = end_error(&cam, &wanted, &drive, &train).unwrap();
        assert!(miss.lift.value < 2e-9, "{degree} {damping}: {miss:?}");
        let jumps = cam.joints();
        let sizes = [0, 1, 2, 3].map(|order| cam.bound(order));
        assert!(jumps.iter().all(|j| j.jump.a.abs() < 1e-9 * sizes[2]));
    }
}

/// Fluid without mass: springs in series share the lift, so the lift of the cam is multiplied by (1 + k/k₁).
#[test]
fn a_fluid_column_needs_no_smooth_derivatives() {
    let drive = Drive {
        mass: 0.0,
        damping: 0.0,
        rest_force: 0.0,
        ..machine()
    };
    let wanted = thesis::double_harmonic().law;
    let cam = polydyne(&wanted, &drive, &train(0.0)).unwrap();
    for i in 0..40 {
        let t = 0.157 * f64::from(i);
        let share = cam.svaj(t).s - wanted.svaj(t).s * (1.0 + 700.0 / 9000.0);
        assert!(share.abs() < 1e-15, "{share}");
    }
}

#[test]
fn laws_and_trains_that_cannot_be_followed_are_refused_in_words() {
    let rise = |motion: &str| {
        let segment = |lift: f64| Segment {
            motion: Rise::from_name(motion).unwrap(),
            lift,
            angle: 0.5 * PI,
        };
        let rest = Segment {
            motion: Rise::Dwell,
            lift: 0.0,
            angle: PI,
        };
        program(&[segment(0.01), segment(-0.01), rest], Extent::TURN).unwrap()
    };
    let drive = machine();
    for (motion, words) in [
        ("3-4-5", "the jerk of the law"),
        ("cycloidal", "the jerk of the law"),
        ("4-5-6-7", "the fourth derivative of the law"),
        ("parabolic", "the acceleration of the law"),
    ] {
        let got = polydyne(&rise(motion), &drive, &train(0.0));
        let got = got.unwrap_err().to_string();
        assert!(got.contains(words) && got.contains("5-6-7-8-9"), "{got}");
    }
    assert!(polydyne(&rise("5-6-7-8-9"), &drive, &train(0.0)).is_ok());
    let soft = Train {
        stiffness: 0.0,
        damping: 0.0,
    };
    assert!(polydyne(&spline(7), &drive, &soft).is_err());
}
