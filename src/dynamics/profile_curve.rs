//! The emitted profile as a smooth closed curve: the lift that its points give the follower.
//!
//! Row i of a profile is the contact at θᵢ, so its coordinates, turned into the fixed frame, hold two
//! things: how high the follower stands and, by where it touches, the slope of the lift. For a flat face
//! these are the support function of the profile and its derivative, (v, Rb + s); for a roller the
//! contact normal is (centre − contact)/Rf and the slope follows from it. The slopes carry a C² cubic
//! spline, whose integral is the lift (C³): noise in the points enters the acceleration divided by the
//! step of the angle once, not twice, and there is no facet anywhere (theory §10). Where each follower
//! stands over a contact point is [`super::stance`]'s business.

use super::slopes::spline_slopes;
use super::smoothing::fewest_harmonics;
use super::stance::{height_and_slope, slopes_known};
use super::touch::touch;
use crate::cam::{Follower, ProfilePoint};
use crate::error::{Error, Result};
use crate::law::{Law, Svaj};
use crate::poly::{PiecewisePoly, bernstein};
use std::f64::consts::TAU;

/// Angles of a profile may differ from equal steps by this part of a step: rounding in a file.
const STEP_SLACK: f64 = 1e-3;
/// Angles at which the support function of a hand-drawn outline is taken.
const OUTLINE_ANGLES: usize = 1440;

/// The motion that an emitted profile gives its follower.
#[derive(Debug, Clone, PartialEq)]
pub struct Emitted {
    /// Lift over the base (prime) circle; degree 4 between the angles of the points, C³ at them.
    pub law: Law,
    /// Lift and derivatives at the points.
    pub nodes: Vec<Svaj>,
    /// Largest difference between a point's own height and the curve's, m: noise, rounding, or a
    /// profile whose rows are not the contacts they claim to be.
    pub mismatch: f64,
    /// Harmonics kept when the points were smoothed, `None` when they are interpolated.
    pub harmonics: Option<usize>,
}

/// What a profile covers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cycle {
    /// rad (m of travel for a slide).
    pub length: f64,
    /// Whether the last point leads back to the first, which is then not repeated.
    pub closed: bool,
}

impl Cycle {
    /// One turn.
    pub const TURN: Cycle = Cycle {
        length: TAU,
        closed: true,
    };

    /// What a cam's law covers.
    pub fn of(law: &Law) -> Cycle {
        Cycle {
            length: law.extent().1,
            closed: law.is_closed(),
        }
    }

    /// Distance of two neighbouring points of n.
    pub fn step(&self, n: usize) -> f64 {
        self.length / if self.closed { n } else { n - 1 } as f64
    }
}

/// The lift that `points` (equal steps of θ over one turn) give `follower`; see [`recover_over`].
pub fn recover(follower: &Follower, points: &[ProfilePoint], tolerance: f64) -> Result<Emitted> {
    recover_over(follower, points, Cycle::TURN, tolerance)
}

/// The lift that `points` (equal steps of θ over one cycle) give `follower`.
///
/// With `tolerance` > 0 (m; rad for an arm) the heights are first smoothed to the fewest harmonics that
/// stay within it at every point. Fails on fewer than 8 points, on angles that are not equal steps of
/// the cycle, on coordinates that are not finite or out of the follower's reach, on a tolerance that no
/// smoothing meets or on a cycle that is not closed, and on a profile with a concave or undercut stretch
/// under a flat face.
pub fn recover_over(
    follower: &Follower,
    points: &[ProfilePoint],
    cycle: Cycle,
    tolerance: f64,
) -> Result<Emitted> {
    let step = equal_step(points, cycle)?;
    let mut heights = Vec::with_capacity(points.len());
    let mut slopes = Vec::with_capacity(points.len());
    for (i, point) in points.iter().enumerate() {
        let (height, slope) =
            height_and_slope(follower, point).ok_or_else(|| out_of_reach(follower, i))?;
        heights.push(height);
        slopes.push(slope);
    }
    let start = points[0].theta;
    let mut harmonics = None;
    if tolerance > 0.0 {
        if !cycle.closed {
            return Err(
                Error::new("only a profile that closes on itself can be smoothed")
                    .help("leave the smoothing out"),
            );
        }
        let smooth = fewest_harmonics(&heights, tolerance, heights.len() / 4).ok_or_else(|| {
            Error::new(format!(
                "no smoothing of the profile stays within {tolerance:e} m of its points"
            ))
            .help("allow a larger tolerance, or emit the profile with more decimals")
        })?;
        harmonics = Some(smooth.terms.len());
        (heights, slopes) = smooth.sample(points.len());
        slopes.iter_mut().for_each(|v| *v *= TAU / cycle.length);
    } else if !slopes_known(follower) {
        slopes = spline_slopes(&heights, step, cycle.closed);
    }
    let emitted = from_heights(start, step, cycle.closed, &heights, &slopes, harmonics);
    if follower.is_flat() {
        refuse_concave(&emitted, follower, start, step)?;
    }
    Ok(emitted)
}

/// The lift over a base circle that a closed outline drawn by hand gives a flat face.
///
/// A polyline is not a cam: it hops from facet to facet (theory §10). Its support function is smoothed to
/// the fewest harmonics that stay within `tolerance`, m, of it; no more than half as many as there are
/// points. Fails when there is no such curve, or when it is not convex.
pub fn recover_outline(outline: &[[f64; 2]], base_radius: f64, tolerance: f64) -> Result<Emitted> {
    if outline.len() < 8 || outline.iter().flatten().any(|x| !x.is_finite()) {
        return Err(Error::new("an outline needs at least 8 finite points"));
    }
    let n = OUTLINE_ANGLES;
    let heights: Vec<f64> = (0..n)
        .map(|i| {
            let (sin, cos) = (TAU * i as f64 / n as f64).sin_cos();
            let reach = |p: &[f64; 2]| sin * p[0] + cos * p[1];
            outline.iter().map(reach).fold(f64::NEG_INFINITY, f64::max) - base_radius
        })
        .collect();
    let most = (outline.len() / 2).min(n / 4);
    let refused = || {
        Error::new(format!(
            "the outline of {} points is no smooth convex cam within {tolerance:e} m",
            outline.len()
        ))
        .help("allow a larger tolerance, or give the profile as emitted instead of a drawing")
    };
    let smooth = fewest_harmonics(&heights, tolerance, most).ok_or_else(refused)?;
    let kept = smooth.terms.len();
    let (heights, slopes) = smooth.sample(n);
    let step = TAU / n as f64;
    let emitted = from_heights(0.0, step, true, &heights, &slopes, Some(kept));
    let face = Follower::FlatTranslating { base_radius };
    refuse_concave(&emitted, &face, 0.0, step).map_err(|_| refused())?;
    Ok(emitted)
}

fn equal_step(points: &[ProfilePoint], cycle: Cycle) -> Result<f64> {
    let n = points.len();
    if n < 8 {
        return Err(Error::new(format!("a profile of {n} points is no curve"))
            .help("emit at least 8 points, better 360 or more"));
    }
    let step = cycle.step(n);
    for (i, p) in points.iter().enumerate() {
        let expected = points[0].theta + step * i as f64;
        if (p.theta - expected).abs() > STEP_SLACK * step || !p.theta.is_finite() {
            return Err(Error::new(format!(
                "profile row {i} stands at {} rad, not at {expected} rad",
                p.theta
            ))
            .help("a run needs rows at equal steps of the cam's cycle"));
        }
    }
    Ok(step)
}

fn out_of_reach(follower: &Follower, row: usize) -> Error {
    Error::new(format!(
        "profile row {row} cannot touch a {} follower",
        follower.name()
    ))
    .help("its coordinates must be finite and within the follower's reach")
}

fn refuse_concave(emitted: &Emitted, face: &Follower, start: f64, step: f64) -> Result<()> {
    let radius = |at: &Svaj| 1.0 / touch(face, 1.0, 0.0, *at, 0.0).curvature;
    match emitted.nodes.iter().position(|at| radius(at) <= 0.0) {
        None => Ok(()),
        Some(i) => Err(Error::new(format!(
            "the profile is undercut or concave at {:.2}°: radius of curvature {:.4e} m",
            (start + step * i as f64).to_degrees(),
            radius(&emitted.nodes[i])
        ))
        .help("a flat face cannot touch it; enlarge the base radius")),
    }
}

/// The quartic C³ lift through the slopes, raised to the mean of the heights.
fn from_heights(
    start: f64,
    step: f64,
    closed: bool,
    heights: &[f64],
    slopes: &[f64],
    harmonics: Option<usize>,
) -> Emitted {
    let n = heights.len();
    // A closed lift has no mean slope; what noise leaves of it is spread evenly.
    let drift = if closed {
        slopes.iter().sum::<f64>() / n as f64
    } else {
        0.0
    };
    let slopes: Vec<f64> = slopes.iter().map(|v| v - drift).collect();
    let accelerations = spline_slopes(&slopes, step, closed);
    let spans = if closed { n } else { n - 1 };
    let mut rising = Vec::with_capacity(n);
    let mut pieces = Vec::with_capacity(spans);
    let mut lift = 0.0;
    for i in 0..spans {
        let k = (i + 1) % n;
        let velocity = [
            slopes[i],
            slopes[i] + accelerations[i] * step / 3.0,
            slopes[k] - accelerations[k] * step / 3.0,
            slopes[k],
        ];
        rising.push(lift);
        let piece: Vec<f64> = bernstein::antiderivative(&velocity)
            .iter()
            .map(|x| lift + step * x)
            .collect();
        lift = piece[4];
        pieces.push(piece);
    }
    if !closed {
        rising.push(lift);
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
        harmonics,
    }
}

#[cfg(test)]
#[path = "profile_curve_tests.rs"]
mod tests;
