//! Published models of the force under one foot: Li et al. 2010 and the test load of ISO 22675.

use std::f64::consts::PI;

use super::phases;
use crate::recording::Feet;

/// One stride of one foot, or one step of both feet half a stride apart, in body weights.
pub(super) fn single_foot(name: &str, f: f64, feet: Feet) -> Vec<f64> {
    let stance = |t: f64| match name {
        "li-2010" => li_2010(f, t),
        _ => iso_22675(t),
    };
    let stride = 2.0 / f;
    match feet {
        Feet::Both | Feet::Total => phases()
            .map(|x| stance(x / f) + stance(x / f + 0.5 * stride))
            .collect(),
        Feet::One | Feet::Left | Feet::Right => phases().map(|x| stance(x * stride)).collect(),
    }
}

/// Model of Li et al. 2010: one stance in body weights at the time `t`, s, after heel strike; zero outside the stance.
pub(super) fn li_2010(f: f64, t: f64) -> f64 {
    let stance = 1.0 / (0.76 * f);
    if !(0.0..=stance).contains(&t) {
        return 0.0;
    }
    let a = [
        -0.0698 * f + 1.211,
        0.1052 * f - 0.1284,
        0.3002 * f - 0.1534,
        0.0416 * f - 0.0288,
        -0.0275 * f + 0.0608,
    ];
    let waves = a.iter().zip(1..);
    waves
        .map(|(a, n)| a * libm::sin(f64::from(n) * PI * t / stance))
        .sum()
}

/// ISO 22675: load divided by F1cmax at the time `t`, s, after heel strike; zero outside the stance of 600 ms.
pub(super) fn iso_22675(t: f64) -> f64 {
    if !(0.0..=0.6).contains(&t) {
        return 0.0;
    }
    let t = 1e3 * t; // the formula of the standard is in milliseconds
    let powers = [
        3624.95690883228,
        1646.51497111425e-1,
        -1671.01914899229e-3,
        5988.82225167948e-6,
        -9203.7374110419e-9,
        5123.06842296552e-12,
    ];
    1e-6 * t * powers.iter().rev().fold(0.0, |sum, c| sum * t + c)
}
