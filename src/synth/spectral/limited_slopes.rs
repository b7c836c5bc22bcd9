//! What the cubic interpolation of a sampled harmonic force adds to it.
//!
//! A target curve is a cubic between samples whose slopes are limited near its crests, so that a sharp heel
//! strike is not overshot. Where they are limited the curve departs from the harmonics on two cells;
//! everywhere else it follows them to a few parts in 10¹⁰. These departures are found from the samples, so
//! the distance of a law from its target needs no piecewise polynomial.

use std::f64::consts::TAU;
use std::sync::OnceLock;

use super::Range;
use crate::force::slope_correction;
use crate::poly::{harmonic_extremes, harmonic_sum};

/// Samples of a turn that are worth tables.
const SAMPLES: usize = 1024;
/// Most harmonics that tables are kept for; further ones would also need finer samples.
const MOST: usize = 6;
/// Slopes nearer than this part of the largest value count as unlimited.
const FREE: f64 = 1e-13;

/// One cell whose slopes are limited, and what that adds: p·u(1−u)² + q·u²(u−1), u from 0 to 1.
#[derive(Debug, Clone, Copy)]
struct Cell {
    index: usize,
    p: f64,
    q: f64,
}

/// Cells of one curve whose slopes are limited.
pub struct LimitedSlopes {
    cells: Vec<Cell>,
}

/// Error of a law of some of the harmonics.
pub struct Error {
    /// Smallest and largest.
    pub range: Range,
    /// Mean.
    pub mean: f64,
    /// Mean square.
    pub square: f64,
}

/// cos nθ and sin nθ at the samples, harmonic by harmonic.
fn tables() -> &'static [(Vec<f64>, Vec<f64>)] {
    static TABLES: OnceLock<Vec<(Vec<f64>, Vec<f64>)>> = OnceLock::new();
    TABLES.get_or_init(|| {
        let wave = |n: usize, f: fn(f64) -> f64| -> Vec<f64> {
            (0..SAMPLES)
                .map(|i| f(TAU * ((n * i) % SAMPLES) as f64 / SAMPLES as f64))
                .collect()
        };
        (1..=MOST)
            .map(|n| (wave(n, f64::cos), wave(n, f64::sin)))
            .collect()
    })
}

impl LimitedSlopes {
    /// Finds the cells; `None` for harmonics or samples without tables.
    pub fn of(spectrum: &[(f64, f64)], samples: usize) -> Option<LimitedSlopes> {
        if spectrum.len() > MOST || samples != SAMPLES {
            return None;
        }
        // Two samples before the first and three after the last, continued periodically.
        let mut f = [0.0; SAMPLES + 5];
        for (&(a, b), (cos, sin)) in spectrum.iter().zip(tables()) {
            for ((v, c), s) in f[2..SAMPLES + 2].iter_mut().zip(cos).zip(sin) {
                *v += a * c + b * s;
            }
        }
        f.copy_within(SAMPLES..SAMPLES + 2, 0);
        f.copy_within(2..5, SAMPLES + 2);
        let size: f64 = spectrum.iter().map(|t| t.0.abs() + t.1.abs()).sum();
        let mut cells: Vec<Cell> = Vec::new();
        for i in 0..SAMPLES {
            let change = slope_correction([f[i], f[i + 1], f[i + 2], f[i + 3], f[i + 4]]);
            if change.abs() > FREE * size {
                add(&mut cells, i, change);
            }
        }
        // The first and the last sample may share a cell.
        if let (Some(first), Some(last)) = (cells.first().copied(), cells.last().copied())
            && first.index == last.index
            && cells.len() > 1
        {
            cells[0].p += last.p;
            cells[0].q += last.q;
            cells.pop();
        }
        Some(LimitedSlopes { cells })
    }

    /// Σ of the first `count` harmonics less the target: −(the rest) − (the departures). `None` when an
    /// extreme of the rest falls on such a cell.
    pub fn error(&self, count: usize, rest: &[(f64, f64)]) -> Option<Error> {
        let mut terms = [(0.0, 0.0); MOST];
        terms[count..count + rest.len()].copy_from_slice(rest);
        let rest = if rest.is_empty() {
            &terms[..0]
        } else {
            &terms[..count + rest.len()]
        };
        let (low, high) = harmonic_extremes(rest);
        let own = |at: f64| ((at / TAU * SAMPLES as f64) as usize).min(SAMPLES - 1);
        if !rest.is_empty()
            && self
                .cells
                .iter()
                .any(|c| c.index == own(low.at) || c.index == own(high.at))
        {
            return None;
        }
        let mut error = Error {
            range: (-high.value, -low.value),
            mean: 0.0,
            square: rest.iter().map(|t| 0.5 * (t.0 * t.0 + t.1 * t.1)).sum(),
        };
        for cell in &self.cells {
            cell.add_to(&mut error, rest);
        }
        Some(error)
    }
}

/// Adds a limited slope at sample `i` to the cells on both sides.
fn add(cells: &mut Vec<Cell>, i: usize, change: f64) {
    let before = (i + SAMPLES - 1) % SAMPLES;
    match cells.last_mut() {
        Some(last) if last.index == before => last.q += change,
        _ => cells.push(Cell {
            index: before,
            p: 0.0,
            q: change,
        }),
    }
    cells.push(Cell {
        index: i,
        p: change,
        q: 0.0,
    });
}

/// Abscissae and weights of Gauss's rule of four points on [0, 1].
const GAUSS: [(f64, f64); 4] = [
    (0.069_431_844_202_973_71, 0.173_927_422_568_726_93),
    (0.330_009_478_207_571_87, 0.326_072_577_431_273_07),
    (0.669_990_521_792_428_1, 0.326_072_577_431_273_07),
    (0.930_568_155_797_026_3, 0.173_927_422_568_726_93),
];

impl Cell {
    fn departure(&self, u: f64) -> f64 {
        let v = 1.0 - u;
        u * v * (self.p * v - self.q * u)
    }

    fn add_to(&self, error: &mut Error, rest: &[(f64, f64)]) {
        let share = 1.0 / SAMPLES as f64;
        let (p, q) = (self.p, self.q);
        error.mean -= share * (p - q) / 12.0;
        error.square += share * ((p * p + q * q) / 105.0 - p * q / 70.0);
        let place = |u: f64| TAU * (self.index as f64 + u) * share;
        if !rest.is_empty() {
            for (u, weight) in GAUSS {
                error.square +=
                    2.0 * share * weight * self.departure(u) * harmonic_sum(rest, place(u))[0];
            }
        }
        // A cubic over so short a cell: its peak from a parabola through the best of a few points.
        let value = |u: f64| {
            -self.departure(u)
                - if rest.is_empty() {
                    0.0
                } else {
                    harmonic_sum(rest, place(u))[0]
                }
        };
        for sign in [1.0, -1.0] {
            let peak = peak(|u| sign * value(u));
            if sign > 0.0 {
                error.range.1 = error.range.1.max(peak);
            } else {
                error.range.0 = error.range.0.min(-peak);
            }
        }
    }
}

/// Largest value of a smooth function on [0, 1]: the best of nine points, then golden parabolas about it.
fn peak(f: impl Fn(f64) -> f64) -> f64 {
    let mut best = (0.0, f64::NEG_INFINITY);
    for i in 0..=8 {
        let u = f64::from(i) / 8.0;
        let v = f(u);
        if v > best.1 {
            best = (u, v);
        }
    }
    let mut h = 0.125;
    for _ in 0..3 {
        let (l, r) = (f((best.0 - h).max(0.0)), f((best.0 + h).min(1.0)));
        let bend = l - 2.0 * best.1 + r;
        if best.0 - h < 0.0 || best.0 + h > 1.0 || bend >= 0.0 {
            break;
        }
        let u = best.0 + 0.5 * h * (l - r) / bend;
        let v = f(u);
        if v > best.1 {
            best = (u, v);
        }
        h *= 0.1;
    }
    best.1
}
