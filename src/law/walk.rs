//! Evaluation at many equal steps: pieces are walked, not searched, sinusoids turned, not recomputed, and
//! polynomials evaluated for a batch of points at once.

use super::Law;

/// Points evaluated together. Sinusoids advance by rotation within a batch and are computed afresh for the
/// next one, which keeps the sum of rounding errors below 1e-14 of the amplitude.
pub const BATCH: usize = 32;

/// A law at up to [`BATCH`] consecutive points; entries from `len` on mean nothing.
#[derive(Debug, Clone)]
pub struct Batch {
    /// Number of points.
    pub len: usize,
    /// Angles, rad.
    pub theta: [f64; BATCH],
    /// Lifts.
    pub s: [f64; BATCH],
    /// Velocities ds/dθ.
    pub v: [f64; BATCH],
    /// Accelerations d²s/dθ².
    pub a: [f64; BATCH],
}

impl Law {
    /// Hands the law at θᵢ = start + i·step, 0 ≤ i < n, `step` ≥ 0, to `f`, batch after batch. Agrees with
    /// [`Law::svaj`] to rounding, at a fraction of its cost (jerk is left out: profiles do not ask for it).
    pub fn walk(&self, start: f64, step: f64, n: usize, mut f: impl FnMut(&Batch)) {
        let mut batch = Batch {
            len: 0,
            theta: [0.0; BATCH],
            s: [0.0; BATCH],
            v: [0.0; BATCH],
            a: [0.0; BATCH],
        };
        let mut u = [0.0; BATCH];
        let mut i = 0;
        while i < n {
            let theta = start + step * i as f64;
            let inside = self.wrap(theta);
            let (piece, _) = self.poly.locate(inside);
            let (from, to) = (self.breaks()[piece], self.breaks()[piece + 1]);
            let last = piece + 1 == self.poly.pieces() && !self.closed;
            let mut left = if last || step == 0.0 {
                n - i
            } else {
                // Points up to the end of the piece, at least this one.
                (((to - inside) / step).ceil().max(1.0) as usize).min(n - i)
            };
            let shift = inside - theta - from;
            let inverse = 1.0 / (to - from);
            while left > 0 {
                batch.len = left.min(BATCH);
                for (k, (t, u)) in batch.theta.iter_mut().zip(&mut u).enumerate() {
                    *t = start + step * (i + k) as f64;
                    *u = (*t + shift) * inverse;
                }
                self.fill(piece, &u, step, &mut batch);
                f(&batch);
                i += batch.len;
                left -= batch.len;
            }
        }
    }

    /// Evaluates piece `piece` at all `u`.
    fn fill(&self, piece: usize, u: &[f64; BATCH], step: f64, batch: &mut Batch) {
        let degree = self.poly.degree();
        for (order, out) in [&mut batch.s, &mut batch.v, &mut batch.a]
            .into_iter()
            .enumerate()
        {
            let m = degree.saturating_sub(order);
            bernstein_batch(
                &self.scaled[order][piece * (m + 1)..(piece + 1) * (m + 1)],
                u,
                out,
            );
        }
        let (from, to) = (self.breaks()[piece], self.breaks()[piece + 1]);
        let x = u[0] * (to - from);
        for wave in self.waves(piece) {
            let (sin, cos) = (wave.rate * x).sin_cos();
            let (sin_step, cos_step) = (wave.rate * step).sin_cos();
            let mut value = wave.cos * cos + wave.sin * sin;
            let mut quarter = wave.sin * cos - wave.cos * sin;
            let square = wave.rate * wave.rate;
            for k in 0..batch.len {
                batch.s[k] += value;
                batch.v[k] += wave.rate * quarter;
                batch.a[k] -= square * value;
                let turned = value * cos_step + quarter * sin_step;
                quarter = quarter * cos_step - value * sin_step;
                value = turned;
            }
        }
    }
}

/// Σ cₖ uᵏ(1−u)ⁿ⁻ᵏ at every u.
fn bernstein_batch(c: &[f64], u: &[f64; BATCH], out: &mut [f64; BATCH]) {
    out.fill(c[0]);
    let mut power = [1.0; BATCH];
    for &ck in &c[1..] {
        for ((sum, p), u) in out.iter_mut().zip(&mut power).zip(u) {
            *p *= u;
            *sum = *sum * (1.0 - u) + *p * ck;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Extent, Law, Rise, Segment, program};
    use std::f64::consts::TAU;

    #[test]
    fn walking_agrees_with_asking() {
        let segment = |motion: Rise, lift: f64, angle: f64| Segment {
            motion,
            lift,
            angle,
        };
        let law = program(
            &[
                segment(Rise::ModifiedTrapezoid, 1.0, 1.3),
                segment(Rise::Dwell, 0.0, 0.7),
                segment(Rise::Poly56789, 0.5, 1.1),
                segment(Rise::Cycloidal, -1.5, TAU - 3.1),
            ],
            Extent::Turn,
        )
        .unwrap();
        let harmonic = Law::harmonic(0.3, &[(1.0, 0.0), (0.0, 0.5), (0.2, 0.1)]);
        for law in [law, harmonic] {
            for (start, step, n) in [(0.0, TAU / 1000.0, 1000), (-9.0, 0.37, 80), (1.0, 0.0, 3)] {
                let mut seen = 0;
                law.walk(start, step, n, |batch| {
                    for k in 0..batch.len {
                        let theta = start + step * (seen + k) as f64;
                        assert_eq!(batch.theta[k], theta);
                        let direct = law.svaj(theta);
                        let error = (batch.s[k] - direct.s).abs()
                            + (batch.v[k] - direct.v).abs()
                            + (batch.a[k] - direct.a).abs();
                        // At a break either side may answer; the programme is continuous up to a.
                        assert!(error < 1e-11, "{theta} {direct:?}");
                    }
                    seen += batch.len;
                });
                assert_eq!(seen, n);
            }
        }
    }
}
