//! Extremes, jumps and scaled coefficients of a law, computed once and cached. Extremes are available for the law and for linear
//! combinations of its derivatives.

use std::f64::consts::TAU;

use super::cache::Extremes;
use super::joint::Joint;
use super::{Law, Svaj};
use crate::poly::{Extreme, PiecewisePoly, bernstein, harmonic_extremes, stand_in};

/// Relative accuracy of the polynomial approximations from which extremes are computed.
const STAND_IN: f64 = 1e-12;

/// Extremes of a function that is multiplied by `factor` and increased by a constant.
fn changed((low, high): Extremes, factor: f64, constant: f64) -> Extremes {
    let there = |e: Extreme| e.map(|x| factor * x + constant);
    if factor < 0.0 {
        (there(high), there(low))
    } else {
        (there(low), there(high))
    }
}

impl Law {
    /// Minimum and maximum of the derivative of the given order (0 = lift … 3 = jerk) of the continuous law, including one-sided values at breaks.
    pub fn extremes(&self, order: usize) -> (Extreme, Extreme) {
        let mut weights = [0.0; 4];
        weights[order] = 1.0;
        self.cached_extremes(weights)
    }

    /// Minimum and maximum of w₀s + w₁v + w₂a + w₃j + constant on the continuous law.
    pub(crate) fn extremes_of(&self, weights: [f64; 4], constant: f64) -> (Extreme, Extreme) {
        let mut counted = (0..4).filter(|k| weights[*k] != 0.0);
        match (counted.next(), counted.next()) {
            (Some(order), None) => changed(self.extremes(order), weights[order], constant),
            _ => changed(self.cached_extremes(weights), 1.0, constant),
        }
    }

    /// Minimum and maximum of a function of lift and derivatives over the law, from a polynomial approximation of the function.
    pub(crate) fn extremes_by(&self, f: impl Fn(Svaj) -> f64) -> Extremes {
        let breaks = self.breaks();
        let inside = |i: usize, x: f64| (x - breaks[i]) / (breaks[i + 1] - breaks[i]);
        stand_in(breaks, STAND_IN, |i, x| f(self.svaj_on(i, inside(i, x)))).extremes()
    }

    /// Extremes of a function where the lift rises, and where it falls, including the ends of rise and fall. `None` for a part that does not occur.
    pub(crate) fn extremes_on_rise_and_fall(
        &self,
        f: impl Fn(Svaj) -> f64,
    ) -> [Option<Extremes>; 2] {
        let breaks = self.breaks();
        let inside = |i: usize, x: f64| (x - breaks[i]) / (breaks[i + 1] - breaks[i]);
        let values = stand_in(breaks, STAND_IN, |i, x| f(self.svaj_on(i, inside(i, x))));
        let velocity = self.combination([0.0, 1.0, 0.0, 0.0], 0.0);
        let values = values.cut_at(&velocity.roots());
        let mut out = [None; 2];
        for (piece, ends) in values.breaks().windows(2).enumerate() {
            let speed = velocity.eval(0.5 * (ends[0] + ends[1]));
            if speed == 0.0 {
                continue;
            }
            let own = values.piece(piece).to_vec();
            let (low, high) = PiecewisePoly::new(ends.to_vec(), values.degree(), own).extremes();
            let side: &mut Option<Extremes> = &mut out[usize::from(speed < 0.0)];
            let (lowest, highest) = side.unwrap_or((low, high));
            *side = Some((
                if low.value < lowest.value {
                    low
                } else {
                    lowest
                },
                if high.value > highest.value {
                    high
                } else {
                    highest
                },
            ));
        }
        out
    }

    fn cached_extremes(&self, weights: [f64; 4]) -> Extremes {
        let search = || match self.harmonics() {
            Some(harmonics) => {
                let sum = weighted(&harmonics, weights);
                let mean = weights[0] * self.poly().coefficients()[0];
                changed(harmonic_extremes(&sum), 1.0, mean)
            }
            None => self.combination(weights, 0.0).extremes(),
        };
        self.cache.extremes(weights, search)
    }

    /// Harmonics 1, 2, … of the law as (cosine, sine); `None` unless the law is a sum of harmonics and a mean.
    pub(crate) fn harmonics(&self) -> Option<Vec<(f64, f64)>> {
        let waves = self.waves(0);
        let is_sum = self.breaks() == [0.0, TAU]
            && self.poly().degree() == 0
            && waves.iter().zip(1..).all(|(w, n)| w.rate == f64::from(n));
        is_sum.then(|| waves.iter().map(|w| (w.cos, w.sin)).collect())
    }

    /// Jumps of s, v, a and j at every break, including the end of the cycle of a closed law.
    pub fn joints(&self) -> Vec<Joint> {
        self.cache.joints(|| joints(self)).to_vec()
    }

    /// Bernstein coefficients of s, v, a and j, span by span, multiplied by their binomial coefficients, for fast evaluation.
    pub(super) fn scaled_by_binomials(&self) -> &[Vec<f64>; 4] {
        let each = |order| times_binomials(&self.of_order(order));
        self.cache.scaled(|| std::array::from_fn(each))
    }

    /// Stroke, m (or rad): maximum lift minus minimum lift.
    pub fn stroke(&self) -> f64 {
        let (low, high) = self.extremes(0);
        high.value - low.value
    }
}

/// Harmonics of w₀s + w₁v + w₂a + w₃j, (cosine, sine), where s is the sum of the given harmonics.
pub(crate) fn weighted(harmonics: &[(f64, f64)], [s, v, a, j]: [f64; 4]) -> Vec<(f64, f64)> {
    let waves = (1..).zip(harmonics);
    let wave = |(n, &(cos, sin)): (u32, &(f64, f64))| {
        let n = f64::from(n);
        let (even, odd) = (s - a * n * n, (v - j * n * n) * n);
        (even * cos + odd * sin, even * sin - odd * cos)
    };
    waves.map(wave).collect()
}

fn times_binomials(p: &PiecewisePoly) -> Vec<f64> {
    let n = p.degree();
    let row: Vec<f64> = (0..=n).map(|k| bernstein::binomial(n, k)).collect();
    let pieces = p.coefficients().chunks_exact(n + 1);
    pieces
        .flat_map(|piece| piece.iter().zip(&row).map(|(b, c)| b * c))
        .collect()
}

/// Joints at all inner breaks. For a closed law, the joint between the end and the start of the cycle is at the first angle.
fn joints(law: &Law) -> Vec<Joint> {
    let n = law.poly().pieces();
    let first = usize::from(!law.is_closed());
    (first..n)
        .map(|i| {
            let before = law.svaj_on((i + n - 1) % n, 1.0);
            let after = law.svaj_on(i, 0.0);
            Joint {
                at: law.breaks()[i],
                sides: [before, after],
                jump: Svaj {
                    s: after.s - before.s,
                    v: after.v - before.v,
                    a: after.a - before.a,
                    j: after.j - before.j,
                },
            }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Law s = cos θ + 0.2 sin 2θ.
    fn law() -> Law {
        Law::harmonic(0.0, &[(1.0, 0.0), (0.0, 0.2)])
    }

    #[test]
    fn extremes_are_those_of_the_curve_whatever_was_asked_before() {
        let asked = [
            ([0.0, 0.0, 1.0, 0.0], 0.0),
            ([0.0, 0.0, -3.0, 0.0], 7.0),
            ([1.0, 0.0, 1.0, 0.0], 2.0),
            ([1.0, 0.0, 1.0, 0.0], -2.0),
            ([0.5, -1.0, 0.0, 0.1], 0.3),
            ([0.0; 4], 1.5),
        ];
        let (one, raised) = (law(), law().raised(0.4));
        for law in [&one, &raised, &one.raised(0.4)] {
            for (weights, constant) in asked {
                let curve = law.combination(weights, constant).extremes();
                let found = law.extremes_of(weights, constant);
                for (a, b) in [(curve.0, found.0), (curve.1, found.1)] {
                    assert!((a.value - b.value).abs() < 1e-13, "{weights:?}");
                    assert!(
                        (law.combination(weights, constant).eval(b.at) - b.value).abs() < 1e-13
                    );
                }
            }
        }
        assert_eq!(one, law());
    }
}
