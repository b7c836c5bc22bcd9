//! A law of many spans as a chain of stages, whose controls are eliminated one by one.
//!
//! In the coefficients of the lift the matrix of N spans has a condition of N⁴ and more (theory §9). Here the unknowns
//! are the coefficients of s and of each derivative up to the highest, K, that objective and limits ask for, tied by
//! c′ᵢ = fᵢ (cᵢ − cᵢ₋₁) as the stages of a control problem are. Whatever a law of degree d has in span i follows from
//!
//! ```text
//! yᵢ = (s, v, …, c⁽ᴷ⁾)ᵢ, c⁽ᴷ⁾ᵢ₋₁, …, c⁽ᴷ⁾ᵢ₋₍d₋K₎        d + 1 numbers, the window of span i
//! ```
//!
//! and the next window from the first d of them and the next c⁽ᴷ⁾, the control. Bellman's recursion minimises over the
//! controls from the last span to the first (Betts, Practical Methods for Optimal Control, ch. 4; Rao, Wright and
//! Rawlings, JOTA 99, 1998); what the window before the first span, the demands and the variables beside the law leave is
//! a small dense system. That the turn closes is d demands: the window after the last span is the one before the first.
//! Cost is in proportion to the spans, and usual digits are enough.

mod factor;
mod layout;
mod rows;

pub use factor::Factor;
pub use layout::Layout;
pub use rows::Windowed;

use crate::synth::qp::lifted::Lifted;

/// Size of a window of quintics, which are the rule: loops of known length cost half.
const QUINTIC: usize = 6;

/// ½uᵀHu of a chain.
#[derive(Debug, Clone)]
pub struct Chain {
    pub layout: Layout,
    /// Symmetric matrix of each window, row by row.
    windows: Vec<f64>,
    /// Unknowns beside the law.
    pub beside: usize,
}

impl Chain {
    /// The objective, `factor` times; entries of the lower triangle may come in several parts.
    pub fn new(layout: Layout, lifted: &Lifted, factor: f64, beside: usize) -> Self {
        let (n, w) = (layout.spans, layout.window());
        let mut windows = vec![0.0; n * w * w];
        let (mut a, mut b) = (vec![0.0; w], vec![0.0; w]);
        for &(i, j, value) in lifted.blocks() {
            let (p, q) = ((i / n, i % n), (j / n, j % n));
            let span = layout.span_of([p, q].into_iter());
            layout.over_window(span, [(p.0, p.1, 1.0)].into_iter(), &mut a);
            layout.over_window(span, [(q.0, q.1, 1.0)].into_iter(), &mut b);
            let half = if i == j { 0.5 } else { 1.0 } * value * factor;
            let own = &mut windows[span * w * w..][..w * w];
            for (k, row) in own.chunks_exact_mut(w).enumerate() {
                // A coefficient of the highest order is one number of its window.
                if a[k] == 0.0 && b[k] == 0.0 {
                    continue;
                }
                let (ak, bk) = (half * a[k], half * b[k]);
                for ((entry, a), b) in row.iter_mut().zip(&a).zip(&b) {
                    *entry += ak * b + bk * a;
                }
            }
        }
        Chain {
            layout,
            windows,
            beside,
        }
    }

    /// Hu.
    pub fn times(&self, u: &[f64]) -> Vec<f64> {
        let w = self.layout.window();
        let mut out = vec![0.0; u.len()];
        let mut y = vec![0.0; w];
        for (span, own) in self.windows.chunks_exact(w * w).enumerate() {
            for (y, i) in y.iter_mut().zip(self.layout.indices(span)) {
                *y = u[i];
            }
            for (row, i) in own.chunks_exact(w).zip(self.layout.indices(span)) {
                out[i] += row.iter().zip(&y).map(|(a, y)| a * y).sum::<f64>();
            }
        }
        out
    }

    /// The largest part of a gradient over all unknowns that no control, no window before the first span and no unknown
    /// beside the law can balance: what a stage's tie takes over is pushed on to the stage before.
    pub fn unbalanced(&self, gradient: &[f64]) -> f64 {
        let layout = &self.layout;
        let (d, k) = (layout.degree, layout.highest);
        let mut most = 0.0_f64;
        let mut v = vec![0.0; d + 1];
        for span in (0..layout.spans).rev() {
            self.pulled_back(gradient, span, &mut v);
            most = most.max(v[k].abs());
            moved_up(&mut v, k, d + 1);
        }
        for (j, v) in v[..d].iter().enumerate() {
            most = most.max((v + gradient[layout.in_window(-1, j)]).abs());
        }
        let beside = &gradient[layout.unknowns()..];
        beside.iter().fold(most, |m, g| m.max(g.abs()))
    }

    /// A gradient by the window after a span's, from one by that window: over (x, control) of the span before.
    #[inline(always)]
    fn pulled_back(&self, gradient: &[f64], span: usize, v: &mut [f64]) {
        let layout = &self.layout;
        for (order, v) in v.iter_mut().enumerate().take(layout.highest + 1) {
            *v += gradient[layout.own(order, span)];
        }
        for order in 0..layout.highest {
            v[order + 1] += v[order] * layout.steps[order][span];
        }
    }
}

/// A window's numbers without the control, at `k`: those behind it move up, the last is free.
#[inline(always)]
fn moved_up(numbers: &mut [f64], k: usize, w: usize) {
    numbers.copy_within(k + 1..w, k);
    numbers[w - 1] = 0.0;
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::poly::SplineSpace;
    use crate::synth::qp::basis::Basis;
    use crate::synth::qp::basis::Entries;
    use crate::synth::qp::interior::system::Line;
    use crate::synth::qp::objective::{Quadratic, pointwise};
    use nalgebra::{DMatrix, DVector};
    use std::f64::consts::TAU;

    const SPANS: usize = 160;

    /// A distance on s, v and a of a closed quintic, its factor with rows and a demand, against the dense system in the
    /// coefficients of the lift.
    #[test]
    fn the_windows_have_the_optimum_of_the_dense_system() {
        let basis = Basis::Spline {
            space: SplineSpace::periodic_uniform(5, SPANS, TAU),
            closed: true,
        };
        let mut distance = Quadratic::zero(&basis);
        distance.add_distance(&basis, &[2.0, -0.3, 1.0], 7, pointwise(f64::cos), None);
        let lifted = distance.lifted.as_ref().unwrap();
        // Rows on jerk, acceleration and lift, the first across the start of the turn; the demand is on the velocity.
        let rows: [(usize, [f64; 5], f64); 4] = [
            (1, [0.0, 0.0, 0.0, 1.0, 0.0], 0.3),
            (70, [0.0, 0.0, 1.0, 0.0, 0.0], 5.0),
            (71, [0.5, 0.0, 1.0, 0.2, 0.0], 3.0),
            (159, [1.0, 0.0, 0.0, 0.0, 0.0], 2.0),
        ];
        let velocity = (33, [0.0, 1.0, 0.0, 0.0, 0.0]);
        let pull: Vec<f64> = (0..SPANS).map(|i| (i as f64).sin()).collect();

        let mut dense = DMatrix::zeros(SPANS + 1, SPANS + 1);
        let mut wanted = DVector::zeros(SPANS + 1);
        for (i, j, value) in distance.hessian.lower_entries() {
            dense[(i, j)] = value;
            dense[(j, i)] = value;
        }
        for &(piece, weights, weight) in &rows {
            let row = basis.row_on(piece, 0.4, &weights);
            for &(i, a) in &row {
                row.iter()
                    .for_each(|&(j, b)| dense[(i, j)] += weight * a * b);
            }
        }
        for (i, a) in basis.row_on(velocity.0, 0.4, &velocity.1) {
            dense[(SPANS, i)] = a;
            dense[(i, SPANS)] = a;
        }
        (0..SPANS).for_each(|i| wanted[i] = pull[i]);
        wanted[SPANS] = 0.7;
        let expected = dense.lu().solve(&wanted).unwrap();

        let chain = Chain::new(Layout::new(lifted, 3), lifted, 1.0, 0);
        let layout = &chain.layout;
        let over_window = |piece: usize, weights: &[f64]| {
            let entries = lifted.row(piece, 0.4, weights);
            (Some(layout.window_of(&entries)), layout.row(&entries))
        };
        let mut lines: Vec<(Option<usize>, Entries, f64)> = (rows.iter())
            .map(|(piece, weights, weight)| {
                let (window, entries) = over_window(*piece, weights);
                (window, entries, *weight)
            })
            .collect();
        lines.sort_by_key(|line| line.0);
        let weights: Vec<f64> = lines.iter().map(|line| line.2).collect();
        let lines: Vec<(Option<usize>, Entries)> = lines
            .into_iter()
            .map(|(w, entries, _)| (w, entries))
            .collect();
        let windowed = Windowed::new(layout, &lines);
        let mut demands = vec![Line::new(over_window(velocity.0, &velocity.1).1, 0.7)];
        demands.extend(layout.closing());
        let factor = chain.factor(&windowed, &weights, &demands, &[]).unwrap();
        let mut x = vec![0.0; layout.unknowns()];
        (0..SPANS).for_each(|i| x[layout.own(0, i)] = pull[i]);
        let bounds: Vec<f64> = demands.iter().map(|d| d.bound).collect();
        let nu = factor.solve(&chain, &mut x, &bounds);
        let law = layout.lift(lifted, &[0.0; SPANS], &x, 1.0);
        let size = expected.rows(0, SPANS).amax();
        // The dense system has a condition of 10⁹.
        for i in 0..SPANS {
            assert!(
                (law[i] - expected[i]).abs() < 1e-7 * size,
                "{i}: {} {}",
                law[i],
                expected[i]
            );
        }
        assert!(
            (nu[0] / expected[SPANS] - 1.0).abs() < 1e-6,
            "{} {}",
            nu[0],
            expected[SPANS]
        );
        // The windows' own gradient vanishes there, and the rows have their values.
        let mut left = chain.times(&x);
        let values = windowed.values(layout, &x);
        let pushes: Vec<f64> = values.iter().zip(&weights).map(|(v, w)| v * w).collect();
        windowed.add_to(layout, &pushes, &mut left);
        demands
            .iter()
            .zip(&nu)
            .for_each(|(d, nu)| d.add_to(&mut left, *nu));
        (0..SPANS).for_each(|i| left[layout.own(0, i)] -= pull[i]);
        assert!(chain.unbalanced(&left) < 1e-9 * chain.unbalanced(&pull_of(layout, &pull)));
    }

    fn pull_of(layout: &Layout, pull: &[f64]) -> Vec<f64> {
        let mut out = vec![0.0; layout.unknowns()];
        (0..SPANS).for_each(|i| out[layout.own(0, i)] = pull[i]);
        out
    }
}
