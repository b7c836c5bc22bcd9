//! The wanted force in step with the cam, and the band about it.

use std::f64::consts::TAU;

use crate::error::{Placed, Result, SynthError};
use crate::force::ForceCurve;
use crate::poly::gauss_legendre;
use crate::scene::{Band, PhaseWeight};

/// One turn of wanted force, as the fits read it thousands of times.
///
/// ```
/// use gaitcam::force::ForceCurve;
/// use gaitcam::problem::Target;
///
/// let samples = (0..64).map(|i| 500.0 + 100.0 * (std::f64::consts::TAU * f64::from(i) / 64.0).sin());
/// let target = Target::new(ForceCurve::from_samples("a wave", 1.0, samples.collect())?);
/// assert!((target.mean_n() - 500.0).abs() < 1e-9);
/// assert!((target.at(std::f64::consts::FRAC_PI_2) - 600.0).abs() < 1e-9);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Target {
    /// The cycle, beginning at cam angle 0.
    pub curve: ForceCurve,
    /// Its cubics between the samples, N.
    cubics: Vec<[f64; 4]>,
}

/// More cells on a range than this leave a polynomial of the range all but a quartic on each.
const MANY_CELLS: f64 = 24.0;
/// Quadrature nodes on a cell then.
const FEW_NODES: usize = 4;

impl Target {
    /// The cycle with its cubics.
    pub fn new(curve: ForceCurve) -> Self {
        Target {
            cubics: curve.cubics(),
            curve,
        }
    }

    /// Mean force, N.
    pub fn mean_n(&self) -> f64 {
        self.curve.mean_n()
    }

    /// Force at an angle of the first turn, N.
    pub fn at(&self, theta: f64) -> f64 {
        let mut out = [0.0];
        self.on(theta, 0.0, &[(0.0, 0.0)], &mut out);
        out[0]
    }

    /// The same at places u ∈ [0, 1] of a range of the first turn, given with their weights.
    pub fn on(&self, start: f64, width: f64, places: &[(f64, f64)], out: &mut [f64]) {
        let n = self.cubics.len();
        let per_angle = n as f64 / TAU;
        let (first, step) = (start * per_angle, width * per_angle);
        for (f, (place, _)) in out.iter_mut().zip(places) {
            let x = first + place * step;
            let i = (x as u32 as usize).min(n - 1);
            let u = x - i as f64;
            *f = cubic(&self.cubics[i], u);
        }
    }

    /// The polynomial of a degree nearest to the force on a range of the first turn, in the mean, at places
    /// u ∈ [0, 1] of it given with their weights. Integrals against polynomials of that degree are those of the
    /// force itself: its kinks at the samples cost no accuracy.
    pub fn nearest(
        &self,
        (start, width): (f64, f64),
        degree: usize,
        places: &[(f64, f64)],
        out: &mut [f64],
    ) {
        let n = self.cubics.len();
        let per_angle = n as f64 / TAU;
        let (first, step) = (start * per_angle, width * per_angle);
        let last = first + step;
        let nodes = if step > MANY_CELLS {
            FEW_NODES
        } else {
            (degree + 5).div_ceil(2)
        };
        let rule = gauss_legendre(nodes);
        let mut moments = vec![0.0; degree + 1];
        let mut waves = vec![0.0; degree + 1];
        let mut a = first;
        while a < last {
            let i = (a as u32 as usize).min(n - 1);
            // A rounding short of a sample is that sample.
            let b = if i + 1 == n {
                last
            } else {
                (i as f64 + 1.0).min(last)
            };
            for &(t, w) in &rule {
                let x = a + t * (b - a);
                legendre((x - first) / step, &mut waves);
                let part = w * (b - a) / step * cubic(&self.cubics[i], x - i as f64);
                for (moment, wave) in moments.iter_mut().zip(&waves) {
                    *moment += part * wave;
                }
            }
            a = b;
        }
        for (f, (place, _)) in out.iter_mut().zip(places) {
            legendre(*place, &mut waves);
            let terms = moments.iter().zip(&waves).enumerate();
            *f = terms.map(|(k, (m, p))| (2 * k + 1) as f64 * m * p).sum();
        }
    }

    /// Mean over the cycle of the squared distance from a force, N².
    pub fn mean_square_from(&self, force: f64) -> f64 {
        let rule = gauss_legendre(4);
        let of = |cubic_of: &[f64; 4]| -> f64 {
            let at = |(u, w): &(f64, f64)| w * (cubic(cubic_of, *u) - force).powi(2);
            rule.iter().map(at).sum()
        };
        self.cubics.iter().map(of).sum::<f64>() / self.cubics.len() as f64
    }
}

fn cubic([a, b, c, d]: &[f64; 4], u: f64) -> f64 {
    let v = 1.0 - u;
    v * v * (v * a + 3.0 * u * b) + u * u * (3.0 * v * c + u * d)
}

/// Legendre's polynomials of 2u − 1.
fn legendre(u: f64, out: &mut [f64]) {
    let x = 2.0 * u - 1.0;
    let (mut before, mut p) = (0.0, 1.0);
    for (k, out) in out.iter_mut().enumerate() {
        *out = p;
        let k = k as f64;
        (before, p) = (p, ((2.0 * k + 1.0) * x * p - k * before) / (k + 1.0));
    }
}

/// Weight of the force error at a phase of the cycle; where ranges overlap the last one counts.
pub fn weight_at(weights: &[PhaseWeight], phase: f64) -> f64 {
    let at = phase.rem_euclid(TAU);
    let inside = |w: &&PhaseWeight| {
        if w.from < w.to {
            at >= w.from && at < w.to
        } else {
            at >= w.from || at < w.to
        }
    };
    weights.iter().rev().find(inside).map_or(1.0, |w| w.weight)
}

/// Lowest and highest force of a band about the target, as cycles like it.
///
/// # Errors
/// A band of one spread about a target that carries none.
pub fn band_about(target: &ForceCurve, band: Band) -> Result<[ForceCurve; 2]> {
    let half: Vec<f64> = match (band, &target.spread_n) {
        (Band::Width(width), _) => vec![width; target.force_n.len()],
        (Band::Spread, Some(spread)) => spread.clone(),
        (Band::Spread, None) => {
            return Err(SynthError::NoSpread.at_key("gait.band"));
        }
    };
    let edge = |sign: f64| {
        let forces = target.force_n.iter().zip(&half);
        target.with_forces(forces.map(|(f, h)| f + sign * h).collect())
    };
    Ok([edge(-1.0), edge(1.0)])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against a quadrature so fine that kinks do not matter, with few and with many cells on a range.
    #[test]
    fn the_nearest_polynomial_has_the_moments_of_the_force() {
        let force = |i: usize| 700.0 + 300.0 * (0.7 * i as f64).sin() + 50.0 * ((i % 5) as f64);
        for samples in [16, 1000] {
            let curve =
                ForceCurve::from_samples("rough", 0.6, (0..samples).map(force).collect()).unwrap();
            let target = Target::new(curve);
            for (start, width) in [(0.0, 1.1), (2.345, 0.01), (TAU - 0.5, 0.5)] {
                let rule = gauss_legendre(9);
                let mut values = vec![0.0; rule.len()];
                target.nearest((start, width), 7, &rule, &mut values);
                for power in 0..=7 {
                    let own = rule.iter().zip(&values);
                    let own: f64 = own.map(|((u, w), f)| w * f * u.powi(power)).sum();
                    let fine = gauss_legendre(64_000);
                    let at = |u: f64| target.at((start + u * width).min(TAU));
                    let exact: f64 = fine.iter().map(|(u, w)| w * at(*u) * u.powi(power)).sum();
                    assert!(
                        (own / exact - 1.0).abs() < 1e-9,
                        "{samples} {start} {power}: {own} {exact}"
                    );
                }
            }
        }
    }
}
