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

/// Each degree above 5 takes in one more term of the series, whose terms fall as 2ζ·nω/ω₁.
#[test]
fn damping_is_taken_in_term_by_term() {
    let (drive, train) = (machine(), train(20.0));
    let mut last = f64::INFINITY;
    for degree in 5..=9 {
        let wanted = spline(degree);
        let cam = polydyne(&wanted, &drive, &train).unwrap();
        let miss = end_error(&cam, &wanted, &drive, &train).unwrap();
        let plain = end_error(&wanted, &wanted, &drive, &train).unwrap();
        assert!(miss.force_rms < 0.3 * last, "{degree}: {miss:?} {last}");
        // At degree 9 a thousandth of what a cam cut to the wanted law itself would miss.
        let share = if degree == 9 { 1e-3 } else { 0.3 };
        assert!(miss.force_rms < share * plain.force_rms, "{plain:?}");
        last = miss.force_rms;
    }
}

/// Fluid without mass: springs in series share the lift, so the cam lifts by (1 + k/k₁).
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
