//! Gauss–Legendre quadrature on [0, 1].

use std::f64::consts::PI;
use std::sync::OnceLock;

/// Maximum number of nodes of one rule. For more nodes, the interval is divided into equal parts with one rule each.
const LARGEST: usize = 16;

/// At least `n` nodes in (0, 1) with their weights, whose sum is 1. If `n` exceeds 16, the interval is divided into equal parts with one
/// rule each. A Gauss–Legendre rule with m nodes integrates polynomials of degree 2m − 1 exactly.
pub fn gauss_legendre(n: usize) -> Vec<(f64, f64)> {
    let parts = n.max(1).div_ceil(LARGEST);
    let m = n.max(1).div_ceil(parts);
    let rule = cached_rule(m);
    let width = 1.0 / parts as f64;
    (0..parts)
        .flat_map(|p| {
            rule.iter()
                .map(move |&(x, w)| ((p as f64 + x) * width, w * width))
        })
        .collect()
}

/// Gauss–Legendre rule with m ≤ 16 nodes. Each rule is computed only once.
fn cached_rule(m: usize) -> &'static [(f64, f64)] {
    static RULES: [OnceLock<Vec<(f64, f64)>>; LARGEST + 1] =
        [const { OnceLock::new() }; LARGEST + 1];
    RULES[m].get_or_init(|| single_rule(m))
}

/// Computes the nodes by Newton's method for the roots of the Legendre polynomial, from the usual cosine estimate.
fn single_rule(m: usize) -> Vec<(f64, f64)> {
    let mut out: Vec<(f64, f64)> = (0..m)
        .map(|i| {
            let mut x = libm::cos(PI * (i as f64 + 0.75) / (m as f64 + 0.5));
            let mut slope = 1.0;
            for _ in 0..100 {
                let (p, dp) = legendre(m, x);
                slope = dp;
                let step = p / dp;
                x -= step;
                if step.abs() < 1e-16 {
                    break;
                }
            }
            (0.5 * (1.0 + x), 1.0 / ((1.0 - x * x) * slope * slope))
        })
        .collect();
    out.reverse();
    out
}

/// Value and derivative of the Legendre polynomial Pₘ at x.
fn legendre(m: usize, x: f64) -> (f64, f64) {
    let (mut before, mut p) = (1.0, x);
    for k in 2..=m {
        let k = k as f64;
        (before, p) = (p, ((2.0 * k - 1.0) * x * p - (k - 1.0) * before) / k);
    }
    let p_m = if m == 0 { 1.0 } else { p };
    (p_m, m as f64 * (x * p - before) / (x * x - 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rule_of_m_nodes_is_exact_to_degree_2m_minus_1() {
        for m in 1..=16 {
            let rule = gauss_legendre(m);
            for degree in 0..2 * m as i32 {
                let sum: f64 = rule.iter().map(|(x, w)| w * x.powi(degree)).sum();
                assert!(
                    (sum - 1.0 / f64::from(degree + 1)).abs() < 1e-14,
                    "{m} {degree}"
                );
            }
        }
        let long: f64 = gauss_legendre(100).iter().map(|(x, w)| w * x.exp()).sum();
        assert!((long - (1.0_f64.exp() - 1.0)).abs() < 1e-14);
    }
}
