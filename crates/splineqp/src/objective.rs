//! Quadratic objectives: squared distance between force and target, and energies of derivatives.

use super::band::ArrowMatrix;
use super::basis::{Basis, Entries, apply, only};
use super::frame::dot;
use crate::poly::{SplineSpace, gauss_legendre};

/// Quadratic function ½xᵀHx + gᵀx + constant of the coefficients x of a law.
#[derive(Debug, Clone)]
pub struct Quadratic {
    /// Symmetric matrix H of the quadratic part.
    pub hessian: ArrowMatrix,
    /// Vector g of the linear part.
    pub gradient: Vec<f64>,
    /// Constant term of the function. With this term, the value of the function is the complete mean square or energy.
    pub constant: f64,
}

impl Quadratic {
    /// The zero function for a basis.
    pub fn zero(basis: &Basis) -> Self {
        let (band, border) = basis.pattern();
        let n = basis.columns();
        Quadratic {
            hessian: ArrowMatrix::zero(n, band, border),
            gradient: vec![0.0; n],
            constant: 0.0,
        }
    }

    /// Adds ½·mean over the law of weight(θ)·(w·svaj − target(θ))², with at least `nodes` quadrature nodes on every piece of the basis. The
    /// entries w₀ … w₄ of `weights` belong to s, v, a, j and the fourth derivative. `target` computes the target at the nodes of a piece
    /// that is given by its start and width. [`pointwise`] converts a function of θ to this form.
    pub fn add_distance(
        &mut self,
        basis: &Basis,
        weights: &[f64],
        nodes: usize,
        mut target: impl FnMut(f64, f64, &[(f64, f64)], &mut [f64]),
        weight: Option<&dyn Fn(f64) -> f64>,
    ) {
        let breaks = basis.breaks();
        let total = breaks[breaks.len() - 1] - breaks[0];
        let rule = gauss_legendre(nodes);
        let mut values = vec![0.0; rule.len()];
        let mut table = Table::default();
        let alike = match basis {
            Basis::Spline { space, .. } => weight.is_none() && space.is_uniform(),
            Basis::Harmonic { .. } => false,
        };
        for (i, ends) in breaks.windows(2).enumerate() {
            let (start, width) = (ends[0], ends[1] - ends[0]);
            target(start, width, &rule, &mut values);
            match basis {
                Basis::Spline { space, .. } => {
                    let as_before = table.fit(space, i, &rule, weights);
                    // Equal spans with the same weight differ only in their target.
                    if let Some(weight) = weight {
                        table.weigh(&rule, |u| width / total * weight(start + u * width));
                    } else if !as_before {
                        table.weigh(&rule, |_| width / total);
                    }
                    self.constant += table.pull(&values);
                    self.add_pull(space, i, &table.pull);
                    match (alike, i) {
                        (true, 0) => self.add_equal_spans(space, &table.gram),
                        (true, _) => (),
                        (false, _) => self.add_gram(space, i, &table.gram),
                    }
                }
                Basis::Harmonic { .. } => {
                    for (&(u, w), &b) in rule.iter().zip(&values) {
                        let own = weight.map_or(1.0, |f| f(start + u * width));
                        let factor = w * width / total * own;
                        self.add_row(&basis.row_on(i, u, weights), factor, b);
                    }
                }
            }
        }
    }

    /// Adds the linear term pᵀx for the local functions of one span, with p = `pull`.
    fn add_pull(&mut self, space: &SplineSpace, span: usize, pull: &[f64]) {
        let first = space.index(span, 0);
        match self.gradient.get_mut(first..first + pull.len()) {
            Some(own) => own.iter_mut().zip(pull).for_each(|(g, p)| *g += p),
            None => {
                for (k, p) in pull.iter().enumerate() {
                    self.gradient[space.index(span, k)] += p;
                }
            }
        }
    }

    /// Adds the quadratic term ½xᵀGx for the local functions of one span, with G = `gram`.
    fn add_gram(&mut self, space: &SplineSpace, span: usize, gram: &[f64]) {
        if self.hessian.add_block(space.index(span, 0), gram) {
            return;
        }
        let n = space.degree() + 1;
        for k in 0..n {
            for l in 0..=k {
                let (i, j, apart) = (space.index(span, k), space.index(span, l), k - l);
                // With few spans, two functions of a span may have the same coefficient.
                self.hessian.add_pair(i, j, apart, gram[l * n + apart]);
            }
        }
    }

    /// Adds the quadratic term ½xᵀGx of every span of a uniform space, with the same G = `gram`.
    fn add_equal_spans(&mut self, space: &SplineSpace, gram: &[f64]) {
        let n = space.degree() + 1;
        let product = |apart: usize| (0..n - apart).map(|l| gram[l * n + apart]).sum();
        let row: Vec<f64> = (0..n).map(product).collect();
        self.hessian.add_circulant(&row);
    }

    /// Adds the term ½·factor·(row·x − b)² to the function.
    pub fn add_row(&mut self, row: &Entries, factor: f64, b: f64) {
        self.constant += 0.5 * factor * b * b;
        for (p, &(i, a)) in row.iter().enumerate() {
            self.gradient[i] -= factor * b * a;
            for &(j, c) in &row[..=p] {
                self.hessian.add(i, j, factor * a * c);
            }
        }
    }

    /// Adds ½·factor times the mean square of the derivative of the given order (2 = acceleration, 3 = jerk, 4 = fourth derivative).
    pub fn add_energy(&mut self, basis: &Basis, order: usize, factor: f64) {
        let weights = only(order, factor.sqrt());
        let nodes = match basis {
            Basis::Spline { space, .. } => space.degree() + 1,
            Basis::Harmonic { .. } => 9,
        };
        self.add_distance(basis, &weights, nodes, |_, _, _, out| out.fill(0.0), None);
    }

    /// Adds `factor` times another objective with the same basis.
    pub fn add(&mut self, other: &Quadratic, factor: f64) {
        self.hessian.add_scaled(&other.hessian, factor);
        for (own, g) in self.gradient.iter_mut().zip(&other.gradient) {
            *own += factor * g;
        }
        self.constant += factor * other.constant;
    }

    /// The objective multiplied by `factor`.
    #[must_use]
    pub fn times(&self, factor: f64) -> Self {
        let mut out = self.clone();
        out.hessian.scale(factor);
        out.gradient.iter_mut().for_each(|g| *g *= factor);
        out.constant *= factor;
        out
    }

    /// Value of the function for the coefficients `x`.
    pub fn value(&self, x: &[f64]) -> f64 {
        quadratic(&self.hessian, &self.gradient, x) + self.constant
    }

    /// Square root of twice the value for the coefficients `x`. It is the RMS if the function is half a mean square.
    pub fn root(&self, x: &[f64]) -> f64 {
        (2.0 * self.value(x)).max(0.0).sqrt()
    }
}

/// Half a mean square as a sum of squares: ½ Σ factor (row·x − value)² + rest. For many spans, the terms of ½xᵀHx + gᵀx + c are 10¹⁰ times
/// larger than their sum, so about ten digits are lost by cancellation. The sum of squares has no cancellation.
#[derive(Debug, Clone)]
pub struct MeanSquare {
    /// The same function in the form ½xᵀHx + gᵀx + c.
    pub whole: Quadratic,
    /// Rows at the quadrature nodes, with their factors and target values.
    nodes: Vec<(Entries, f64, f64)>,
    /// Constant term of the function, independent of the law.
    rest: f64,
}

impl MeanSquare {
    /// Creates ½·mean over the law of (w·svaj − target(θ))², as in [`Quadratic::add_distance`].
    pub fn distance(
        basis: &Basis,
        weights: &[f64],
        nodes: usize,
        mut target: impl FnMut(f64, f64, &[(f64, f64)], &mut [f64]),
    ) -> Self {
        let breaks = basis.breaks();
        let total = breaks[breaks.len() - 1] - breaks[0];
        let (mut whole, mut all) = (Quadratic::zero(basis), Vec::new());
        whole.add_distance(
            basis,
            weights,
            nodes,
            |start, width, rule, out| {
                target(start, width, rule, out);
                let piece = breaks.partition_point(|b| *b <= start) - 1;
                for (&(u, part), &value) in rule.iter().zip(out.iter()) {
                    let row = basis.row_on(piece, u, weights);
                    all.push((row, part * width / total, value));
                }
            },
            None,
        );
        MeanSquare {
            whole,
            nodes: all,
            rest: 0.0,
        }
    }

    /// The distance with the exact mean square `square` of the target. It is used if the target values at the nodes come from least-squares
    /// polynomials, whose mean square is smaller.
    #[must_use]
    pub fn with_mean_square(mut self, square: f64) -> Self {
        self.rest = 0.5 * square - self.whole.constant;
        self.whole.constant = 0.5 * square;
        self
    }

    /// Half the mean square for the coefficients `x`.
    pub fn value(&self, x: &[f64]) -> f64 {
        let square = |(row, factor, value): &(Entries, f64, f64)| {
            0.5 * factor * (apply(row, x) - value).powi(2)
        };
        self.nodes.iter().map(square).sum::<f64>() + self.rest
    }

    /// Root mean square for the coefficients `x`.
    pub fn root(&self, x: &[f64]) -> f64 {
        (2.0 * self.value(x)).max(0.0).sqrt()
    }

    /// Gradient of half the mean square with respect to all coefficients, at `x`.
    pub(crate) fn gradient(&self, x: &[f64]) -> Vec<f64> {
        let mut out = vec![0.0; x.len()];
        for (row, factor, value) in &self.nodes {
            let miss = factor * (apply(row, x) - value);
            row.iter().for_each(|&(i, a)| out[i] += miss * a);
        }
        out
    }

    /// First and second derivatives of half the mean square at `x`, along the direction `way`.
    pub(crate) fn along(&self, x: &[f64], way: &[f64]) -> (f64, f64) {
        let terms = self.nodes.iter().map(|(row, factor, value)| {
            let moved = apply(row, way);
            (
                factor * moved * (apply(row, x) - value),
                factor * moved * moved,
            )
        });
        terms.fold((0.0, 0.0), |sum, term| (sum.0 + term.0, sum.1 + term.1))
    }
}

/// Value of ½xᵀHx + gᵀx.
pub fn quadratic(hessian: &ArrowMatrix, gradient: &[f64], x: &[f64]) -> f64 {
    let hx = hessian.times(x);
    hx.iter().zip(x).map(|(h, x)| 0.5 * h * x).sum::<f64>()
        + gradient.iter().zip(x).map(|(g, x)| g * x).sum::<f64>()
}

/// Converts a function of θ to the form required by [`Quadratic::add_distance`].
pub fn pointwise(f: impl Fn(f64) -> f64) -> impl Fn(f64, f64, &[(f64, f64)], &mut [f64]) {
    move |start, width, rule, out| {
        for (value, (u, _)) in out.iter_mut().zip(rule) {
            *value = f(start + u * width);
        }
    }
}

/// Values, at the quadrature nodes, of the basis functions that are nonzero on one span, and their products. The table is used again if the
/// next span has the same width and the same basis matrix.
#[derive(Default)]
struct Table {
    matrix: Option<usize>,
    width: f64,
    /// Values of the basis functions at all nodes, function by function.
    values: Vec<f64>,
    /// Values of the basis functions times the quadrature weights of the nodes.
    weighed: Vec<f64>,
    /// Quadrature weights of the nodes.
    factors: Vec<f64>,
    /// Weighted sums over the nodes of the products of functions k and l ≤ k, at the position l·n + k − l, in the layout of
    /// [`ArrowMatrix::add_block`].
    gram: Vec<f64>,
    /// Negative weighted sums of the products of each function with the target, which are the contribution to g.
    pull: Vec<f64>,
}

impl Table {
    /// Computes the table for a span. Returns true if the table of the previous span is still valid.
    fn fit(
        &mut self,
        space: &SplineSpace,
        span: usize,
        rule: &[(f64, f64)],
        weights: &[f64],
    ) -> bool {
        let this = &space.spans()[span];
        let same = self.matrix == Some(this.matrix())
            && (this.width - self.width).abs() <= 1e-14 * this.width;
        if same {
            return true;
        }
        (self.matrix, self.width) = (Some(this.matrix()), this.width);
        let n = space.degree() + 1;
        let places: Vec<f64> = rule.iter().map(|r| r.0).collect();
        self.values.clear();
        self.values.resize(n * places.len(), 0.0);
        space.values(span, &places, weights, &mut self.values);
        self.pull.clear();
        self.pull.resize(n, 0.0);
        false
    }

    /// Multiplies the weights of the nodes by `factor`(u), and computes the weighted values and products.
    fn weigh(&mut self, rule: &[(f64, f64)], factor: impl Fn(f64) -> f64) {
        let (n, nodes) = (self.pull.len(), rule.len());
        self.factors.clear();
        self.factors
            .extend(rule.iter().map(|&(u, w)| w * factor(u)));
        self.weighed.clear();
        for function in self.values.chunks_exact(nodes) {
            let weighed = function.iter().zip(&self.factors).map(|(a, f)| a * f);
            self.weighed.extend(weighed);
        }
        self.gram.clear();
        self.gram.resize(n * n, 0.0);
        for (k, weighed) in self.weighed.chunks_exact(nodes).enumerate() {
            for (l, function) in self.values.chunks_exact(nodes).take(k + 1).enumerate() {
                self.gram[l * n + k - l] = dot(weighed, function);
            }
        }
    }

    /// Computes the products of the functions with the target at the nodes. Returns half the weighted square of the target.
    fn pull(&mut self, target: &[f64]) -> f64 {
        // Loops of constant length take half the time. The default is quintics with one node per function.
        match target.len() {
            6 => self.pull_at(6, target),
            nodes => self.pull_at(nodes, target),
        }
    }

    #[inline(always)]
    fn pull_at(&mut self, nodes: usize, target: &[f64]) -> f64 {
        let target = &target[..nodes];
        let functions = self.weighed.chunks_exact(nodes);
        for (pull, weighed) in self.pull.iter_mut().zip(functions) {
            *pull = -dot(weighed, target);
        }
        let squares = target.iter().zip(&self.factors).map(|(b, f)| f * b * b);
        0.5 * squares.sum::<f64>()
    }
}
