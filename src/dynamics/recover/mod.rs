//! Recovery of the smooth lift of the follower from the points of an output profile. Row i of a profile is the contact point at the cam
//! angle θᵢ. The height of the follower follows from the coordinates of the contact point in the fixed frame. The slope v of the lift s
//! follows from the position of the contact point on the follower. For a flat face with the base radius Rb, the contact point is (v, Rb +
//! s). These are the derivative and the value of the support function of the profile. For a roller of radius Rf, the contact normal is
//! (centre − contact)/Rf, and the slope follows from it. A C² cubic spline through the slopes is integrated to the lift (C³). The noise of
//! the points is therefore divided by the angle step only once in the acceleration (theory §10). `stance` computes lift and slope of each
//! kind of follower from a contact point. `breaks` joins intervals at the jumps of acceleration or jerk.

mod breaks;
mod emitted;
mod slopes;
mod stance;

pub(crate) use emitted::Cycle;
pub use emitted::Emitted;

use super::rigid::touch::touch;
use crate::cam::{Cam, Follower, ProfilePoint};
use crate::error::{DynamicsError, Error, Result};
use crate::law::{Law, Svaj};
use crate::poly::PiecewisePoly;
use crate::units::Quantity;
use breaks::{Station, between_breaks};
use emitted::lift_piece;
use slopes::spline_slopes;
use stance::{height_and_slope, slopes_known};

/// Maximum deviation of a profile angle from equal steps, as a fraction of a step. Rounding in a file can cause such a deviation.
const STEP_SLACK: f64 = 1e-3;
/// Minimum mean number of rows between two breakpoints.
const ROWS_BETWEEN_BREAKS: usize = 6;

/// Recovers the lift of `follower` on `points` (equal steps of θ over one turn), smooth over the whole turn.
///
/// # Errors
///
/// Fewer than 8 points; angles that are not equal steps of the turn; coordinates that are not finite or that the follower cannot reach; a concave or
/// undercut part under a flat face.
pub fn recover(follower: &Follower, points: &[ProfilePoint]) -> Result<Emitted> {
    recover_over(follower, points, &[], Cycle::TURN)
}

/// Recovers the lift of a cam from the points of its output profile and the breakpoints of its law.
///
/// The mean distance of the breakpoints must be at least [`ROWS_BETWEEN_BREAKS`] rows. If it is less, as for the knots of a fine spline,
/// the breakpoints at which only the jerk jumps are omitted. If the remaining breakpoints are still too close, all breakpoints are omitted.
///
/// # Errors
///
/// The errors of [`recover_over`].
pub(crate) fn recover_cam(cam: &Cam, points: &[ProfilePoint], cycle: Cycle) -> Result<Emitted> {
    let few = |breaks: &Vec<[ProfilePoint; 2]>| ROWS_BETWEEN_BREAKS * breaks.len() <= points.len();
    let breaks = [3, 2]
        .into_iter()
        .map(|order| cam.breakpoints(order))
        .find(few)
        .unwrap_or_default();
    recover_over(&cam.follower, points, &breaks, cycle)
}

/// Recovers the lift of `follower` on `points` (equal steps of θ over one cycle).
///
/// `breaks` are the contact points on both sides of every jump of the acceleration or jerk ([`Cam::breakpoints`]). Between these points the
/// lift is smooth. A spline across a jump of the acceleration overshoots by 18 % and oscillates over four rows on both sides.
///
/// # Errors
///
/// Fewer than 8 points; angles that are not equal steps of the cycle; coordinates that are not finite or that the follower cannot reach; a concave or
/// undercut part under a flat face.
fn recover_over(
    follower: &Follower,
    points: &[ProfilePoint],
    breaks: &[[ProfilePoint; 2]],
    cycle: Cycle,
) -> Result<Emitted> {
    let step = equal_step(points, cycle)?;
    let station = |row: usize, point: &ProfilePoint| {
        height_and_slope(follower, point)
            .map(|(height, slope)| Station {
                theta: point.theta,
                height,
                slope,
            })
            .ok_or_else(|| out_of_reach(follower, row))
    };
    let rows = points
        .iter()
        .enumerate()
        .map(|(i, p)| station(i, p))
        .collect::<Result<Vec<_>>>()?;
    let start = points[0].theta;
    let emitted = if breaks.is_empty() {
        let heights: Vec<f64> = rows.iter().map(|r| r.height).collect();
        let slopes = if slopes_known(follower) {
            rows.iter().map(|r| r.slope).collect()
        } else {
            spline_slopes(&heights, step, cycle.closed)
        };
        from_heights(start, step, cycle.closed, &heights, &slopes)
    } else {
        let row_before = |at: f64| ((at - start) / step).max(0.0) as usize;
        let breaks = breaks
            .iter()
            .map(|[before, after]| {
                let row = row_before(before.theta);
                Ok([station(row, before)?, station(row, after)?])
            })
            .collect::<Result<Vec<_>>>()?;
        let known = slopes_known(follower);
        between_breaks(&rows, &breaks, cycle, step, known)
    };
    if follower.is_flat() {
        refuse_concave(&emitted, follower, start, step)?;
    }
    Ok(emitted)
}

fn equal_step(points: &[ProfilePoint], cycle: Cycle) -> Result<f64> {
    let n = points.len();
    if n < 8 {
        return Err(DynamicsError::FewRows { rows: n }.into());
    }
    let step = cycle.step(n);
    for (i, p) in points.iter().enumerate() {
        let expected = points[0].theta + step * i as f64;
        if (p.theta - expected).abs() > STEP_SLACK * step || !p.theta.is_finite() {
            return Err(DynamicsError::RowAngle {
                row: i,
                at: Quantity::angle(p.theta),
                expected: Quantity::angle(expected),
            }
            .into());
        }
    }
    Ok(step)
}

fn out_of_reach(follower: &Follower, row: usize) -> Error {
    DynamicsError::RowReach {
        row,
        follower: follower.kind().name(),
    }
    .into()
}

fn refuse_concave(emitted: &Emitted, face: &Follower, start: f64, step: f64) -> Result<()> {
    let radius = |at: &Svaj| 1.0 / touch(face, 1.0, 0.0, *at, 0.0).curvature;
    match emitted.nodes.iter().position(|at| radius(at) <= 0.0) {
        None => Ok(()),
        Some(i) => Err(DynamicsError::Concave {
            at: Quantity::angle(start + step * i as f64),
            radius: Quantity::length(radius(&emitted.nodes[i])),
        }
        .into()),
    }
}

/// Quartic C³ lift with the given slopes at the nodes. Its mean over the nodes equals the mean of the heights.
fn from_heights(start: f64, step: f64, closed: bool, heights: &[f64], slopes: &[f64]) -> Emitted {
    let n = heights.len();
    // The mean slope of a closed lift is zero. A mean slope that noise causes is subtracted.
    let drift = if closed {
        slopes.iter().sum::<f64>() / n as f64
    } else {
        0.0
    };
    let slopes: Vec<f64> = slopes.iter().map(|v| v - drift).collect();
    let accelerations = spline_slopes(&slopes, step, closed);
    let spans = if closed { n } else { n - 1 };
    let mut lift = 0.0;
    let piece = |i: usize| {
        let ends = [i, (i + 1) % n].map(|k| [slopes[k], accelerations[k]]);
        let piece = lift_piece(lift, step, ends);
        lift = piece[4];
        piece
    };
    let pieces: Vec<Vec<f64>> = (0..spans).map(piece).collect();
    let mut rising: Vec<f64> = pieces.iter().map(|piece| piece[0]).collect();
    if !closed {
        rising.extend(pieces.last().map(|piece| piece[4]));
    }
    let level = heights.iter().zip(&rising).map(|(h, r)| h - r).sum::<f64>() / n as f64;
    let mismatch = heights
        .iter()
        .zip(&rising)
        .fold(0.0_f64, |m, (h, r)| m.max((h - r - level).abs()));
    let breaks: Vec<f64> = (0..=spans).map(|i| start + step * i as f64).collect();
    let coef: Vec<f64> = pieces.iter().flatten().map(|b| b + level).collect();
    // Jerk at both ends of the velocity's cubic from node i to node k.
    let jerk = |i: usize, k: usize, near: f64, far: f64| {
        let sign = (near - far).signum();
        6.0 * sign * (slopes[k] - slopes[i]) / (step * step)
            - sign * (near * accelerations[i] + far * accelerations[k]) / step
    };
    let nodes = (0..n)
        .map(|i| Svaj {
            s: rising[i] + level,
            v: slopes[i],
            a: accelerations[i],
            j: if i < spans {
                jerk(i, (i + 1) % n, 4.0, 2.0)
            } else {
                jerk(i - 1, i, 2.0, 4.0)
            },
        })
        .collect();
    Emitted {
        law: Law::from_poly(PiecewisePoly::new(breaks, 4, coef), closed),
        nodes,
        mismatch,
    }
}

#[cfg(test)]
mod tests;
