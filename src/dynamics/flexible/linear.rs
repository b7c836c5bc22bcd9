//! Exact response of a small linear system to a piecewise polynomial input.
//!
//! The system is z′ = A z + b f(θ). On a span of width w, z(w) = e^{Aw} z(0) + ∫₀ʷ e^{A(w−x)} b f(x) dx. The integral is a linear
//! combination of the Bernstein coefficients of f. The vectors of this combination are computed once per width. On a short part of the
//! span, Gauss quadrature integrates the product of polynomial and exponential up to rounding errors. Repeated doubling extends the result
//! to the full width. The method has no cancellation at any frequency and needs no time steps.

use crate::poly::{PiecewisePoly, bernstein, gauss_legendre};
pub use nalgebra::{Matrix2, Vector2};

/// Maximum norm of A times the width for which one Gauss rule is sufficient.
const REACH: f64 = 1.0;
/// Number of terms of the series of the exponential at this norm: 1/24! ≈ 2e-24.
const SERIES: usize = 24;
/// Maximum norm of A times the length of a span. Above this value the response is computed as quasi-static.
pub const STIFFEST: f64 = 1e9;

/// A linear system of two states with one input. If only one state is used, the other state decays and is not coupled to it.
///
/// ```
/// use gaitcam::dynamics::flexible::Linear;
/// use nalgebra::{Matrix2, Vector2};
/// use gaitcam::law::Law;
///
/// // In the steady state of z′ = −z + sin θ, z is (sin θ − cos θ)/2. It is −½ at the start of a turn.
/// let forcing = Law::harmonic(0.0, &[(0.0, 1.0)]).combination([1.0, 0.0, 0.0, 0.0], 0.0);
/// let linear = Linear {
///     rates: -Matrix2::identity(),
///     input: Vector2::new(1.0, 0.0),
/// };
/// let states = linear.periodic(&forcing, |_| Vector2::zeros()).unwrap();
/// assert!((states[0][0] + 0.5).abs() < 1e-6);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Linear {
    /// System matrix A, per radian.
    pub rates: Matrix2<f64>,
    /// Input vector b, per radian.
    pub input: Vector2<f64>,
}

/// Propagation of the state over one span of given width.
struct Step {
    width: f64,
    carry: Matrix2<f64>,
    /// Change of the state per unit of each Bernstein coefficient of the input.
    push: Vec<Vector2<f64>>,
}

impl Linear {
    /// States at the breaks of the input, from the initial state `start`. The number of states is the number of spans plus one. `kick(i)`
    /// is added to the state at the start of span i > 0.
    pub fn through(
        &self,
        forcing: &PiecewisePoly,
        start: Vector2<f64>,
        kick: impl Fn(usize) -> Vector2<f64>,
    ) -> Vec<Vector2<f64>> {
        let steps = self.steps(forcing);
        run(&steps, forcing, start, &kick)
    }

    /// States at the breaks in the periodic steady state; `None` if an undamped natural frequency equals a harmonic. `kick(i)` is added to
    /// the state at the start of every span i.
    pub fn periodic(
        &self,
        forcing: &PiecewisePoly,
        kick: impl Fn(usize) -> Vector2<f64>,
    ) -> Option<Vec<Vector2<f64>>> {
        let steps = self.steps(forcing);
        let once = run(&steps, forcing, kick(0), &kick);
        let mut turn = Matrix2::identity();
        for alike in steps.1.chunk_by(|a, b| a == b) {
            turn = power(steps.0[alike[0]].carry, alike.len()) * turn;
        }
        let closing = Matrix2::identity() - turn;
        // The smallest singular value is the distance of the propagation matrix of a turn from a matrix with the eigenvalue 1.
        let singular = closing.singular_values();
        let margin = NEAR_RESONANCE * singular.max().max(1.0);
        if singular.min() <= margin || singular.min().is_nan() {
            return None;
        }
        let last = once.last().copied().unwrap_or_default();
        // The state at the start of a turn is z₀ + kick(0). `once` is computed with z₀ = 0.
        let start = closing.lu().solve(&last)?;
        Some(run(&steps, forcing, start + kick(0), &kick))
    }

    fn steps(&self, forcing: &PiecewisePoly) -> (Vec<Step>, Vec<usize>) {
        let breaks = forcing.breaks();
        let extent = breaks[breaks.len() - 1] - breaks[0];
        let mut steps: Vec<Step> = Vec::new();
        let mut which = Vec::with_capacity(breaks.len() - 1);
        for pair in breaks.windows(2) {
            let width = pair[1] - pair[0];
            // Widths that differ only by the rounding errors of their ends are treated as equal.
            let same = |s: &Step| (s.width - width).abs() <= 4.0 * f64::EPSILON * extent;
            let recent = which.last().filter(|&&i: &&usize| same(&steps[i])).copied();
            let known = recent.or_else(|| steps.iter().position(same));
            which.push(known.unwrap_or(steps.len()));
            if known.is_none() {
                steps.push(self.step(width, forcing.degree()));
            }
        }
        (steps, which)
    }

    fn step(&self, width: f64, degree: usize) -> Step {
        let scaled = self.rates * width;
        let halvings = libm::log2(scaled.norm().min(STIFFEST) / REACH)
            .ceil()
            .max(0.0) as i32;
        let part = 0.5_f64.powi(halvings);
        let small = scaled * part;
        let mut carry = exponential(&small);
        let mut push = push_once(&small, &self.input, degree, width * part);
        for _ in 0..halvings {
            push = doubled(&carry, &push);
            carry *= carry;
        }
        Step { width, carry, push }
    }
}

/// Ratio of the minimum and maximum singular values of (1 − propagation over a turn) below which the system counts as an undamped
/// resonance.
const NEAR_RESONANCE: f64 = 1e-11;

fn run(
    (steps, which): &(Vec<Step>, Vec<usize>),
    forcing: &PiecewisePoly,
    start: Vector2<f64>,
    kick: &impl Fn(usize) -> Vector2<f64>,
) -> Vec<Vector2<f64>> {
    let mut state = start;
    let mut out = Vec::with_capacity(which.len() + 1);
    for (i, &w) in which.iter().enumerate() {
        if i > 0 {
            state += kick(i);
        }
        out.push(state);
        let step = &steps[w];
        let mut next = step.carry * state;
        for (g, c) in step.push.iter().zip(forcing.piece(i)) {
            next += g * *c;
        }
        state = next;
    }
    out.push(state);
    out
}

/// Response integrals ∫ e^{Z(1−u)} b Bₖ(u) du·width over u from 0 to 1, for all Bernstein polynomials Bₖ of degree `degree`. Z is A
/// multiplied by the width. ‖Z‖ must not exceed about 1.
fn push_once(
    z: &Matrix2<f64>,
    input: &Vector2<f64>,
    degree: usize,
    width: f64,
) -> Vec<Vector2<f64>> {
    let mut sum = vec![Vector2::zeros(); degree + 1];
    for (u, weight) in gauss_legendre((degree + SERIES) / 2 + 1) {
        let answer = exponential_on(z, input, 1.0 - u) * (weight * width);
        for (g, b) in sum.iter_mut().zip(bernstein_basis(degree, u)) {
            *g += answer * b;
        }
    }
    sum
}

/// The response integrals for twice the width. On each half, the Bernstein coefficients of the input are averages (de Casteljau at ½). The
/// response to the first half is propagated through the second half.
fn doubled(carry: &Matrix2<f64>, push: &[Vector2<f64>]) -> Vec<Vector2<f64>> {
    let n = push.len() - 1;
    let mut out = vec![Vector2::zeros(); n + 1];
    for (i, g) in push.iter().enumerate() {
        let carried = carry * g;
        let halves = |k: usize, c: usize| bernstein::binomial(k, c) * 0.5_f64.powi(k as i32);
        for (j, o) in out[..=i].iter_mut().enumerate() {
            *o += carried * halves(i, j);
        }
        for (c, o) in out[i..].iter_mut().enumerate() {
            *o += g * halves(n - i, c);
        }
    }
    out
}

fn bernstein_basis(degree: usize, u: f64) -> Vec<f64> {
    let mut row = vec![1.0];
    for n in 1..=degree {
        let mut next = vec![0.0; n + 1];
        for (k, b) in row.iter().enumerate() {
            next[k] += (1.0 - u) * b;
            next[k + 1] += u * b;
        }
        row = next;
    }
    row
}

/// The vector e^{Z t} b, computed by the power series, for ‖Z‖ ≤ about 1 and t ∈ [0, 1].
fn exponential_on(z: &Matrix2<f64>, b: &Vector2<f64>, t: f64) -> Vector2<f64> {
    let mut term = *b;
    let mut sum = term;
    for k in 1..SERIES {
        term = z * term * (t / k as f64);
        sum += term;
    }
    sum
}

fn exponential(z: &Matrix2<f64>) -> Matrix2<f64> {
    let mut term = Matrix2::identity();
    let mut sum = term;
    for k in 1..SERIES {
        term = z * term / k as f64;
        sum += term;
    }
    sum
}

fn power(base: Matrix2<f64>, mut n: usize) -> Matrix2<f64> {
    let (mut square, mut out) = (base, Matrix2::identity());
    while n > 0 {
        if n & 1 == 1 {
            out *= square;
        }
        square *= square;
        n >>= 1;
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    /// System x″ + w² x = f with the states (x, x′/w).
    fn oscillator(w: f64) -> Linear {
        Linear {
            rates: Matrix2::new(0.0, w, -w, 0.0),
            input: Vector2::new(0.0, 1.0 / w),
        }
    }

    #[test]
    fn gauss_points_integrate_polynomials_exactly() {
        let points = gauss_legendre(9);
        for k in 0..18 {
            let sum: f64 = points.iter().map(|(x, w)| w * x.powi(k)).sum();
            assert!((sum - 1.0 / f64::from(k + 1)).abs() < 1e-15, "{k}");
        }
    }

    #[test]
    fn a_ramp_from_rest_answers_with_the_closed_form_across_eight_decades_of_frequency() {
        // f = x on [0, 3]: x(t) = t/w² − sin(wt)/w³.
        let ramp = PiecewisePoly::new(vec![0.0, 1.3, 3.0], 1, vec![0.0, 1.3, 1.3, 3.0]);
        for w in [1e-4, 1e-2, 1.0, 30.0, 1e3, 1e4] {
            let states = oscillator(w).through(&ramp, Vector2::zeros(), |_| Vector2::zeros());
            for (state, t) in states.iter().zip([0.0, 1.3, 3.0_f64]) {
                let wt: f64 = w * t;
                let bracket = if wt < 0.01 {
                    wt.powi(3) / 6.0 * (1.0 - wt * wt / 20.0)
                } else {
                    wt - wt.sin()
                };
                let exact = bracket / w.powi(3);
                let scale = (t * t * t / 6.0).min(t / (w * w)).max(1e-30);
                assert!((state[0] - exact).abs() < 1e-10 * scale, "{w} {t}");
            }
        }
    }

    #[test]
    fn a_natural_frequency_on_a_harmonic_without_damping_has_no_steady_state() {
        let f = PiecewisePoly::new(vec![0.0, std::f64::consts::TAU], 1, vec![0.0, 1.0]);
        let none = |_| Vector2::zeros();
        assert!(oscillator(3.0).periodic(&f, none).is_none());
        assert!(oscillator(3.001).periodic(&f, none).is_some());
    }

    #[test]
    fn the_periodic_state_returns_to_itself() {
        let f = PiecewisePoly::new(
            vec![0.0, 1.0, std::f64::consts::TAU],
            2,
            vec![0.0, 1.0, 0.5, 0.5, -2.0, 0.0],
        );
        let kick = |i: usize| Vector2::new(0.0, 0.1 * (i as f64 + 1.0));
        let states = oscillator(2.6).periodic(&f, kick).unwrap();
        assert!((states[2] + kick(0) - states[0]).norm() < 1e-13);
    }
}
