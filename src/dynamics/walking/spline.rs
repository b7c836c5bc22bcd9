//! Periodic cubic smoothing spline (Reinsch 1967) for values yₖ at the times tₖ. The curve p minimises Σ (p(tₖ) − yₖ)² + λ ∫ p″². For λ =
//! 0, it passes through the values.
//!
//! R is the cyclic matrix of the integrals of products of two hat functions. Q is the cyclic matrix of second differences. The second
//! derivatives γ at the knots solve (R + λ QᵀQ) γ = Qᵀy, and p = y − λ Q γ. The matrix of this system is cyclic, with two diagonals on
//! either side of the main diagonal.

/// A periodic cubic spline, evaluated at any time.
#[derive(Debug, Clone, PartialEq)]
pub struct Periodic {
    period: f64,
    knots: Vec<f64>,
    values: Vec<f64>,
    bends: Vec<f64>,
}

impl Periodic {
    /// Smoothing spline of values at five or more increasing knots in [0, period). `lambda` is the weight λ of ∫ p″². With 0, the spline
    /// passes through the values.
    pub fn smoothed(knots: &[f64], values: &[f64], period: f64, lambda: f64) -> Periodic {
        let n = knots.len();
        let after = |k: usize| (k + 1) % n;
        let before = |k: usize| (k + n - 1) % n;
        let width: Vec<f64> = (0..n)
            .map(|k| knots.get(k + 1).copied().unwrap_or(period + knots[0]) - knots[k])
            .collect();
        // Second difference at knot k: weights of the values before, at and after it.
        let weights = |k: usize| {
            let (a, b) = (1.0 / width[before(k)], 1.0 / width[k]);
            [a, -a - b, b]
        };
        let near = |k: usize| [before(k), k, after(k)];
        let second: Vec<f64> = (0..n)
            .map(|k| {
                let parts = weights(k).into_iter().zip(near(k));
                parts.map(|(w, i)| w * values[i]).sum()
            })
            .collect();
        let mut matrix = Cyclic::new(n);
        for k in 0..n {
            matrix.add(k, k, (width[before(k)] + width[k]) / 3.0);
            matrix.add(k, after(k), width[k] / 6.0);
            for j in [k, after(k), after(after(k))] {
                let shared = |(w, i): (f64, usize)| {
                    let own = weights(j).into_iter().zip(near(j));
                    w * own.filter(|(_, m)| *m == i).map(|(w, _)| w).sum::<f64>()
                };
                let product: f64 = weights(k).into_iter().zip(near(k)).map(shared).sum();
                matrix.add(k, j, lambda * product);
            }
        }
        let bends = matrix.solve(&second);
        let mut smooth = values.to_vec();
        for (k, bend) in bends.iter().enumerate() {
            for (w, i) in weights(k).into_iter().zip(near(k)) {
                smooth[i] -= lambda * w * bend;
            }
        }
        Periodic {
            period,
            knots: knots.to_vec(),
            values: smooth,
            bends,
        }
    }

    /// Value of the spline and its first two derivatives at the time `t`.
    pub fn at(&self, t: f64) -> [f64; 3] {
        let n = self.knots.len();
        let t = self.knots[0] + (t - self.knots[0]).rem_euclid(self.period);
        let k = self.knots.partition_point(|x| *x <= t).max(1) - 1;
        let end = self.knots.get(k + 1).copied();
        let h = end.unwrap_or(self.period + self.knots[0]) - self.knots[k];
        let (b, next) = ((t - self.knots[k]) / h, (k + 1) % n);
        let a = 1.0 - b;
        let ([y, z], [p, q]) = (
            [self.values[k], self.values[next]],
            [self.bends[k], self.bends[next]],
        );
        [
            a * y + b * z + (a * (a * a - 1.0) * p + b * (b * b - 1.0) * q) * h * h / 6.0,
            (z - y) / h + ((1.0 - 3.0 * a * a) * p + (3.0 * b * b - 1.0) * q) * h / 6.0,
            a * p + b * q,
        ]
    }

    /// Maximum absolute second derivative, which occurs at a knot.
    pub fn most_bend(&self) -> f64 {
        self.bends.iter().fold(0.0, |most, b| most.max(b.abs()))
    }
}

/// A symmetric cyclic matrix with two diagonals on either side of the main diagonal. Each row contains the diagonal entry and the two
/// entries after it, modulo the size.
struct Cyclic {
    rows: Vec<[f64; 3]>,
}

impl Cyclic {
    fn new(n: usize) -> Cyclic {
        Cyclic {
            rows: vec![[0.0; 3]; n],
        }
    }

    /// Adds a value to an entry whose column is at most two after its row.
    fn add(&mut self, row: usize, column: usize, value: f64) {
        let n = self.rows.len();
        self.rows[row][(column + n - row) % n] += value;
    }

    /// Solution x of A x = b, with the last two unknowns as the border of a band.
    fn solve(&self, right: &[f64]) -> Vec<f64> {
        let n = self.rows.len();
        let m = n - 2;
        let entry = |i: usize, j: usize| {
            let forward = (j + n - i) % n;
            let backward = (i + n - j) % n;
            match (forward, backward) {
                (d @ 0..=2, _) => self.rows[i][d],
                (_, d @ 1..=2) => self.rows[j][d],
                _ => 0.0,
            }
        };
        let border = |k: usize| -> Vec<f64> { (0..m).map(|i| entry(i, m + k)).collect() };
        let mut columns = [right[..m].to_vec(), border(0), border(1)];
        self.solve_band(m, &mut columns);
        let [x, c, d] = columns;
        let dot =
            |k: usize, x: &[f64]| -> f64 { border(k).iter().zip(x).map(|(a, b)| a * b).sum() };
        let s = |i: usize, j: usize, x: &[f64]| entry(m + i, m + j) - dot(i, x);
        let (a11, a12, a22) = (s(0, 0, &c), s(0, 1, &d), s(1, 1, &d));
        let (b1, b2) = (right[m] - dot(0, &x), right[m + 1] - dot(1, &x));
        let determinant = a11 * a22 - a12 * a12;
        let last = [
            (b1 * a22 - b2 * a12) / determinant,
            (b2 * a11 - b1 * a12) / determinant,
        ];
        let rest = (0..m).map(|i| x[i] - c[i] * last[0] - d[i] * last[1]);
        rest.chain(last).collect()
    }

    /// Solves the system of the leading band of `m` rows for several right-hand sides, by A = L D Lᵀ.
    fn solve_band(&self, m: usize, columns: &mut [Vec<f64>]) {
        let mut lower = vec![[0.0; 2]; m];
        let mut diagonal = vec![0.0; m];
        for i in 0..m {
            let two = if i > 1 {
                self.rows[i - 2][2] / diagonal[i - 2]
            } else {
                0.0
            };
            let mut one = 0.0;
            if i > 0 {
                let shared = if i > 1 {
                    two * diagonal[i - 2] * lower[i - 1][0]
                } else {
                    0.0
                };
                one = (self.rows[i - 1][1] - shared) / diagonal[i - 1];
            }
            lower[i] = [one, two];
            diagonal[i] = self.rows[i][0];
            if i > 0 {
                diagonal[i] -= one * one * diagonal[i - 1];
            }
            if i > 1 {
                diagonal[i] -= two * two * diagonal[i - 2];
            }
        }
        for x in columns {
            for (i, [one, two]) in lower.iter().enumerate() {
                if i > 0 {
                    x[i] -= one * x[i - 1];
                }
                if i > 1 {
                    x[i] -= two * x[i - 2];
                }
            }
            for i in (0..m).rev() {
                x[i] /= diagonal[i];
                if i + 1 < m {
                    x[i] -= lower[i + 1][0] * x[i + 1];
                }
                if i + 2 < m {
                    x[i] -= lower[i + 2][1] * x[i + 2];
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    fn uneven(n: usize) -> Vec<f64> {
        (0..n)
            .map(|k| (k as f64 + 0.3 * (k as f64).sin()) / n as f64)
            .collect()
    }

    #[test]
    fn without_smoothing_it_passes_through_the_values_and_is_smooth() {
        let knots = uneven(40);
        let values: Vec<f64> = knots.iter().map(|t| (TAU * t).sin()).collect();
        let spline = Periodic::smoothed(&knots, &values, 1.0, 0.0);
        for (t, y) in knots.iter().zip(&values) {
            assert!((spline.at(*t)[0] - y).abs() < 1e-13);
            let sides = [t - 1e-9, t + 1e-9].map(|t| spline.at(t));
            assert!((sides[0][1] - sides[1][1]).abs() < 1e-6);
            assert!((sides[0][2] - sides[1][2]).abs() < 1e-4);
        }
        for t in [0.11, 0.5, 0.987] {
            let exact = [
                (TAU * t).sin(),
                TAU * (TAU * t).cos(),
                -TAU * TAU * (TAU * t).sin(),
            ];
            let own = spline.at(t);
            assert!((own[0] - exact[0]).abs() < 1e-4 && (own[1] - exact[1]).abs() < 1e-2);
            assert!((own[2] - exact[2]).abs() < 1.0, "{} {}", own[2], exact[2]);
        }
    }

    #[test]
    fn a_smoothed_spline_has_the_smallest_sum_of_misses_and_bending() {
        let knots = uneven(17);
        let values: Vec<f64> = (0..17).map(|k| ((k * k) as f64).sin()).collect();
        let lambda = 1e-5;
        let cost = |s: &Periodic| {
            let miss: f64 = knots
                .iter()
                .zip(&values)
                .map(|(t, y)| (s.at(*t)[0] - y).powi(2))
                .sum();
            // The square of a linear function is integrated exactly.
            let bend: f64 = (0..17)
                .map(|k| {
                    let (p, q) = (s.bends[k], s.bends[(k + 1) % 17]);
                    let h = knots.get(k + 1).copied().unwrap_or(1.0 + knots[0]) - knots[k];
                    h * (p * p + p * q + q * q) / 3.0
                })
                .sum();
            miss + lambda * bend
        };
        let best = Periodic::smoothed(&knots, &values, 1.0, lambda);
        for k in 0..17 {
            for change in [-1e-3, 1e-3] {
                let mut other = best.values.clone();
                other[k] += change;
                let other = Periodic::smoothed(&knots, &other, 1.0, 0.0);
                assert!(cost(&other) > cost(&best));
            }
        }
        assert!(Periodic::smoothed(&knots, &values, 1.0, 1e6).most_bend() < 1e-4);
    }
}
