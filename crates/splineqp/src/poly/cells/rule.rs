//! Quadrature on a cell, several nodes side by side, and a cell's polynomial on a part of it.

use super::{Ends, by_ends};
use crate::poly::gauss_legendre;

/// Value of a cubic in Bernstein form.
pub fn cubic([a, b, c, d]: &[f64; 4], u: f64) -> f64 {
    let v = 1.0 - u;
    v * v * (v * a + 3.0 * u * b) + u * u * (3.0 * v * c + u * d)
}

/// A rule of Gauss and Legendre on a cell, with Hermite's cubics at its nodes.
pub struct Rule<const Q: usize> {
    nodes: [f64; Q],
    /// Their weights.
    pub weights: [f64; Q],
    cubics: [[f64; Q]; 4],
}

impl<const Q: usize> Rule<Q> {
    pub fn new() -> Self {
        let rule = gauss_legendre(Q);
        let nodes: [f64; Q] = std::array::from_fn(|q| rule[q].0);
        Rule {
            nodes,
            weights: std::array::from_fn(|q| rule[q].1),
            cubics: std::array::from_fn(|k| {
                let mut unit = [0.0; 4];
                unit[k] = 1.0;
                nodes.map(|u| cubic(&by_ends(unit), u))
            }),
        }
    }

    /// The nodes on a range.
    #[inline(always)]
    pub fn places(&self, from: f64, to: f64) -> [f64; Q] {
        self.nodes.map(|t| from + t * (to - from))
    }

    /// A cubic at the nodes of its cell, by the cell's ends.
    #[inline(always)]
    pub fn on_cell(&self, c: &Ends) -> [f64; Q] {
        std::array::from_fn(|q| {
            let [first, second, third, fourth] = &self.cubics;
            c[0] * first[q] + c[1] * second[q] + (c[2] * third[q] + c[3] * fourth[q])
        })
    }

    /// Largest distance of a place of the cell from the nearest node.
    pub fn widest_gap(&self) -> f64 {
        let between = self.nodes.windows(2).map(|w| 0.5 * (w[1] - w[0]));
        between.fold(self.nodes[0].max(1.0 - self.nodes[Q - 1]), f64::max)
    }
}

/// Coefficients of a polynomial on a part of its range, written in the degree that `out` has room for.
#[inline(always)]
pub fn restricted(b: &[f64], (low, high): (f64, f64), out: &mut [f64]) {
    let own = b.len() - 1;
    let c = &mut out[..=own];
    c.copy_from_slice(b);
    if high < 1.0 {
        for k in 1..=own {
            for i in (k..=own).rev() {
                c[i] += (1.0 - high) * (c[i - 1] - c[i]);
            }
        }
    }
    if low > 0.0 {
        let u = low / high.min(1.0);
        for k in 1..=own {
            for i in 0..=own - k {
                c[i] += u * (c[i + 1] - c[i]);
            }
        }
    }
    for m in own + 1..out.len() {
        out[m] = out[m - 1];
        for i in (1..m).rev() {
            let t = i as f64 / m as f64;
            out[i] = t * out[i - 1] + (1.0 - t) * out[i];
        }
    }
}
