//! Evaluation at many equal steps: pieces in order without search, sinusoids by rotation, polynomials for a batch
//! of points at once.

use super::{Law, Wave};

/// Points evaluated together. Sinusoids advance by rotation within a batch and are computed afresh for the
/// next one, which keeps the sum of rounding errors below 1e-14 of the amplitude.
pub const BATCH: usize = 32;

/// A law at up to [`BATCH`] consecutive points; entries from `len` on are undefined.
///
/// ```
/// use gaitcam::law::Law;
///
/// let law = Law::harmonic(0.01, &[(0.0, 0.01)]);
/// let mut walk = law.walk(0.0, 0.01, 100);
/// let first = walk.next_batch().unwrap();
/// assert!((first.s[3] - law.svaj(0.03).s).abs() < 1e-15);
/// ```
#[derive(Debug, Clone, Default)]
pub struct Batch {
    /// Number of points.
    pub len: usize,
    /// Whether the follower rests: one lift throughout, velocity and acceleration zero.
    pub at_rest: bool,
    /// Angles, rad.
    pub theta: [f64; BATCH],
    /// Lifts.
    pub s: [f64; BATCH],
    /// Velocities ds/dθ.
    pub v: [f64; BATCH],
    /// Accelerations d²s/dθ².
    pub a: [f64; BATCH],
}

/// cos kα and sin kα for k = 0 … BATCH − 1.
#[derive(Debug, Clone)]
pub(crate) struct Turns {
    pub cos: [f64; BATCH],
    pub sin: [f64; BATCH],
}

impl Turns {
    /// By doubling, so that rounding grows with the logarithm of k only.
    #[inline(always)]
    pub fn of(angle: f64) -> Self {
        let (mut cos, mut sin) = ([1.0; BATCH], [0.0; BATCH]);
        (sin[1], cos[1]) = angle.sin_cos();
        for k in 2..BATCH {
            let (a, b) = (k / 2, k - k / 2);
            cos[k] = cos[a] * cos[b] - sin[a] * sin[b];
            sin[k] = sin[a] * cos[b] + cos[a] * sin[b];
        }
        Turns { cos, sin }
    }
}

/// Iteration over a law at equal steps: see [`Law::walk`].
///
/// ```
/// use gaitcam::law::Law;
///
/// let law = Law::harmonic(0.01, &[(0.0, 0.01)]);
/// let (mut walk, mut points) = (law.walk(0.0, 0.01, 100), 0);
/// while let Some(batch) = walk.next_batch() {
///     points += batch.len;
/// }
/// assert_eq!(points, 100);
/// ```
#[derive(Debug, Clone)]
pub struct Walk<'a> {
    law: &'a Law,
    start: f64,
    step: f64,
    n: usize,
    /// Points done.
    done: usize,
    /// Points left on the piece.
    left: usize,
    piece: usize,
    /// The piece's waves turned by one step after the other.
    turns: Vec<Turns>,
    batch: Batch,
}

impl Law {
    /// The law at θᵢ = start + i·step, 0 ≤ i < n, `step` ≥ 0, batch after batch. Agrees with [`Law::svaj`]
    /// to rounding, at a fraction of its cost (jerk is left out: profiles do not ask for it).
    #[inline(always)]
    pub fn walk(&self, start: f64, step: f64, n: usize) -> Walk<'_> {
        Walk {
            law: self,
            start,
            step,
            n,
            done: 0,
            left: 0,
            piece: 0,
            turns: Vec::new(),
            batch: Batch::default(),
        }
    }

    /// Scaled Bernstein coefficients of lift, velocity and acceleration on a piece.
    #[inline(always)]
    fn coefficients(&self, piece: usize) -> [&[f64]; 3] {
        let scaled = self.scaled_by_binomials();
        [0, 1, 2].map(|order| {
            let m = self.poly.degree().saturating_sub(order);
            &scaled[order][piece * (m + 1)..(piece + 1) * (m + 1)]
        })
    }
}

impl Walk<'_> {
    /// The next points; `None` when all are done.
    #[inline(always)]
    pub fn next_batch(&mut self) -> Option<&Batch> {
        if self.done >= self.n {
            return None;
        }
        let (law, step) = (self.law, self.step);
        let theta = self.start + step * self.done as f64;
        let inside = law.wrap(theta);
        if self.left == 0 {
            self.enter(inside);
        }
        let (from, to) = (law.breaks()[self.piece], law.breaks()[self.piece + 1]);
        let batch = &mut self.batch;
        batch.len = self.left.min(BATCH);
        let mut u = [0.0; BATCH];
        let shift = inside - theta - from;
        let inverse = 1.0 / (to - from);
        for (k, (t, u)) in batch.theta.iter_mut().zip(&mut u).enumerate() {
            *t = self.start + step * (self.done + k) as f64;
            *u = (*t + shift) * inverse;
        }
        let coefficients = law.coefficients(self.piece);
        if batch.at_rest {
            batch.s = [coefficients[0][0]; BATCH];
            batch.v = [0.0; BATCH];
            batch.a = [0.0; BATCH];
        } else {
            polynomials(coefficients, &u, batch);
        }
        for (wave, turns) in law.waves(self.piece).iter().zip(&self.turns) {
            add_wave(wave, u[0] * (to - from), turns, batch);
        }
        self.done += batch.len;
        self.left -= batch.len;
        Some(batch)
    }

    /// Goes to the piece that holds the next point and counts the points on it.
    fn enter(&mut self, inside: f64) {
        let law = self.law;
        (self.piece, _) = law.place(inside);
        let all = self.n - self.done;
        let last = self.piece + 1 == law.poly.pieces() && !law.closed;
        self.left = if last || self.step == 0.0 {
            all
        } else {
            // Points up to the end of the piece, at least this one.
            let to = law.breaks()[self.piece + 1];
            (((to - law.rounding() - inside) / self.step).ceil().max(1.0) as usize).min(all)
        };
        let waves = law.waves(self.piece);
        self.turns.clear();
        self.turns
            .extend(waves.iter().map(|w| Turns::of(w.rate * self.step)));
        self.batch.at_rest =
            waves.is_empty() && law.coefficients(self.piece)[1].iter().all(|c| *c == 0.0);
    }
}

/// Points whose sums stay in registers together.
const SIDE_BY_SIDE: usize = 8;

/// Σ cₖ uᵏ(1−u)ⁿ⁻ᵏ at every u, for three polynomials of falling degree with their powers in common.
#[inline(always)]
fn polynomials(coefficients: [&[f64]; 3], u: &[f64; BATCH], batch: &mut Batch) {
    for first in (0..BATCH).step_by(SIDE_BY_SIDE) {
        let (mut up, mut down) = ([0.0; SIDE_BY_SIDE], [0.0; SIDE_BY_SIDE]);
        let mut power = [1.0; SIDE_BY_SIDE];
        let mut sums = coefficients.map(|c| [c[0]; SIDE_BY_SIDE]);
        for k in 0..SIDE_BY_SIDE {
            up[k] = u[first + k];
            down[k] = 1.0 - up[k];
        }
        for i in 1..coefficients[0].len() {
            for k in 0..SIDE_BY_SIDE {
                power[k] *= up[k];
            }
            for (sum, c) in sums.iter_mut().zip(coefficients) {
                let Some(c) = c.get(i) else { continue };
                for k in 0..SIDE_BY_SIDE {
                    sum[k] = sum[k] * down[k] + power[k] * c;
                }
            }
        }
        let orders = [&mut batch.s, &mut batch.v, &mut batch.a];
        for (values, sum) in orders.into_iter().zip(&sums) {
            values[first..first + SIDE_BY_SIDE].copy_from_slice(sum);
        }
    }
}

/// Adds a sinusoid to a batch that begins `x` after the piece does.
#[inline(always)]
fn add_wave(wave: &Wave, x: f64, turns: &Turns, batch: &mut Batch) {
    let (sin, cos) = (wave.rate * x).sin_cos();
    let first = wave.cos * cos + wave.sin * sin;
    let quarter = wave.sin * cos - wave.cos * sin;
    let square = wave.rate * wave.rate;
    for k in 0..BATCH {
        let value = first * turns.cos[k] + quarter * turns.sin[k];
        batch.s[k] += value;
        batch.v[k] += wave.rate * (quarter * turns.cos[k] - first * turns.sin[k]);
        batch.a[k] -= square * value;
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
            Extent::TURN,
        )
        .unwrap();
        let harmonic = Law::harmonic(0.3, &[(1.0, 0.0), (0.0, 0.5), (0.2, 0.1)]);
        let many: Vec<(f64, f64)> = (1..40)
            .map(|h| 1.0 / f64::from(h).powi(3))
            .map(|size| (size, 0.3 * size))
            .collect();
        let many = Law::harmonic(-0.2, &many);
        for law in [law, harmonic, many] {
            for (start, step, n) in [(0.0, TAU / 1000.0, 1000), (-9.0, 0.37, 80), (1.0, 0.0, 3)] {
                let mut seen = 0;
                let mut walk = law.walk(start, step, n);
                while let Some(batch) = walk.next_batch() {
                    for k in 0..batch.len {
                        let theta = start + step * (seen + k) as f64;
                        assert_eq!(batch.theta[k], theta);
                        let direct = law.svaj(theta);
                        let error = (batch.s[k] - direct.s).abs()
                            + (batch.v[k] - direct.v).abs()
                            + (batch.a[k] - direct.a).abs();
                        // At a break the value of either side is valid; the programme is continuous up to a.
                        assert!(error < 1e-11, "{theta} {direct:?}");
                    }
                    seen += batch.len;
                }
                assert_eq!(seen, n);
            }
        }
    }
}
