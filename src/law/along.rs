//! Evaluation of a law at many ascending angles. The spans are not searched for each angle, and several angles are evaluated together.

use super::{Law, Svaj};

/// Number of angles that are evaluated together, for vector instructions of the processor.
const TOGETHER: usize = 8;

impl Law {
    /// Lift and derivatives at several ascending angles within the extent of the law, rad. The results equal the results of [`Law::svaj`]
    /// bit by bit.
    pub(crate) fn svaj_along(&self, angles: &[f64]) -> Vec<Svaj> {
        let breaks = self.breaks();
        let mut out = Vec::with_capacity(angles.len());
        let mut rest = angles;
        while let Some(first) = rest.first() {
            let (piece, _) = self.place(*first);
            let end = match piece + 2 < breaks.len() {
                true => breaks[piece + 1] - self.rounding(),
                false => f64::INFINITY,
            };
            let count = rest.partition_point(|theta| *theta <= end).max(1);
            let (own, later) = rest.split_at(count);
            self.extend_on(piece, own, &mut out);
            rest = later;
        }
        out
    }

    /// Appends the lift and derivatives at angles within one span to `out`.
    fn extend_on(&self, piece: usize, angles: &[f64], out: &mut Vec<Svaj>) {
        let (from, to) = (self.breaks()[piece], self.breaks()[piece + 1]);
        let scaled = self.scaled_by_binomials();
        let coefficients = [0, 1, 2, 3].map(|order| {
            let count = self.poly.degree().saturating_sub(order) + 1;
            &scaled[order][piece * count..(piece + 1) * count]
        });
        let waves = self.waves(piece);
        for angles in angles.chunks(TOGETHER) {
            let mut u = [0.0; TOGETHER];
            for (u, theta) in u.iter_mut().zip(angles) {
                *u = (theta - from) / (to - from);
            }
            let values = polynomials(coefficients, &u);
            for (k, u) in u.iter().enumerate().take(angles.len()) {
                let mut at = values.map(|values| values[k]);
                for wave in waves {
                    wave.add_to(u * (to - from), &mut at);
                }
                let [s, v, a, j] = at;
                out.push(Svaj { s, v, a, j });
            }
        }
    }
}

/// Values of the polynomials Σ cₖ uᵏ(1−u)ⁿ⁻ᵏ at every u. The four polynomials have decreasing degrees n and share the powers of u.
fn polynomials(coefficients: [&[f64]; 4], u: &[f64; TOGETHER]) -> [[f64; TOGETHER]; 4] {
    let down = u.map(|u| 1.0 - u);
    let mut power = [1.0; TOGETHER];
    let mut sums = coefficients.map(|c| [c[0]; TOGETHER]);
    for i in 1..coefficients[0].len() {
        for k in 0..TOGETHER {
            power[k] *= u[k];
        }
        for (sum, c) in sums.iter_mut().zip(coefficients) {
            let Some(c) = c.get(i) else { break };
            for k in 0..TOGETHER {
                sum[k] = sum[k] * down[k] + power[k] * c;
            }
        }
    }
    sums
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use crate::law::{Extent, Law, Rise, Segment, program};

    #[test]
    fn values_along_a_law_are_those_at_each_angle() {
        let segment = |motion, lift, angle| Segment {
            motion,
            lift,
            angle,
        };
        let segments = [
            segment(Rise::ModifiedTrapezoid, 1.0, 1.3),
            segment(Rise::Dwell, 0.0, 0.7),
            segment(Rise::Poly56789, 0.5, 1.1),
            segment(Rise::Cycloidal, -1.5, TAU - 3.1),
        ];
        let double = program(&segments, Extent::TURN).unwrap();
        let harmonic = Law::harmonic(0.3, &[(1.0, 0.0), (0.0, 0.5), (0.2, 0.1)]);
        for law in [double, harmonic] {
            for n in [1, 7, 720, 1001] {
                let even = (0..n).map(|i| TAU * f64::from(i) / f64::from(n));
                // The breaks themselves are also tested.
                let mut angles: Vec<f64> = even.chain(law.breaks().iter().copied()).collect();
                angles.retain(|theta| *theta < TAU);
                angles.sort_by(f64::total_cmp);
                let each: Vec<_> = angles.iter().map(|theta| law.svaj(*theta)).collect();
                assert_eq!(law.svaj_along(&angles), each);
            }
        }
    }
}
