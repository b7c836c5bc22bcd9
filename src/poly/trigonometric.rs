//! Values and extremes of Σ aₙ cos nθ + bₙ sin nθ, n = 1 …

use std::f64::consts::TAU;
use std::sync::OnceLock;

use super::Extreme;

/// Grid points per period of the fastest harmonic, at least.
const POINTS_PER_WAVE: usize = 16;
/// Fewest and most grid points; a sum beyond the finest is searched on it all the same.
const GRIDS: [usize; 8] = [64, 128, 256, 512, 1024, 2048, 4096, 8192];
/// Steps within a cell: Newton's method needs three or four, halving all of them.
const STEPS: usize = 40;
/// A crest is that flat within this angle, rad, that its value is found by one more parabola.
const FLAT: f64 = 1e-5;

/// Value and two derivatives at `x`.
pub fn harmonic_sum(terms: &[(f64, f64)], x: f64) -> [f64; 3] {
    let (sin, cos) = x.sin_cos();
    let (mut c, mut s) = (1.0, 0.0);
    let mut out = [0.0; 3];
    for (n, &(a, b)) in (1..).zip(terms) {
        (c, s) = (c * cos - s * sin, s * cos + c * sin);
        let n = f64::from(n);
        let (even, odd) = (a * c + b * s, b * c - a * s);
        out[0] += even;
        out[1] += n * odd;
        out[2] -= n * n * even;
    }
    out
}

fn circle(grid: usize) -> &'static [(f64, f64)] {
    static CIRCLES: [OnceLock<Vec<(f64, f64)>>; GRIDS.len()] =
        [const { OnceLock::new() }; GRIDS.len()];
    CIRCLES[grid].get_or_init(|| {
        let n = GRIDS[grid];
        (0..n)
            .map(|i| (TAU * i as f64 / n as f64).sin_cos())
            .map(|(s, c)| (c, s))
            .collect()
    })
}

/// Smallest and largest value, to rounding: every grid cell that could hold them is searched by Newton's
/// method. Between grid points the sum exceeds the higher end of its cell by at most h²/8·max|f″|, and
/// max|f″| ≤ Σ n²·√(aₙ² + bₙ²).
pub fn harmonic_extremes(terms: &[(f64, f64)]) -> (Extreme, Extreme) {
    match Grid::of(terms) {
        Some(grid) => (grid.search(terms, -1.0), grid.search(terms, 1.0)),
        None => (NOTHING, NOTHING),
    }
}

/// Extreme of a sum without terms.
const NOTHING: Extreme = Extreme {
    value: 0.0,
    at: 0.0,
};

/// Values on a grid over the turn.
struct Grid {
    values: Vec<f64>,
    step: f64,
    /// The sum exceeds the higher end of a cell by no more.
    reach: f64,
}

impl Grid {
    /// `None` for a sum that is zero.
    fn of(terms: &[(f64, f64)]) -> Option<Grid> {
        let wanted = (POINTS_PER_WAVE * terms.len()).max(1);
        let grid = GRIDS
            .iter()
            .position(|g| *g >= wanted)
            .unwrap_or(GRIDS.len() - 1);
        let circle = circle(grid);
        let mask = circle.len() - 1;
        let mut values = vec![0.0; circle.len()];
        let mut bend = 0.0;
        for (n, &(a, b)) in (1_usize..).zip(terms) {
            let mut k = 0;
            for v in values.iter_mut() {
                let (c, s) = circle[k];
                *v += a * c + b * s;
                k = (k + n) & mask;
            }
            bend += (n * n) as f64 * a.hypot(b);
        }
        if bend == 0.0 {
            return None;
        }
        let step = TAU / values.len() as f64;
        Some(Grid {
            reach: 0.125 * step * step * bend,
            values,
            step,
        })
    }

    /// The largest value of sign·f.
    fn search(&self, terms: &[(f64, f64)], sign: f64) -> Extreme {
        let (values, step, reach) = (&self.values, self.step, self.reach);
        let highest = values
            .iter()
            .fold(f64::NEG_INFINITY, |m, v| m.max(sign * v));
        let mut best = Extreme {
            value: f64::NEG_INFINITY,
            at: 0.0,
        };
        let mut left = sign * values[values.len() - 1];
        for (i, v) in values.iter().enumerate() {
            let right = sign * v;
            let (end, higher) = if left > right {
                (i as f64 - 1.0, left)
            } else {
                (i as f64, right)
            };
            if higher + reach >= highest {
                if higher > best.value {
                    best = Extreme {
                        value: higher,
                        at: end * step,
                    };
                }
                let ends = [(i as f64 - 1.0) * step, i as f64 * step];
                if let Some(top) = crest(terms, ends, end * step, sign)
                    && top.value > best.value
                {
                    best = top;
                }
            }
            left = right;
        }
        Extreme {
            value: sign * best.value,
            at: best.at.rem_euclid(TAU),
        }
    }
}

/// The crest of sign·f in a cell at whose ends it rises and falls: Newton's method on f′ from `start`,
/// halving the cell where that leaves it.
fn crest(
    terms: &[(f64, f64)],
    [mut low, mut high]: [f64; 2],
    start: f64,
    sign: f64,
) -> Option<Extreme> {
    if sign * harmonic_sum(terms, low)[1] < 0.0 || sign * harmonic_sum(terms, high)[1] > 0.0 {
        return None;
    }
    let mut x = start;
    for _ in 0..STEPS {
        let [value, slope, bend] = harmonic_sum(terms, x);
        let newton = -slope / bend;
        if sign * bend < 0.0 && newton.abs() < FLAT {
            // What is left of the way changes the value by less than rounding.
            return Some(Extreme {
                value: sign * (value + 0.5 * newton * slope),
                at: x + newton,
            });
        }
        if sign * slope > 0.0 {
            low = x;
        } else {
            high = x;
        }
        let next = x + newton;
        x = if sign * bend < 0.0 && next > low && next < high {
            next
        } else {
            0.5 * (low + high)
        };
    }
    Some(Extreme {
        value: sign * harmonic_sum(terms, x)[0],
        at: x,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::poly::bernstein::binomial;

    /// (1 + cos θ)ᵏ = Σ C(2k, k − n) cos nθ · 2^(1−k) + its mean: 2ᵏ at 0, 0 at π.
    #[test]
    fn powers_of_one_plus_cosine_have_known_extremes() {
        for k in 1..=12 {
            let scale = 2.0_f64.powi(1 - k as i32);
            let (sin, cos) = 0.3_f64.sin_cos();
            let mut turned = (1.0, 0.0);
            let terms: Vec<(f64, f64)> = (1..=k)
                .map(|n| {
                    turned = (
                        turned.0 * cos - turned.1 * sin,
                        turned.1 * cos + turned.0 * sin,
                    );
                    let a = scale * binomial(2 * k, k - n);
                    (a * turned.0, a * turned.1)
                })
                .collect();
            let mean = 0.5 * scale * binomial(2 * k, k);
            let (low, high) = harmonic_extremes(&terms);
            let most = 2.0_f64.powi(k as i32);
            assert!(
                (high.value + mean - most).abs() < 1e-13 * most,
                "{k}: {high:?}"
            );
            assert!((low.value + mean).abs() < 1e-13 * most, "{k}: {low:?}");
            assert!((high.at - 0.3).abs() < 1e-6, "{k}: {high:?}");
        }
        assert_eq!(harmonic_extremes(&[]).1.value, 0.0);
    }

    #[test]
    fn every_extreme_is_at_least_what_a_fine_grid_sees() {
        for case in 0..60_u32 {
            let count = 1 + case % 12;
            let terms: Vec<(f64, f64)> = (1..=count)
                .map(|n| (f64::from(7 * n + case).sin(), f64::from(3 * n * case).cos()))
                .collect();
            let (low, high) = harmonic_extremes(&terms);
            let size = high.value - low.value;
            for i in 0..5000 {
                let value = harmonic_sum(&terms, TAU * f64::from(i) / 5000.0)[0];
                assert!(value <= high.value + 1e-13 * size && value >= low.value - 1e-13 * size);
            }
            for end in [low, high] {
                let [value, slope, _] = harmonic_sum(&terms, end.at);
                assert!((value - end.value).abs() < 1e-13 * size, "{case}");
                assert!(slope.abs() < 1e-4 * size, "{case}");
            }
        }
    }
}
