//! Conditioning of splines, polynomials at equal steps, and differences of noise.

use std::f64::consts::TAU;

use gaitcam::drive::Drive;
use gaitcam::force::{Feet, ForceCurve, model};
use gaitcam::law::{Condition, Law, hermite_birkhoff};
use gaitcam::poly::{SplineSpace, gauss_legendre};
use gaitcam_lab::tiers::Task;
use nalgebra::DMatrix;

fn spline_gram(degree: usize, spans: usize, order: usize) -> DMatrix<f64> {
    let space = SplineSpace::periodic_uniform(degree, spans, TAU);
    let mut weights = vec![0.0; order + 1];
    weights[order] = 1.0;
    let mut gram = DMatrix::zeros(spans, spans);
    for span in 0..spans {
        for (u, w) in gauss_legendre(degree + 1) {
            let row = space.row(span, u, &weights);
            for (i, a) in row.iter().enumerate() {
                for (j, b) in row.iter().enumerate() {
                    gram[(space.index(span, i), space.index(span, j))] += w * a * b;
                }
            }
        }
    }
    gram
}

#[test]
fn periodic_splines_stay_as_well_conditioned_however_many_spans() {
    for (degree, stated) in [(3, 18.5), (4, 45.7), (5, 112.8)] {
        for spans in [32, 128] {
            let values = spline_gram(degree, spans, 0).symmetric_eigenvalues();
            let found = values.max() / values.min();
            assert!(
                (found / stated - 1.0).abs() < 0.01,
                "{degree} {spans}: {found}"
            );
        }
    }
}

#[test]
fn fitting_through_accelerations_knows_all_but_the_constant() {
    for spans in [16, 32, 64] {
        let mut values: Vec<f64> = spline_gram(5, spans, 2)
            .symmetric_eigenvalues()
            .iter()
            .copied()
            .collect();
        values.sort_by(f64::total_cmp);
        let top = values[spans - 1];
        assert!(values[0].abs() < 1e-12 * top, "one null vector");
        // Condition number of the collocation matrix, the square root of that of the Gram matrix: about 0.04 N².
        let condition = (top / values[1]).sqrt();
        let law = 0.04 * (spans * spans) as f64;
        assert!(
            condition / law > 0.5 && condition / law < 2.0,
            "{spans}: {condition} {law}"
        );
    }
}

#[test]
fn interpolation_at_equal_steps_grows_as_runge_found_and_splines_do_not() {
    let runge = |u: f64| 1.0 / (1.0 + 25.0 * (2.0 * u - 1.0).powi(2));
    // Maximum errors of the interpolant on [−1, 1]: 1.9156 at degree 10, 59.8 at degree 20.
    for (degree, stated) in [(10, 1.9156), (20, 59.82)] {
        let conditions: Vec<Condition> = (0..=degree)
            .map(|i| i as f64 / degree as f64)
            .map(|u| Condition {
                theta: u,
                order: 0,
                value: runge(u),
            })
            .collect();
        let poly = hermite_birkhoff(&conditions, 0.0, 1.0).unwrap();
        let worst = (0..=10_000)
            .map(|i| i as f64 / 1e4)
            .map(|u| (poly.eval(u) - runge(u)).abs());
        let worst = worst.fold(0.0, f64::max);
        assert!((worst / stated - 1.0).abs() < 0.01, "{degree}: {worst}");
    }
    let curve = ForceCurve::from_samples(
        "runge",
        1.0,
        (0..1024).map(|i| runge(f64::from(i) / 1024.0)).collect(),
    );
    let target = curve.unwrap();
    let drive = hydraulic();
    let mut last = f64::INFINITY;
    for spans in [10, 20, 40, 80] {
        let law = free(&target, drive, spans);
        let worst = worst_force(&law, &drive, &target);
        assert!(worst < last, "{spans}: {worst}");
        last = worst;
    }
    assert!(last < 1e-3, "{last}");
}

fn hydraulic() -> Drive {
    Drive {
        spring_rate: 1.0,
        ..Drive::moving_axis(0.0, 0.0, TAU)
    }
}

fn free(target: &ForceCurve, drive: Drive, spans: usize) -> Law {
    let task = Task {
        target,
        drive,
        degree: 5,
        spans,
        bounds: &[],
    };
    task.free().unwrap()
}

fn worst_force(law: &Law, drive: &Drive, target: &ForceCurve) -> f64 {
    (0..4000)
        .map(|i| TAU * (f64::from(i) + 0.5) / 4000.0)
        .map(|x| (drive.force(law.svaj(x)) - target.at(x)).abs())
        .fold(0.0, f64::max)
}

/// The second difference of a force with noise of 1 % BW is only noise, but the acceleration of the fit is not.
#[test]
fn differences_of_a_noisy_force_drown_and_the_fit_does_not() {
    let clean = model("young", Some(1.85), 700.0, Feet::Both).unwrap();
    let n = 600;
    let step = TAU / f64::from(n);
    let mut seed = 12345_u64;
    let mut noise = || {
        // Sum of four uniform random numbers, with a variance of 1/3.
        let mut uniform = || {
            seed = seed
                .wrapping_mul(6364136223846793005)
                .wrapping_add(1442695040888963407);
            (seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5
        };
        (0..4).map(|_| uniform()).sum::<f64>() * 3f64.sqrt()
    };
    let samples: Vec<f64> = (0..n)
        .map(|i| clean.at(step * f64::from(i)) + 7.0 * noise())
        .collect();
    let noisy = ForceCurve::from_samples("noisy", clean.period_s, samples.clone()).unwrap();
    let drive = hydraulic();
    let law = free(&noisy, drive, 16);
    let exact = free(&clean, drive, 64);
    let rms = |f: &dyn Fn(usize) -> f64| {
        ((0..n as usize).map(|i| f(i).powi(2)).sum::<f64>() / f64::from(n)).sqrt()
    };
    let at = |i: usize| step * i as f64;
    let around = |i: usize, d: i32| samples[(i as i32 + d).rem_euclid(n) as usize];
    let signal = rms(&|i| exact.svaj(at(i)).v);
    let differences = rms(&|i| (around(i, 1) - around(i, -1)) / (2.0 * step) - exact.svaj(at(i)).v);
    let fitted = rms(&|i| law.svaj(at(i)).v - exact.svaj(at(i)).v);
    assert!(
        differences > 0.8 * signal,
        "differences {differences} of {signal}"
    );
    assert!(fitted < 0.05 * signal, "fit {fitted} of {signal}");
    let second = rms(&|i| {
        (around(i, 1) - 2.0 * around(i, 0) + around(i, -1)) / (step * step) - exact.svaj(at(i)).a
    });
    assert!(second > 20.0 * rms(&|i| exact.svaj(at(i)).a));
    assert!(
        rms(&|i| law.svaj(at(i)).a - exact.svaj(at(i)).a) < 0.25 * rms(&|i| exact.svaj(at(i)).a)
    );
}
