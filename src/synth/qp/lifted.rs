//! A law's derivatives as unknowns of their own, for laws of many spans.
//!
//! In the coefficients of the lift alone an acceleration on N spans is N² times a difference of nearly
//! equal numbers, and the condition of the objective's matrix grows like N⁴: from some forty spans on a
//! solver lacks digits. Here the coefficients of s, v, a and j all are unknowns, tied by
//! c′ᵢ = fᵢ (cᵢ − cᵢ₋₁) as the stages of a control problem are (Betts, Practical Methods for Optimal
//! Control, ch. 4). Every row is short and its entries are of ordinary size; `interior::chain` eliminates them span by
//! span.

use super::basis::{Basis, Entries};
use super::pieces::Pieces;
use super::settings::Settings;
use crate::poly::SplineSpace;

/// Highest derivative that limits or objectives ask for.
const HIGHEST: usize = 4;

/// ½dᵀHd + gᵀd over the coefficients d of s and its derivatives, one order after the other.
#[derive(Debug, Clone)]
pub struct Lifted {
    /// Splines of the derivatives, by order.
    spaces: Vec<SplineSpace>,
    /// f of the step from each order to the next.
    factors: Vec<Vec<f64>>,
    /// Highest order that the objective has seen.
    used: usize,
    /// Lower triangle of H.
    blocks: Vec<(usize, usize, f64)>,
    /// g.
    gradient: Vec<f64>,
}

impl Lifted {
    /// With a zero objective; `None` for laws of few spans, and where splines have no such derivatives.
    pub fn new(basis: &Basis) -> Option<Self> {
        let Basis::Spline { space, closed } = basis else {
            return None;
        };
        if !closed || space.spans().len() < Settings::default().lifted_from {
            return None;
        }
        Some(Lifted::of(space))
    }

    fn of(space: &SplineSpace) -> Self {
        let mut spaces = vec![space.clone()];
        let mut factors = Vec::new();
        while spaces.len() <= HIGHEST {
            let Some((next, f)) = spaces[spaces.len() - 1].derivative() else {
                break;
            };
            spaces.push(next);
            factors.push(f);
        }
        let gradient = vec![0.0; spaces.len() * space.dimension()];
        Lifted {
            spaces,
            factors,
            used: 0,
            blocks: Vec::new(),
            gradient,
        }
    }

    /// Degree of the lift.
    pub fn degree(&self) -> usize {
        self.spaces[0].degree()
    }

    /// Coefficients of one order.
    pub fn dimension(&self) -> usize {
        self.spaces[0].dimension()
    }

    /// Whether derivatives of these weights have coefficients here, or vanish.
    pub fn carries(&self, weights: &[f64]) -> bool {
        let known = |order: usize| order < self.spaces.len() || order > self.spaces[0].degree();
        weights
            .iter()
            .enumerate()
            .all(|(order, w)| *w == 0.0 || known(order))
    }

    /// Highest order among weights that a row of them needs.
    pub fn highest(&self, weights: &[f64]) -> usize {
        let last = weights.iter().rposition(|w| *w != 0.0).unwrap_or(0);
        last.min(self.spaces.len() - 1)
    }

    /// Highest order that the objective needs.
    pub fn used(&self) -> usize {
        self.used
    }

    /// Row of Σ wₖ s⁽ᵏ⁾ at u ∈ [0, 1] of a piece over the coefficients of all orders.
    pub fn row(&self, piece: usize, u: f64, weights: &[f64]) -> Entries {
        let n = self.dimension();
        let mut out = Entries::new();
        for (order, &w) in weights.iter().enumerate().take(self.spaces.len()) {
            if w == 0.0 {
                continue;
            }
            let space = &self.spaces[order];
            let values = space.row(piece, u, &[w]);
            let own = values.iter().enumerate();
            out.extend(own.map(|(k, &v)| (order * n + space.index(piece, k), v)));
        }
        out
    }

    /// Adds Σ over pieces and nodes of ½·share·(w·svaj − wanted)²; `asked` gives (share, wanted) of a piece at a
    /// node of the rule.
    pub fn add_distance(
        &mut self,
        weights: &[f64],
        rule: &[(f64, f64)],
        asked: impl Fn(usize, usize) -> (f64, f64),
    ) {
        self.used = self.used.max(self.highest(weights));
        let n = self.dimension();
        let orders: Vec<usize> = (0..self.spaces.len().min(weights.len()))
            .filter(|&order| weights[order] != 0.0)
            .collect();
        // Weights of a machine without measurable mass vanish.
        if orders.is_empty() {
            return;
        }
        let mut alike = None;
        let (mut rows, mut columns, mut gram) = (Vec::new(), Vec::new(), Vec::new());
        for piece in 0..self.spaces[0].spans().len() {
            columns.clear();
            for &order in &orders {
                let space = &self.spaces[order];
                columns.extend((0..=space.degree()).map(|k| order * n + space.index(piece, k)));
            }
            // Spans with equal knots around them have equal rows.
            let span = &self.spaces[0].spans()[piece];
            let same = alike.is_some_and(|(matrix, width): (usize, f64)| {
                matrix == span.matrix() && (width - span.width).abs() <= 1e-14 * width
            });
            if !same {
                alike = Some((span.matrix(), span.width));
                rows.clear();
                for &(u, _) in rule {
                    for &order in &orders {
                        rows.extend(self.spaces[order].row(piece, u, &[weights[order]]));
                    }
                }
            }
            let m = columns.len();
            if piece == 0 {
                let pieces = self.spaces[0].spans().len();
                self.blocks.reserve(pieces * m * (m + 1) / 2);
            }
            gram.clear();
            gram.resize(m * m, 0.0);
            for (node, row) in rows.chunks_exact(m).enumerate() {
                let (share, wanted) = asked(piece, node);
                for (k, &a) in row.iter().enumerate() {
                    self.gradient[columns[k]] -= share * wanted * a;
                    for (g, b) in gram[k * m..=k * m + k].iter_mut().zip(row) {
                        *g += share * a * b;
                    }
                }
            }
            for (k, &i) in columns.iter().enumerate() {
                for (l, &j) in columns[..=k].iter().enumerate() {
                    self.blocks.push((i.max(j), i.min(j), gram[k * m + l]));
                }
            }
        }
    }

    /// Adds another objective over the same coefficients, `factor` times.
    pub fn add(&mut self, other: &Lifted, factor: f64) {
        self.used = self.used.max(other.used);
        let blocks = other.blocks.iter().map(|&(i, j, v)| (i, j, factor * v));
        self.blocks.extend(blocks);
        for (own, g) in self.gradient.iter_mut().zip(&other.gradient) {
            *own += factor * g;
        }
    }

    /// Multiplies the objective.
    pub fn scale(&mut self, factor: f64) {
        self.blocks.iter_mut().for_each(|b| b.2 *= factor);
        self.gradient.iter_mut().for_each(|g| *g *= factor);
    }

    /// Lower triangle of H; an entry may come in several parts.
    pub fn blocks(&self) -> &[(usize, usize, f64)] {
        &self.blocks
    }

    /// g.
    pub fn gradient(&self) -> &[f64] {
        &self.gradient
    }

    /// f of the step from each order to the next.
    pub fn factors(&self) -> &[Vec<f64>] {
        &self.factors
    }

    /// Largest diagonal entry of H.
    pub fn largest_diagonal(&self) -> f64 {
        let mut diagonal = vec![0.0; self.gradient.len()];
        for &(i, j, v) in &self.blocks {
            if i == j {
                diagonal[i] += v;
            }
        }
        diagonal.into_iter().fold(0.0, f64::max)
    }

    /// Coefficients of all orders from those of the lift; beyond what the objective needs they are zero.
    pub fn derivatives(&self, x: &[f64]) -> Vec<f64> {
        self.derivatives_to(x, self.used)
    }

    /// The same up to one order.
    pub fn derivatives_to(&self, x: &[f64], highest: usize) -> Vec<f64> {
        let n = self.dimension();
        let mut out = Vec::with_capacity(self.gradient.len());
        out.extend_from_slice(&x[..n]);
        for (order, factors) in self.factors[..highest].iter().enumerate() {
            let from = order * n;
            let mut before = out[from + n - 1];
            for i in 0..n {
                let own = out[from + i];
                out.push(factors[i] * (own - before));
                before = own;
            }
        }
        out.resize(self.gradient.len(), 0.0);
        out
    }

    /// Derivatives up to one order in Bernstein form, each from its own coefficients.
    pub fn pieces(&self, x: &[f64], highest: usize) -> Pieces {
        let highest = highest.min(self.spaces.len() - 1);
        let d = self.derivatives_to(x, highest);
        let orders = self.spaces[..=highest].iter();
        Pieces::of_derivatives(orders.zip(d.chunks_exact(self.dimension())))
    }

    /// ½dᵀHd + gᵀd at a law.
    pub fn value(&self, x: &[f64]) -> f64 {
        let d = self.derivatives(x);
        let pull = self.pull(&d);
        let g = &self.gradient;
        (0..d.len()).map(|i| 0.5 * d[i] * (pull[i] + g[i])).sum()
    }

    /// Hd + g.
    pub fn pull(&self, d: &[f64]) -> Vec<f64> {
        let mut out = self.gradient.clone();
        for &(i, j, v) in &self.blocks {
            out[i] += v * d[j];
            if i != j {
                out[j] += v * d[i];
            }
        }
        out
    }

    /// A row over all orders as one over the coefficients of the lift.
    pub fn folded(&self, mut y: Vec<f64>) -> Vec<f64> {
        let n = self.dimension();
        for (order, f) in self.factors.iter().enumerate().rev() {
            let (below, above) = y.split_at_mut((order + 1) * n);
            let own = &mut below[order * n..];
            for i in 0..n {
                let next = (i + 1) % n;
                own[i] += f[i] * above[i] - f[next] * above[next];
            }
        }
        y.truncate(n);
        y
    }

    /// A gradient by the coefficients of the lift as one by those of its derivative of one order, the law closed and its
    /// level held: what `integrated` makes of a change, transposed.
    pub fn summed(&self, mut gradient: Vec<f64>, order: usize) -> Vec<f64> {
        let n = self.dimension() as f64;
        let mean = gradient.iter().sum::<f64>() / n;
        gradient.iter_mut().for_each(|g| *g -= mean);
        for f in &self.factors[..order] {
            let (mut sum, mut total, mut length) = (0.0, 0.0, 0.0);
            for (g, f) in gradient.iter_mut().zip(f).rev() {
                sum += *g;
                *g = sum / f;
                total += *g;
                length += 1.0 / f;
            }
            for (g, f) in gradient.iter_mut().zip(f) {
                *g -= total / length / f;
            }
        }
        gradient
    }

    /// Coefficients of the lift from those of its derivative of one order, counted from `start`: sums, which keep the digits
    /// that differences lose, each rounded once. Their mean is put right so that the law closes; `level` is what the lift's
    /// mean gains.
    pub fn integrated(&self, start: &[f64], highest: &[f64], order: usize, level: f64) -> Vec<f64> {
        let n = self.dimension();
        let mut own: Vec<Sum> = highest.iter().map(|&c| Sum::of(c)).collect();
        for f in self.factors[..order].iter().rev() {
            // The mean, and what the roundings of the first pass left of it.
            for _ in 0..2 {
                let (mut ends, mut length) = (Sum::default(), 0.0);
                for (c, f) in own.iter().zip(f) {
                    ends.add(c.high / f);
                    ends.add(c.low / f);
                    length += 1.0 / f;
                }
                let excess = (ends.high + ends.low) / length;
                own.iter_mut().for_each(|c| c.add(-excess));
            }
            let mut sum = Sum::default();
            for (c, f) in own.iter_mut().zip(f) {
                sum.add(c.high / f);
                sum.add(c.low / f);
                *c = sum;
            }
        }
        let mean = own.iter().map(|c| c.high).sum::<f64>() / n as f64;
        let raised = own.into_iter().zip(start).map(|(mut c, start)| {
            c.add(level - mean);
            c.add(*start);
            c.high + c.low
        });
        raised.collect()
    }
}

/// A sum and what its roundings left over (Knuth's two-sum).
#[derive(Debug, Clone, Copy, Default)]
struct Sum {
    high: f64,
    low: f64,
}

impl Sum {
    fn of(value: f64) -> Sum {
        Sum {
            high: value,
            low: 0.0,
        }
    }

    fn add(&mut self, value: f64) {
        let sum = self.high + value;
        let of_value = sum - self.high;
        self.low += (self.high - (sum - of_value)) + (value - of_value);
        self.high = sum;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::poly::gauss_legendre;
    use crate::synth::qp::basis::apply;
    use crate::synth::qp::objective::{Quadratic, pointwise};
    use std::f64::consts::TAU;

    fn space(spans: usize) -> SplineSpace {
        SplineSpace::periodic_uniform(5, spans, TAU)
    }

    fn wave(n: usize) -> Vec<f64> {
        (0..n)
            .map(|i| TAU * i as f64 / n as f64)
            .map(|x| (2.0 * x).sin() + 0.3 * (3.0 * x).cos() + 0.5)
            .collect()
    }

    #[test]
    fn rows_values_and_gradients_are_those_of_the_lift_alone() {
        let n = 40;
        let basis = Basis::Spline {
            space: space(n),
            closed: true,
        };
        let x = wave(n);
        let weights = [2.0, -0.3, 1.0, 0.1];
        let mut plain = Quadratic::zero(&basis);
        plain.add_distance(&basis, &weights, 7, pointwise(f64::cos), None);
        let mut lifted = Lifted::of(&space(n));
        let width = TAU / n as f64;
        let rule = gauss_legendre(7);
        lifted.add_distance(&weights, &rule, |piece, node| {
            let (u, w) = rule[node];
            (w / n as f64, ((piece as f64 + u) * width).cos())
        });
        let d = lifted.derivatives(&x);
        for (piece, u) in [(0, 0.2), (17, 0.5), (39, 1.0)] {
            let own = apply(&lifted.row(piece, u, &weights), &d);
            let row = apply(&basis.row_on(piece, u, &weights), &x);
            assert!((own - row).abs() < 1e-9, "{own} {row}");
        }
        let hx = plain.hessian.times(&x);
        let value: f64 = (0..n)
            .map(|i| x[i] * (0.5 * hx[i] + plain.gradient[i]))
            .sum();
        assert!((lifted.value(&x) / value - 1.0).abs() < 1e-9);
        let gradient = lifted.folded(lifted.pull(&d));
        let size = hx.iter().fold(0.0_f64, |m, h| m.max(h.abs()));
        for i in 0..n {
            assert!((gradient[i] - hx[i] - plain.gradient[i]).abs() < 1e-9 * size);
        }
    }

    /// ⟨g, integrated(d)⟩ = ⟨summed(g), d⟩ for every d.
    #[test]
    fn a_gradient_is_summed_as_a_law_is_integrated() {
        let n = 300;
        let lifted = Lifted::of(&space(n));
        let gradient: Vec<f64> = (0..n).map(|i| ((i * i) as f64 * 0.37).sin()).collect();
        let change: Vec<f64> = (0..n).map(|i| ((i * 7) as f64 * 0.11).cos()).collect();
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        for order in 0..=3 {
            let moved = lifted.integrated(&vec![0.0; n], &change, order, 0.0);
            let (here, there) = (
                dot(&gradient, &moved),
                dot(&lifted.summed(gradient.clone(), order), &change),
            );
            assert!(
                (here - there).abs() < 1e-11 * n as f64,
                "{order}: {here} {there}"
            );
        }
    }

    #[test]
    fn sums_undo_differences() {
        let n = 4000;
        let lifted = Lifted::of(&space(n));
        let x = wave(n);
        let d = lifted.derivatives_to(&x, HIGHEST);
        let level = x.iter().sum::<f64>() / n as f64;
        for order in 1..=3 {
            let zero = vec![0.0; n];
            let back = lifted.integrated(&zero, &d[order * n..(order + 1) * n], order, level);
            let worst = (0..n).fold(0.0_f64, |m, i| m.max((back[i] - x[i]).abs()));
            assert!(worst < 1e-11, "{order}: {worst:e}");
        }
    }
}
