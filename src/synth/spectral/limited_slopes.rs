//! What the cubic interpolation of a sampled harmonic force adds to it.
//!
//! A target curve is a cubic between samples whose slopes are limited near its crests, so that a sharp heel
//! strike is not overshot. Where they are limited the curve departs from the harmonics on two cells;
//! everywhere else it follows them to a few parts in 10¹⁰. These departures are found from the samples, so
//! the distance of a law from its target needs no piecewise polynomial.

use std::f64::consts::TAU;

use super::Range;
use crate::force::slope_corrections;
use crate::poly::{harmonic_extremes, harmonic_sum, harmonic_values};

/// Samples of a turn.
const SAMPLES: usize = 1024;
/// Points of a coarse grid, 16 or more for the fastest harmonic.
const COARSE: usize = 128;
/// Most harmonics; further ones would also need finer samples.
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

impl LimitedSlopes {
    /// Finds the cells; `None` for more harmonics and other samples.
    pub fn of(spectrum: &[(f64, f64)], samples: usize) -> Option<LimitedSlopes> {
        if spectrum.len() > MOST || samples != SAMPLES {
            return None;
        }
        let size: f64 = spectrum.iter().map(|t| t.0.abs() + t.1.abs()).sum();
        let mut cells: Vec<Cell> = Vec::new();
        let samples = harmonic_values(spectrum, SAMPLES);
        for (first, last) in flat_parts(spectrum) {
            // Two samples more on either side.
            let around = first + SAMPLES - 2..last + SAMPLES + 3;
            let f: Vec<f64> = around.map(|i| samples[i % SAMPLES]).collect();
            for (i, change) in (first..).zip(slope_corrections(&f)) {
                if change.abs() > FREE * size {
                    add(&mut cells, i, change);
                }
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

/// First and last samples of the parts of the turn where a slope may be limited.
///
/// With h between samples, steps on both sides of one differ from h·f′ by ½h²·max|f″| at most, and the centred difference
/// by twice that: while |f′| ≥ 2h·max|f″| neither the sign nor three times the smaller step bounds the slope. Between two points of a coarse grid, H apart, a
/// slope of one sign is nowhere below half the sum of the slopes there less ½H·max|f″|.
fn flat_parts(spectrum: &[(f64, f64)]) -> Vec<(usize, usize)> {
    let waves = (1..).zip(spectrum).map(|(n, &(a, b))| (f64::from(n), a, b));
    let bend: f64 = waves.clone().map(|(n, a, b)| n * n * a.hypot(b)).sum();
    let slope: Vec<(f64, f64)> = waves.map(|(n, a, b)| (n * b, -n * a)).collect();
    let slopes = harmonic_values(&slope, COARSE);
    let steep = bend * TAU * (1.0 / COARSE as f64 + 4.0 / SAMPLES as f64);
    let mut out: Vec<(usize, usize)> = Vec::new();
    for (i, here) in slopes.iter().enumerate() {
        let next = slopes[(i + 1) % COARSE];
        if here * next > 0.0 && here.abs() + next.abs() >= steep {
            continue;
        }
        let of = |i: usize| i * (SAMPLES / COARSE);
        match out.last_mut() {
            Some(last) if last.1 == of(i) => last.1 = of(i + 1),
            _ => out.push((of(i), of(i + 1))),
        }
    }
    // The last sample's successor is the first of all.
    if let Some(last) = out.last_mut() {
        last.1 = last.1.min(SAMPLES - 1);
    }
    out
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Every sample looked at, and only those of flat parts: the same cells.
    #[test]
    fn no_limited_slope_lies_outside_the_flat_parts() {
        let (mut limited, mut looked_at) = (0, 0);
        for case in 0..200_u32 {
            let count = 1 + case % MOST as u32;
            let spectrum: Vec<(f64, f64)> = (1..=count)
                .map(|n| {
                    let fade = f64::from(n).powi((case / 50) as i32);
                    let phase = f64::from(7 * n * n + case);
                    (phase.sin() / fade, (2.3 * phase).cos() / fade)
                })
                .collect();
            let samples = harmonic_values(&spectrum, SAMPLES);
            let all: Vec<f64> = (SAMPLES - 2..2 * SAMPLES + 2)
                .map(|i| samples[i % SAMPLES])
                .collect();
            let size: f64 = spectrum.iter().map(|t| t.0.abs() + t.1.abs()).sum();
            let parts = flat_parts(&spectrum);
            for (i, change) in slope_corrections(&all).into_iter().enumerate() {
                let inside = parts.iter().any(|&(first, last)| first <= i && i <= last);
                looked_at += usize::from(inside);
                if change.abs() > FREE * size {
                    limited += 1;
                    assert!(inside, "{case}: sample {i} of {parts:?}");
                }
            }
        }
        assert!(
            limited > 500 && looked_at < 100 * SAMPLES,
            "{limited} {looked_at}"
        );
    }
}
