//! The functions a law is built from, and rows on their coefficients.

use crate::law::Law;
use crate::poly::SplineSpace;

/// One linear functional of the law: Σ value·coefficient.
pub type Entries = Vec<(usize, f64)>;

/// A linear family of laws: every law is Σ xᵢ·(basis function i).
#[derive(Debug, Clone)]
pub enum Basis {
    /// B-splines, closed over one turn or open.
    Spline {
        /// The space.
        space: SplineSpace,
        /// Whether the law repeats.
        closed: bool,
    },
    /// Mean, then cosine and sine of 1 … count over one turn.
    Harmonic {
        /// Number of harmonics.
        count: usize,
    },
}

impl Basis {
    /// Number of coefficients.
    pub fn columns(&self) -> usize {
        match self {
            Basis::Spline { space, .. } => space.dimension(),
            Basis::Harmonic { count } => 2 * count + 1,
        }
    }

    /// Half-bandwidth and border of Gram matrices.
    pub fn pattern(&self) -> (usize, usize) {
        match self {
            Basis::Spline {
                space,
                closed: true,
            } => (space.degree(), space.degree()),
            Basis::Spline {
                space,
                closed: false,
            } => (space.degree(), 0),
            Basis::Harmonic { count } => (0, 2 * count + 1),
        }
    }

    /// The law with the given coefficients.
    pub fn law(&self, x: &[f64]) -> Law {
        match self {
            Basis::Spline { space, closed } => {
                Law::from_poly(space.spline(&x[..space.dimension()]), *closed)
            }
            Basis::Harmonic { count } => {
                let terms: Vec<(f64, f64)> =
                    (0..*count).map(|n| (x[2 * n + 1], x[2 * n + 2])).collect();
                Law::harmonic(x[0], &terms)
            }
        }
    }

    /// Smallest lift of the law with the given coefficients.
    pub fn lowest(&self, x: &[f64]) -> f64 {
        let (low, _) = match self {
            Basis::Spline { space, .. } => space.spline(&x[..space.dimension()]).extremes(),
            Basis::Harmonic { .. } => self.law(x).extremes(0),
        };
        low.value
    }

    /// Breaks of the pieces the basis is smooth on, rad.
    pub fn breaks(&self) -> Vec<f64> {
        match self {
            Basis::Spline { space, .. } => {
                let mut out: Vec<f64> = space.spans().iter().map(|s| s.start).collect();
                out.extend(space.spans().last().map(|s| s.start + s.width));
                out
            }
            Basis::Harmonic { count } => {
                // Two pieces per wave of the highest harmonic: quadrature of degree 7 sees it well.
                let n = (2 * count).max(4);
                (0..=n)
                    .map(|i| std::f64::consts::TAU * i as f64 / n as f64)
                    .collect()
            }
        }
    }

    /// The law with its lift changed by a constant.
    pub fn raised(&self, mut x: Vec<f64>, by: f64) -> Vec<f64> {
        match self {
            Basis::Spline { .. } => x.iter_mut().for_each(|c| *c += by),
            Basis::Harmonic { .. } => x[0] += by,
        }
        x
    }

    /// Row of w₀s + w₁v + w₂a + w₃j (a fourth derivative follows if `weights` has five entries), on
    /// piece `i` of [`Basis::breaks`] at u ∈ [0, 1].
    pub fn row_on(&self, i: usize, u: f64, weights: &[f64]) -> Entries {
        match self {
            Basis::Spline { space, .. } => {
                let values = space.row(i, u, weights);
                merge(
                    values
                        .iter()
                        .enumerate()
                        .map(|(k, &v)| (space.index(i, k), v)),
                    space.degree(),
                )
            }
            Basis::Harmonic { .. } => {
                let b = self.breaks();
                self.row(b[i] + u * (b[i + 1] - b[i]), weights)
            }
        }
    }

    /// The same at a cam angle; at a break the piece to the right answers.
    pub fn row(&self, theta: f64, weights: &[f64]) -> Entries {
        match self {
            Basis::Spline { space, closed } => {
                let spans = space.spans();
                let (start, end) = (
                    spans[0].start,
                    spans.last().map_or(0.0, |s| s.start + s.width),
                );
                let theta = if *closed && !(start..end).contains(&theta) {
                    start + (theta - start).rem_euclid(end - start)
                } else {
                    theta
                };
                let (i, u) = space.locate(theta);
                self.row_on(i, u, weights)
            }
            Basis::Harmonic { count } => {
                let mut out = vec![(0, weights[0])];
                for n in 1..=*count {
                    let r = n as f64;
                    let (sin, cos) = (r * theta).sin_cos();
                    // dᵏ/dθᵏ cos(rθ) = rᵏ cos(rθ + kπ/2).
                    let cosine = [cos, -sin, -cos, sin];
                    let sine = [sin, cos, -sin, -cos];
                    let sum = |table: [f64; 4]| -> f64 {
                        (0..weights.len())
                            .map(|k| weights[k] * r.powi(k as i32) * table[k % 4])
                            .sum()
                    };
                    out.push((2 * n - 1, sum(cosine)));
                    out.push((2 * n, sum(sine)));
                }
                out
            }
        }
    }
}

/// Few spans let one coefficient appear twice on a span of a periodic spline: its weights add.
fn merge(entries: impl Iterator<Item = (usize, f64)>, degree: usize) -> Entries {
    let mut out: Entries = Vec::with_capacity(degree + 1);
    entries.for_each(|entry| add(&mut out, entry));
    out
}

/// Adds one entry to a row.
pub fn add(to: &mut Entries, (index, value): (usize, f64)) {
    match to.iter_mut().find(|e| e.0 == index) {
        Some(e) => e.1 += value,
        None => to.push((index, value)),
    }
}

/// Value of a row on coefficients.
pub fn apply(entries: &Entries, x: &[f64]) -> f64 {
    entries.iter().map(|&(i, v)| v * x[i]).sum()
}
