//! Recovery of the lift between breakpoints. Each interval has its own spline of slopes, which avoids oscillations at jumps of acceleration or jerk.

use super::emitted::{Cycle, Emitted, lift_piece};
use super::slopes::slopes_at;
use crate::law::Law;
use crate::poly::PiecewisePoly;

/// Distance from a breakpoint, as a fraction of a step, within which rows are ignored. Division by a shorter distance would amplify the noise of the
/// coordinates.
const TOO_NEAR: f64 = 0.25;
/// Distance from a breakpoint, as a fraction of a step, within which a row is not a break of the law. The derivatives on shorter spans
/// would have large rounding errors.
const NO_PIECE: f64 = 0.02;

/// Lift (m; rad for an arm) and its derivative with respect to the cam coordinate `theta` (rad; m for a translating cam).
#[derive(Debug, Clone, Copy)]
pub struct Station {
    pub theta: f64,
    pub height: f64,
    pub slope: f64,
}

/// Recovers the lift from `rows` (equal steps) and from both sides of every breakpoint in `breaks`, in the order of the angles. If `known`,
/// the slopes of rows and breakpoints are used. Otherwise the slopes are computed from the heights.
pub fn between_breaks(
    rows: &[Station],
    breaks: &[[Station; 2]],
    cycle: Cycle,
    step: f64,
    known: bool,
) -> Emitted {
    let mut stretches = stretches(rows, breaks, cycle, step);
    if !known {
        slopes_from_heights(&mut stretches, cycle);
    }
    let (mut knots, mut coef) = (Vec::new(), Vec::new());
    let (mut lift, mut levels) = (0.0, Vec::new());
    let drift = if cycle.closed {
        drift(&stretches, cycle)
    } else {
        0.0
    };
    for stretch in &stretches {
        let slopes: Vec<f64> = stretch.iter().map(|s| s.slope - drift).collect();
        let accelerations = slopes_of(stretch, |s| s.slope);
        for (i, pair) in stretch.windows(2).enumerate() {
            let width = pair[1].theta - pair[0].theta;
            levels.push(pair[0].height - lift);
            let ends = [i, i + 1].map(|k| [slopes[k], accelerations[k]]);
            let piece = lift_piece(lift, width, ends);
            lift = piece[4];
            coef.extend(piece);
            knots.push(pair[0].theta);
        }
    }
    let level = levels.iter().sum::<f64>() / levels.len() as f64;
    coef.iter_mut().for_each(|c| *c += level);
    let last = stretches.last().and_then(|s| s.last());
    knots.extend(last.map(|s| s.theta));
    let poly = with_rows_as_breaks(PiecewisePoly::new(knots, 4, coef), rows, cycle, step);
    let law = Law::from_poly(poly, cycle.closed);
    let node = |i: usize| law.svaj(rows[0].theta + step * i as f64);
    let nodes: Vec<_> = (0..rows.len()).map(node).collect();
    let mismatch = rows
        .iter()
        .zip(&nodes)
        .fold(0.0_f64, |m, (row, at)| m.max((row.height - at.s).abs()));
    Emitted {
        law,
        nodes,
        mismatch,
    }
}

/// Stations of every interval between two breakpoints, including both breakpoints. For a closed cycle, the angles of the last interval
/// continue beyond the end of the cycle.
fn stretches(
    rows: &[Station],
    breaks: &[[Station; 2]],
    cycle: Cycle,
    step: f64,
) -> Vec<Vec<Station>> {
    let (start, n) = (rows[0].theta, rows.len());
    let mut ends: Vec<(Station, Station)> = Vec::with_capacity(breaks.len() + 1);
    for pair in breaks.windows(2) {
        ends.push((pair[0][1], pair[1][0]));
    }
    let (first, last) = (breaks[0], breaks[breaks.len() - 1]);
    if cycle.closed {
        let next = Station {
            theta: first[0].theta + cycle.length,
            ..first[0]
        };
        ends.push((last[1], next));
    } else {
        ends.insert(0, (rows[0], first[0]));
        ends.push((last[1], rows[n - 1]));
    }
    // Breakpoints that differ only by rounding errors enclose no interval.
    ends.retain(|(from, to)| to.theta - from.theta > 1e-6 * step);
    ends.into_iter()
        .map(|(from, to)| {
            let row = |theta: f64| (theta - start) / step;
            let low = (row(from.theta) + TOO_NEAR).ceil().max(0.0) as usize;
            let high = (row(to.theta) - TOO_NEAR).floor().max(0.0) as usize;
            let inner = (low..=high).map(|i| Station {
                theta: start + step * i as f64,
                ..rows[i % n]
            });
            let mut stations = vec![from];
            stations.extend(inner);
            stations.push(to);
            stations
        })
        .collect()
}

/// Replaces the slopes by slopes of splines through the heights. Where two intervals meet, the slope is the mean of the slopes on both
/// sides.
fn slopes_from_heights(stretches: &mut [Vec<Station>], cycle: Cycle) {
    for stretch in stretches.iter_mut() {
        let slopes = slopes_of(stretch, |s| s.height);
        for (station, slope) in stretch.iter_mut().zip(slopes) {
            station.slope = slope;
        }
    }
    let count = stretches.len();
    let joints = if cycle.closed { count } else { count - 1 };
    for k in 0..joints {
        let next = (k + 1) % count;
        let last = stretches[k].len() - 1;
        let mean = 0.5 * (stretches[k][last].slope + stretches[next][0].slope);
        stretches[k][last].slope = mean;
        stretches[next][0].slope = mean;
    }
}

fn slopes_of(stretch: &[Station], value: fn(&Station) -> f64) -> Vec<f64> {
    let x: Vec<f64> = stretch.iter().map(|s| s.theta).collect();
    let y: Vec<f64> = stretch.iter().map(value).collect();
    slopes_at(&x, &y)
}

/// Mean slope of the recovered lift. The mean slope of a closed lift must be zero, so this value is subtracted from its slopes.
fn drift(stretches: &[Vec<Station>], cycle: Cycle) -> f64 {
    let mut sum = 0.0;
    for stretch in stretches {
        let a = slopes_of(stretch, |s| s.slope);
        for (i, pair) in stretch.windows(2).enumerate() {
            let width = pair[1].theta - pair[0].theta;
            sum +=
                width * (0.5 * (pair[0].slope + pair[1].slope) + width * (a[i] - a[i + 1]) / 12.0);
        }
    }
    sum / cycle.length
}

/// The lift with the rows as additional breaks, except rows that nearly coincide with a breakpoint. A closed lift starts at the angle of
/// the first row.
fn with_rows_as_breaks(
    poly: PiecewisePoly,
    rows: &[Station],
    cycle: Cycle,
    step: f64,
) -> PiecewisePoly {
    let start = rows[0].theta;
    let (from, to) = (poly.breaks()[0], poly.breaks()[poly.pieces()]);
    let mut further = Vec::new();
    let first = ((from - start) / step).ceil().max(0.0) as usize;
    let inner = &poly.breaks()[1..poly.pieces()];
    for i in first.. {
        let at = start + step * i as f64;
        if at >= to {
            break;
        }
        let k = inner.partition_point(|b| *b <= at);
        let near = |b: f64| (at - b).abs() <= NO_PIECE * step;
        // The cycle begins at its first row, even if a breakpoint is near.
        let begins = cycle.closed && i % rows.len() == 0 && (at - from).abs() > 1e-9 * step;
        if begins || !(near(poly.breaks()[k]) || near(poly.breaks()[k + 1])) {
            further.push(at);
        }
    }
    let poly = poly.cut_at(&further);
    if !cycle.closed {
        return poly;
    }
    beginning_at(&poly, start, cycle.length, step)
}

/// The closed lift `poly` with `start` as its first angle. `start` must be a break of `poly`, or lie a whole cycle before a break.
fn beginning_at(poly: &PiecewisePoly, start: f64, length: f64, step: f64) -> PiecewisePoly {
    let n = poly.pieces();
    let end = start + length;
    // The span that begins the cycle: its break equals `start` or the end of the cycle up to rounding errors.
    let turn = (0..n)
        .find(|&i| poly.breaks()[i] > end - 1e-6 * step)
        .unwrap_or(0);
    let mut breaks = Vec::with_capacity(n + 1);
    let mut coef = Vec::with_capacity(5 * n);
    for k in 0..n {
        let i = (turn + k) % n;
        let shift = if turn > 0 && i >= turn { length } else { 0.0 };
        breaks.push(poly.breaks()[i] - shift);
        coef.extend_from_slice(poly.piece(i));
    }
    breaks[0] = start;
    breaks.push(end);
    PiecewisePoly::new(breaks, poly.degree(), coef)
}

#[cfg(test)]
mod tests;
