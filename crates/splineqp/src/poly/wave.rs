//! Sinusoids on the pieces of a function, and their Taylor polynomials.

use super::{PiecewisePoly, bernstein};
use serde::Serialize;
use std::sync::OnceLock;

/// Sinusoid cos·cos(rate·x) + sin·sin(rate·x), where x is measured from the start of the piece.
///
/// ```
/// use splineqp::poly::Wave;
///
/// // Value and three derivatives of sin 2x at 0.
/// let mut values = [0.0; 4];
/// Wave { rate: 2.0, cos: 0.0, sin: 1.0 }.add_to(0.0, &mut values);
/// assert_eq!(values, [0.0, 2.0, 0.0, -8.0]);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Wave {
    /// Phase per unit of x, rad.
    pub rate: f64,
    /// Amplitude of the cosine term.
    pub cos: f64,
    /// Amplitude of the sine term.
    pub sin: f64,
}

/// Maximum phase range, rad, of a sinusoid that one Taylor polynomial approximates. The range extends from −½ to ½ about its middle.
const PHASE_PER_PIECE: f64 = 1.0;
/// Degree of the Taylor polynomials. The remainder 0.5¹⁵/15! ≈ 2e-17 is below the rounding errors.
const TAYLOR_DEGREE: usize = 14;

impl Wave {
    /// Adds the value and the first three derivatives at `x` to `out`.
    #[inline]
    pub fn add_to(&self, x: f64, out: &mut [f64; 4]) {
        let (sin, cos) = libm::sincos(self.rate * x);
        let value = self.cos * cos + self.sin * sin;
        let slope = self.rate * (self.sin * cos - self.cos * sin);
        let square = self.rate * self.rate;
        out[0] += value;
        out[1] += slope;
        out[2] -= square * value;
        out[3] -= square * slope;
    }

    /// The same sinusoid with the origin moved by `later`: g(x) = f(x + later).
    pub fn from(&self, later: f64) -> Wave {
        let (sin, cos) = libm::sincos(self.rate * later);
        Wave {
            rate: self.rate,
            cos: self.cos * cos + self.sin * sin,
            sin: self.sin * cos - self.cos * sin,
        }
    }

    /// The sinusoid reversed on a piece of given width: g(x) = f(width − x).
    pub fn mirrored(&self, width: f64) -> Wave {
        let (sin, cos) = libm::sincos(self.rate * width);
        Wave {
            rate: self.rate,
            cos: self.cos * cos + self.sin * sin,
            sin: self.cos * sin - self.sin * cos,
        }
    }

    /// Amplitudes (cos, sin) of the combination w₀f + w₁f′ + w₂f″ + w₃f‴.
    fn combination(&self, w: [f64; 4]) -> (f64, f64) {
        let r = self.rate;
        let even = w[0] - w[2] * r * r;
        let odd = w[1] * r - w[3] * r * r * r;
        (
            even * self.cos + odd * self.sin,
            even * self.sin - odd * self.cos,
        )
    }
}

/// Divides pieces until one Taylor polynomial is sufficient for every sinusoid on a piece. Each returned sinusoid is stored with the
/// position x at which its new piece starts.
pub fn subdivide(poly: &PiecewisePoly, waves: &[Vec<Wave>]) -> (PiecewisePoly, Vec<Vec<Shifted>>) {
    if waves.is_empty() {
        return (poly.clone(), Vec::new());
    }
    let mut breaks = vec![poly.breaks()[0]];
    let mut coef = Vec::new();
    let mut shifted = Vec::new();
    for (i, list) in waves.iter().enumerate() {
        let (a, b) = (poly.breaks()[i], poly.breaks()[i + 1]);
        let fastest = list.iter().fold(0.0_f64, |m, w| m.max(w.rate.abs()));
        let parts = ((fastest * (b - a) / PHASE_PER_PIECE).ceil() as usize).max(1);
        let mut rest = poly.piece(i).to_vec();
        for p in 0..parts {
            let start = (b - a) * p as f64 / parts as f64;
            let (left, right) = bernstein::split(&rest, 1.0 / (parts - p) as f64);
            coef.extend(left);
            rest = right;
            let end = if p + 1 == parts {
                b
            } else {
                a + (b - a) * (p + 1) as f64 / parts as f64
            };
            breaks.push(end);
            shifted.push(list.iter().map(|&wave| Shifted { wave, start }).collect());
        }
    }
    (PiecewisePoly::new(breaks, poly.degree(), coef), shifted)
}

/// A sinusoid on a part of its piece. The part starts at x = `start`.
pub struct Shifted {
    wave: Wave,
    start: f64,
}

/// Adds the combination Σ wₖ f⁽ᵏ⁾ of the sinusoids f of each piece to `sum`. The pieces of `sum` must come from [`subdivide`].
pub fn add_taylor(sum: PiecewisePoly, waves: &[Vec<Shifted>], weights: [f64; 4]) -> PiecewisePoly {
    if waves.is_empty() {
        return sum;
    }
    let degree = sum.degree().max(TAYLOR_DEGREE);
    let mut coef = Vec::with_capacity(sum.pieces() * (degree + 1));
    let table = symmetric_powers();
    for (i, list) in waves.iter().enumerate() {
        let width = sum.breaks()[i + 1] - sum.breaks()[i];
        let mut taylor = [0.0; TAYLOR_DEGREE + 1];
        for Shifted { wave, start } in list {
            let (c, s) = wave.combination(weights);
            let (sin, cos) = libm::sincos(wave.rate * (start + 0.5 * width));
            let (even, odd) = (c * cos + s * sin, s * cos - c * sin);
            let half = 0.5 * width * wave.rate;
            let mut power = 1.0;
            for (k, t) in taylor.iter_mut().enumerate() {
                let sign = if k % 4 < 2 { 1.0 } else { -1.0 };
                *t += sign * power * if k % 2 == 0 { even } else { odd };
                power *= half / (k + 1) as f64;
            }
        }
        let mut wave = vec![0.0; TAYLOR_DEGREE + 1];
        for (t, row) in taylor.iter().zip(table) {
            for (w, r) in wave.iter_mut().zip(row) {
                *w += t * r;
            }
        }
        let own = bernstein::elevate(sum.piece(i), degree);
        let lifted = bernstein::elevate(&wave, degree);
        coef.extend(own.iter().zip(lifted).map(|(x, y)| x + y));
    }
    PiecewisePoly::new(sum.breaks().to_vec(), degree, coef)
}

/// Bernstein coefficients of (2u − 1)ᵏ at the degree of the Taylor polynomials, k = 0 … degree.
fn symmetric_powers() -> &'static [[f64; TAYLOR_DEGREE + 1]; TAYLOR_DEGREE + 1] {
    static POWERS: OnceLock<[[f64; TAYLOR_DEGREE + 1]; TAYLOR_DEGREE + 1]> = OnceLock::new();
    POWERS.get_or_init(|| {
        let mut power = vec![1.0];
        [0; TAYLOR_DEGREE + 1].map(|_| {
            let mut row = [0.0; TAYLOR_DEGREE + 1];
            row.copy_from_slice(&bernstein::elevate(&power, TAYLOR_DEGREE));
            power = bernstein::product(&power, &[-1.0, 1.0]);
            row
        })
    })
}
