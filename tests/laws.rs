//! Laws of motion against the tables of the papers and of the trade.

use gaitcam::law::{Condition, Law, hermite_birkhoff};
use gaitcam::poly::bernstein;

/// FACTS §2: paper 001, critical points with unrounded s = F/k, at rest at both ends. Inches.
fn paper_rise() -> Law {
    let k = 30.0 * (std::f64::consts::PI * 0.75 * 0.75_f64).powi(2);
    let mut conditions = Vec::new();
    for (degrees, force) in [
        (0.0, 0.0),
        (56.88, 110.282),
        (123.84, 79.338),
        (198.72, 106.667),
        (256.32, 0.0),
    ] {
        conditions.push((degrees, 0, force / k));
    }
    for end in [0.0, 256.32] {
        conditions.extend([(end, 1, 0.0), (end, 2, 0.0)]);
    }
    let conditions: Vec<Condition> = conditions
        .into_iter()
        .map(|(degrees, order, value): (f64, usize, f64)| Condition {
            theta: degrees.to_radians(),
            order,
            value,
        })
        .collect();
    let poly = hermite_birkhoff(&conditions, 0.0, 256.32_f64.to_radians()).unwrap();
    Law::from_poly(poly, false)
}

#[test]
fn paper_coefficients_come_from_its_boundary_conditions() {
    let law = paper_rise();
    let c = bernstein::to_power(law.poly().piece(0));
    let printed = [
        612.721, -4057.255, 10696.565, -13873.375, 8822.470, -2201.126,
    ];
    for (k, expected) in printed.iter().enumerate() {
        assert!(
            (c[k + 3] - expected).abs() < 0.001,
            "C{} = {}",
            k + 3,
            c[k + 3]
        );
    }
    assert!(c[..3].iter().all(|x| x.abs() < 1e-10));
}

#[test]
fn paper_peaks_are_those_of_the_continuous_law() {
    // FACTS §2, recomputed column; ω = 4π rad/s, inches and pounds.
    let law = paper_rise();
    let w = 4.0 * std::f64::consts::PI;
    let k = 30.0 * (std::f64::consts::PI * 0.75 * 0.75_f64).powi(2);
    let (_, top) = law.extremes(0);
    assert!((top.value * k - 126.183).abs() < 5e-4 && (top.value - 1.3469).abs() < 5e-5);
    assert!((top.at.to_degrees() - 74.39).abs() < 5e-3 && (top.at / w - 0.1033).abs() < 5e-5);
    assert!((law.svaj(135_f64.to_radians()).s - 0.8450).abs() < 5e-5);
    let velocity = law.combination([0.0, 1.0, 0.0, 0.0], 0.0);
    let valley = velocity.roots()[1];
    assert!((valley.to_degrees() - 129.64).abs() < 5e-3);
    assert!((law.svaj(valley).s - 0.8345).abs() < 5e-5);
    let (_, v) = law.extremes(1);
    assert!((v.value * w - 22.550).abs() < 5e-4 && (v.at.to_degrees() - 37.22).abs() < 5e-3);
    let (a_min, a_max) = law.extremes(2);
    assert!((a_max.value * w * w - 685.53).abs() < 5e-3);
    assert!((a_max.at.to_degrees() - 14.11).abs() < 5e-3);
    assert!((a_min.value * w * w + 594.22).abs() < 5e-3);
    let end = 256.32_f64.to_radians();
    assert!((law.svaj(0.0).j - 41.0615).abs() < 5e-5);
    assert!((law.svaj(end).j + 39.8575).abs() < 5e-5);
}
