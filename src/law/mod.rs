//! Laws of motion: lift s over the cam angle θ, with exact derivatives v = ds/dθ, a and j.

mod along;
mod cache;
mod derived;
mod extremes;
mod hermite;
mod joint;
mod pieces;
mod program;
mod rise;
mod svaj;

pub use hermite::{Condition, hermite_birkhoff};
pub use joint::Joint;
pub use program::{Extent, Segment, assemble, constant_breadth, program};
pub use rise::{End, Ends, Factors, Rise};
use splineqp::Basis;
pub use splineqp::poly::Wave;
pub use svaj::Svaj;

use crate::poly::{PiecewisePoly, SplineSpace, add_taylor, bernstein, subdivide};
use cache::Cache;
pub(crate) use extremes::weighted;
use serde::Serialize;
use std::sync::Arc;

/// A law of motion. On each span it is a polynomial plus a few sinusoids.
///
/// This form includes all common laws. Splines and polynomials have no sinusoids, and harmonic laws have one span. Modified sine and modified
/// trapezoid have a line or a parabola plus one sinusoid on each span. A *closed* law is periodic with its extent (usually one turn). An open law
/// (translating cam) is not periodic.
///
/// ```
/// use gaitcam::law::{Extent, Rise, Segment, program};
///
/// // A cycloidal rise of 20 mm over half a turn has v = 2h/β at its middle.
/// let pi = std::f64::consts::PI;
/// let up = Segment { motion: Rise::Cycloidal, lift: 0.02, angle: pi };
/// let down = Segment { motion: Rise::Cycloidal, lift: -0.02, angle: pi };
/// let law = program(&[up, down], Extent::TURN)?;
/// assert!((law.svaj(0.5 * pi).v - 2.0 * 0.02 / pi).abs() < 1e-8);
/// assert!((law.stroke() - 0.02).abs() < 1e-9);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Law {
    poly: PiecewisePoly,
    /// Sinusoids of each span; empty for a law without sinusoids.
    waves: Vec<Vec<Wave>>,
    closed: bool,
    /// Derivatives v, a and j, if they have coefficients of their own. Otherwise they are computed from the coefficients of the lift.
    #[serde(skip)]
    derivatives: Option<Arc<[PiecewisePoly; 3]>>,
    #[serde(skip)]
    cache: Cache,
}

/// Minimum number of spans for which the derivatives of a closed spline have their own coefficients. If the jerk is computed from the
/// lift's coefficients, its rounding error is larger by a factor of (spans per turn)³. Without own coefficients, all of several hundred
/// random designs with fewer spans were certified. With 40 to 100 spans, 1 design in 40 was not certified.
pub(crate) const MANY_SPANS: usize = 40;

impl Law {
    /// Law with the coefficients `x` of a basis, such as the solution of an optimisation. Variables after the coefficients are ignored.
    pub fn of(basis: &Basis, x: &[f64]) -> Self {
        match basis {
            Basis::Spline { space, closed } => Law::spline(space, &x[..space.dimension()], *closed),
            Basis::Harmonic { count } => {
                let term = |n: usize| (x[2 * n + 1], x[2 * n + 2]);
                Law::harmonic(x[0], &(0..*count).map(term).collect::<Vec<_>>())
            }
        }
    }

    /// Spline law with the given coefficients in a spline space.
    pub fn spline(space: &SplineSpace, coefficients: &[f64], closed: bool) -> Self {
        let poly = space.spline(coefficients);
        if !closed || space.spans().len() < MANY_SPANS {
            return Law::from_poly(poly, closed);
        }
        let mut orders = Vec::with_capacity(3);
        let (mut own, mut c) = (space.clone(), coefficients.to_vec());
        while let (true, Some((next, factors))) = (orders.len() < 3, own.derivative()) {
            let n = c.len();
            c = (0..n)
                .map(|i| factors[i] * (c[i] - c[(i + n - 1) % n]))
                .collect();
            own = next;
            let pieces = own.spline(&c).coefficients().to_vec();
            let breaks = poly.breaks().to_vec();
            orders.push(PiecewisePoly::new(breaks, own.degree(), pieces));
        }
        match <[PiecewisePoly; 3]>::try_from(orders) {
            Ok(orders) => Law {
                derivatives: Some(orders.into()),
                ..Law::from_poly(poly, closed)
            },
            Err(_) => Law::from_poly(poly, closed),
        }
    }

    /// Polynomial part of the derivative of the given order (0 = lift … 3 = jerk).
    fn of_order(&self, order: usize) -> PiecewisePoly {
        let given = self.derivatives.as_ref().map_or(&[][..], |d| &d[..]);
        match order.checked_sub(1).and_then(|k| given.get(k)) {
            Some(given) => given.clone(),
            None if order == 0 => self.poly.clone(),
            None => self.of_order(order - 1).derivative(),
        }
    }

    /// Law that consists of polynomial spans only.
    pub fn from_poly(poly: PiecewisePoly, closed: bool) -> Self {
        Law::with_waves(poly, Vec::new(), closed)
    }

    /// Law of polynomial spans plus sinusoids. `waves` contains the list of sinusoids of each span, or is empty.
    ///
    /// # Panics
    ///
    /// If `waves` has a length other than 0 or the number of spans, which is an error of the caller.
    pub fn with_waves(poly: PiecewisePoly, waves: Vec<Vec<Wave>>, closed: bool) -> Self {
        assert!(waves.is_empty() || waves.len() == poly.pieces());
        let has_waves = waves.iter().any(|on_piece| !on_piece.is_empty());
        Law {
            poly,
            waves: if has_waves { waves } else { Vec::new() },
            closed,
            derivatives: None,
            cache: Cache::default(),
        }
    }

    /// Harmonic law over one turn: mean + Σ (cₙ cos nθ + sₙ sin nθ), n = 1, 2, …, with `terms` as (cₙ, sₙ).
    pub fn harmonic(mean: f64, terms: &[(f64, f64)]) -> Self {
        let poly = PiecewisePoly::new(vec![0.0, std::f64::consts::TAU], 0, vec![mean]);
        let waves = terms
            .iter()
            .enumerate()
            .map(|(i, &(cos, sin))| Wave {
                rate: (i + 1) as f64,
                cos,
                sin,
            })
            .collect();
        Law::with_waves(poly, vec![waves], true)
    }

    /// Angles at the ends of the spans in ascending order, from the start to the end of the law, rad.
    pub fn breaks(&self) -> &[f64] {
        self.poly.breaks()
    }

    /// Polynomial part of the lift, without sinusoids.
    pub fn poly(&self) -> &PiecewisePoly {
        &self.poly
    }

    /// Sinusoids of span `i`, as functions of the distance from the start of the span.
    pub fn waves(&self, i: usize) -> &[Wave] {
        self.waves.get(i).map_or(&[], Vec::as_slice)
    }

    /// Whether the law is periodic. The period of a periodic law is its extent.
    pub fn is_closed(&self) -> bool {
        self.closed
    }

    /// First angle and length of the law, rad.
    pub fn extent(&self) -> (f64, f64) {
        let b = self.breaks();
        (b[0], b[b.len() - 1] - b[0])
    }

    /// Angle within the extent of a closed law that is equivalent to `theta`, rad. For an open law, `theta` is unchanged.
    pub fn wrap(&self, theta: f64) -> f64 {
        let (start, length) = self.extent();
        if !self.closed || (theta >= start && theta < start + length) {
            return theta;
        }
        let t = (theta - start).rem_euclid(length);
        // `rem_euclid` may round up to the length itself.
        if t < length { start + t } else { start }
    }

    /// Lift and derivatives at `theta`, rad, exact up to rounding errors. At a break, the values of the span to the right are used.
    pub fn svaj(&self, theta: f64) -> Svaj {
        let (i, u) = self.place(self.wrap(theta));
        self.svaj_on(i, u)
    }

    /// Span that contains an angle, and the position u ∈ [0, 1] on this span. At a break, and within rounding errors before it, the next
    /// span is used. All tables therefore contain the values on the same side of a jump.
    fn place(&self, theta: f64) -> (usize, f64) {
        let (i, u) = self.poly.locate(theta);
        let breaks = self.poly.breaks();
        if i + 2 < breaks.len() && theta > breaks[i + 1] - self.rounding() {
            let (from, to) = (breaks[i + 1], breaks[i + 2]);
            return (i + 1, (theta - from) / (to - from));
        }
        (i, u)
    }

    /// Upper bound of the rounding errors of the angles of the law, rad.
    fn rounding(&self) -> f64 {
        let breaks = self.poly.breaks();
        let ends = breaks[0].abs().max(breaks[breaks.len() - 1].abs());
        16.0 * f64::EPSILON * ends
    }

    /// Lift and derivatives on span `i` at u ∈ [0, 1], for one-sided values at a break.
    pub fn svaj_on(&self, i: usize, u: f64) -> Svaj {
        let n = self.poly.degree();
        let scaled = self.scaled_by_binomials();
        let value = |order: usize| {
            let m = n.saturating_sub(order);
            horner_bernstein(&scaled[order][i * (m + 1)..(i + 1) * (m + 1)], u)
        };
        let mut out = [value(0), value(1), value(2), value(3)];
        let waves = self.waves(i);
        if !waves.is_empty() {
            let b = self.poly.breaks();
            let x = u * (b[i + 1] - b[i]);
            for wave in waves {
                wave.add_to(x, &mut out);
            }
        }
        let [s, v, a, j] = out;
        Svaj { s, v, a, j }
    }

    /// The combination w₀s + w₁v + w₂a + w₃j + constant as a piecewise polynomial. It is exact for polynomial laws. Sinusoids are replaced by Taylor
    /// polynomials on subdivided spans, with remainders below the rounding errors.
    ///
    /// Force, flat-face curvature and all other linear functions of the law have this form, so their extremes are computed from polynomial roots.
    pub fn combination(&self, weights: [f64; 4], constant: f64) -> PiecewisePoly {
        if self.waves.is_empty() {
            return self.polynomial_combination(weights, constant);
        }
        let (poly, waves) = subdivide(&self.poly, &self.waves);
        let mut order = poly;
        let mut sum = PiecewisePoly::combine(&[(weights[0], &order)], constant);
        for &w in &weights[1..] {
            order = order.derivative();
            if w != 0.0 {
                sum = PiecewisePoly::combine(&[(1.0, &sum), (w, &order)], 0.0);
            }
        }
        add_taylor(sum, &waves, weights)
    }

    /// The combination for a law without sinusoids. Derivatives of higher order than necessary are not computed, and terms with weight 0 are omitted.
    fn polynomial_combination(&self, weights: [f64; 4], constant: f64) -> PiecewisePoly {
        let last = weights.iter().rposition(|w| *w != 0.0).unwrap_or(0);
        let mut orders: Vec<PiecewisePoly> = Vec::with_capacity(last + 1);
        for k in 0..=last {
            let next = match (orders.last(), &self.derivatives) {
                (Some(before), None) => before.derivative(),
                _ => self.of_order(k),
            };
            orders.push(next);
        }
        let mut terms: Vec<(f64, &PiecewisePoly)> = weights.into_iter().zip(&orders).collect();
        if weights[last] != 0.0 {
            terms.retain(|t| t.0 != 0.0);
        }
        PiecewisePoly::combine(&terms, constant)
    }

    /// Upper bound of the magnitude of the derivative of the given order (0 = lift … 3 = jerk), from coefficients and amplitudes. It exceeds the true
    /// maximum only by a small factor and is used as a scale.
    pub(crate) fn bound(&self, order: usize) -> f64 {
        let poly = self.of_order(order);
        let amplitude = |w: &Wave| w.rate.powi(order as i32).abs() * libm::hypot(w.cos, w.sin);
        (0..poly.pieces())
            .map(|i| {
                let (low, high) = bernstein::hull(poly.piece(i));
                let waves: f64 = self.waves(i).iter().map(amplitude).sum();
                low.abs().max(high.abs()) + waves
            })
            .fold(0.0, f64::max)
    }

    /// The law with the constant `ds`, m, added to its lift.
    #[must_use]
    pub fn raised(&self, ds: f64) -> Self {
        let poly = PiecewisePoly::combine(&[(1.0, &self.poly)], ds);
        Law {
            derivatives: self.derivatives.clone(),
            cache: self.cache.on_any_level(),
            ..Law::with_waves(poly, self.waves.clone(), self.closed)
        }
    }

    /// The law with its lift multiplied by `factor`.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        let poly = PiecewisePoly::combine(&[(factor, &self.poly)], 0.0);
        let scale = |w: &Wave| Wave {
            rate: w.rate,
            cos: factor * w.cos,
            sin: factor * w.sin,
        };
        let waves = self.waves.iter().map(|p| p.iter().map(scale).collect());
        Law::with_waves(poly, waves.collect(), self.closed)
    }
}

/// Value of Σ cₖ uᵏ(1−u)ⁿ⁻ᵏ, where cₖ includes the binomial coefficient.
fn horner_bernstein(c: &[f64], u: f64) -> f64 {
    let v = 1.0 - u;
    let mut power = 1.0;
    let mut sum = c[0];
    for &ck in &c[1..] {
        power *= u;
        sum = sum * v + power * ck;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{PI, TAU};

    fn polynomial_and_wave() -> Law {
        // s = 1 + 2x − x² + 0.3 sin 3x on [0, 2), then 0.5 cos(x−2) + (x−2)³ on [2, TAU).
        let w = TAU - 2.0;
        let first = bernstein::from_power(&[1.0, 4.0, -4.0, 0.0]);
        let second = bernstein::from_power(&[0.0, 0.0, 0.0, w * w * w]);
        let poly = PiecewisePoly::new(vec![0.0, 2.0, TAU], 3, [first, second].concat());
        let waves = vec![
            vec![Wave {
                rate: 3.0,
                cos: 0.0,
                sin: 0.3,
            }],
            vec![Wave {
                rate: 1.0,
                cos: 0.5,
                sin: 0.0,
            }],
        ];
        Law::with_waves(poly, waves, true)
    }

    #[test]
    fn svaj_is_exact_on_both_kinds_of_piece() {
        let law = polynomial_and_wave();
        let x = 0.7_f64;
        let at = law.svaj(x);
        assert!((at.s - (1.0 + 2.0 * x - x * x + 0.3 * (3.0 * x).sin())).abs() < 1e-14);
        assert!((at.v - (2.0 - 2.0 * x + 0.9 * (3.0 * x).cos())).abs() < 1e-14);
        assert!((at.a - (-2.0 - 2.7 * (3.0 * x).sin())).abs() < 1e-13);
        assert!((at.j - (-8.1 * (3.0 * x).cos())).abs() < 1e-13);
        let y = 1.3_f64;
        let at = law.svaj(2.0 + y - 3.0 * TAU);
        assert!((at.s - (0.5 * y.cos() + y.powi(3))).abs() < 1e-13);
        assert!((at.j - (0.5 * y.sin() + 6.0)).abs() < 1e-12);
    }

    #[test]
    fn combinations_agree_with_svaj_everywhere() {
        let law = polynomial_and_wave();
        let weights = [0.5, -1.5, 2.0, 0.25];
        let p = law.combination(weights, 3.0);
        for i in 0..400 {
            let x = TAU * (f64::from(i) + 0.5) / 400.0;
            let at = law.svaj(x);
            let direct = 0.5 * at.s - 1.5 * at.v + 2.0 * at.a + 0.25 * at.j + 3.0;
            assert!((p.eval(x) - direct).abs() < 1e-12, "{x}");
        }
    }

    #[test]
    fn harmonic_extremes_are_exact() {
        // cos θ + ¼ cos 2θ: derivative −sin θ(1 + cos θ): max 5/4 at 0, min −3/4 at π; a: −cos θ − cos 2θ
        // has extremes −2 at 0 and 9/8 at cos θ = −1/4.
        let law = Law::harmonic(0.0, &[(1.0, 0.0), (0.25, 0.0)]);
        let (low, high) = law.extremes(0);
        assert!((high.value - 1.25).abs() < 1e-14 && (low.value + 0.75).abs() < 1e-14);
        assert!((low.at - PI).abs() < 1e-4);
        let (low, high) = law.extremes(2);
        assert!((low.value + 2.0).abs() < 1e-14 && (high.value - 1.125).abs() < 1e-14);
        let twenty: Vec<(f64, f64)> = (1..=20)
            .map(|n| (0.0, if n == 20 { 1.0 } else { 0.0 }))
            .collect();
        let (low, high) = Law::harmonic(0.0, &twenty).extremes(3);
        assert!((high.value - 8000.0).abs() < 1e-8 && (low.value + 8000.0).abs() < 1e-8);
    }

    #[test]
    fn joints_report_each_jump_once() {
        let joints = polynomial_and_wave().joints();
        assert_eq!(joints.len(), 2);
        let at = joints.iter().find(|j| (j.at - 2.0).abs() < 1e-15).unwrap();
        let before = 1.0 + 4.0 - 4.0 + 0.3 * 6.0_f64.sin();
        assert!((at.jump.s - (0.5 - before)).abs() < 1e-14);
    }
}
