//! Least squares with equality constraints compared with an independent method: cardinal B-splines defined here, normal equations by Gauss
//! quadrature, Cholesky factorisation of the full matrix. Bases, quadrature and banded factor of the library are not used.

use std::f64::consts::TAU;

use gaitcam::force::{Feet, ForceCurve, model};
use gaitcam::scene;
use gaitcam::synth::synthesise;

const SPANS: usize = 32;

/// Cardinal B-spline of degree `p` on the knots 0, 1, … p + 1, by the recursion of Cox and de Boor.
fn cardinal(p: usize, x: f64) -> f64 {
    if p == 0 {
        return if (0.0..1.0).contains(&x) { 1.0 } else { 0.0 };
    }
    let n = p as f64;
    (x * cardinal(p - 1, x) + (n + 1.0 - x) * cardinal(p - 1, x - 1.0)) / n
}

/// Second derivative by θ of the `i`th periodic quintic B-spline on equal spans.
fn curvature(i: usize, theta: f64) -> f64 {
    let h = TAU / SPANS as f64;
    let x = (theta / h - i as f64).rem_euclid(SPANS as f64);
    (cardinal(3, x) - 2.0 * cardinal(3, x - 1.0) + cardinal(3, x - 2.0)) / (h * h)
}

/// Nodes and weights of six-point Gauss quadrature on [−1, 1] (Abramowitz and Stegun, table 25.4).
const GAUSS: [(f64, f64); 3] = [
    (0.238_619_186_083_196_9, 0.467_913_934_572_691_04),
    (0.661_209_386_466_264_5, 0.360_761_573_048_138_6),
    (0.932_469_514_203_152, 0.171_324_492_379_170_36),
];

/// Coefficients for which m ω² s″ is closest to the target minus the weight. The first coefficient is fixed at 0.
fn coefficients(target: &ForceCurve, mass: f64, speed: f64) -> Vec<f64> {
    let n = SPANS - 1;
    let (mut hessian, mut right) = (vec![vec![0.0; n]; n], vec![0.0; n]);
    let pieces = 1024 * SPANS / gcd(1024, SPANS);
    let half = 0.5 * TAU / pieces as f64;
    for piece in 0..pieces {
        for (node, weight) in GAUSS.iter().flat_map(|&(x, w)| [(x, w), (-x, w)]) {
            let theta = half * (2.0 * piece as f64 + 1.0 + node);
            let row: Vec<f64> = (1..SPANS)
                .map(|i| mass * speed * speed * curvature(i, theta))
                .collect();
            let wanted = target.at(theta) - mass * 9.81;
            for i in 0..n {
                right[i] += weight * row[i] * wanted;
                for j in 0..n {
                    hessian[i][j] += weight * row[i] * row[j];
                }
            }
        }
    }
    std::iter::once(0.0).chain(solved(hessian, right)).collect()
}

/// Solution of a positive definite system of equations by Cholesky factorisation.
fn solved(mut matrix: Vec<Vec<f64>>, mut x: Vec<f64>) -> Vec<f64> {
    let n = x.len();
    for i in 0..n {
        for j in 0..=i {
            let sum: f64 = (0..j).map(|k| matrix[i][k] * matrix[j][k]).sum();
            let rest = matrix[i][j] - sum;
            matrix[i][j] = if i == j {
                rest.sqrt()
            } else {
                rest / matrix[j][j]
            };
        }
        let sum: f64 = (0..i).map(|k| matrix[i][k] * x[k]).sum();
        x[i] = (x[i] - sum) / matrix[i][i];
    }
    for i in (0..n).rev() {
        let sum: f64 = (i + 1..n).map(|k| matrix[k][i] * x[k]).sum();
        x[i] = (x[i] - sum) / matrix[i][i];
    }
    x
}

fn gcd(a: usize, b: usize) -> usize {
    if b == 0 { a } else { gcd(b, a % b) }
}

#[test]
fn least_squares_by_a_second_route_give_the_same_law() {
    let mut table: toml::Table = scene::DEFAULT.parse().unwrap();
    for change in ["law.family=spline", "law.spans=32"] {
        scene::set(&mut table, change).unwrap();
    }
    let scene = scene::read(&table).unwrap();
    let target = model("young", Some(1.85), 700.0, Feet::Both).unwrap();
    let design = synthesise(&scene, Some(&target)).unwrap();
    let c = coefficients(
        &target,
        design.problem.drive.mass,
        design.problem.drive.speed,
    );
    let (low, high) = design.cam.law.extremes(2);
    let size = high.value.max(-low.value);
    let mut worst = 0.0_f64;
    for k in 0..997 {
        let theta = TAU * f64::from(k) / 997.0;
        let own: f64 = c
            .iter()
            .enumerate()
            .map(|(i, c)| c * curvature(i, theta))
            .sum();
        worst = worst.max((own - design.cam.law.svaj(theta).a).abs());
    }
    assert!(worst < 1e-7 * size, "{worst} of {size}");
}
