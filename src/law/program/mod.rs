//! Programmes: laws that are composed of motions, segment by segment.

mod checks;
mod segment;

pub use segment::{Extent, Segment};

use super::{Law, Svaj, pieces::Pieces, rise::joining};
use crate::error::{LawError, Result};
use crate::units::Quantity;
use segment::{Draft, JUMP, ROUNDING};
use std::f64::consts::{PI, TAU};

/// Law of a programme of segments, which starts with lift 0 at θ = 0. Lift and velocity are continuous at the joints. Jumps of acceleration
/// are permitted, although such laws are not suitable for high speed (CAM-DAS). [`Law::joints`] lists these jumps.
///
/// ```
/// use gaitcam::law::{Extent, Rise, Segment, program};
/// use std::f64::consts::{PI, TAU};
///
/// let segment = |motion, lift| Segment { motion, lift, angle: PI };
/// let law = program(&[segment(Rise::Cycloidal, 0.02), segment(Rise::Poly345, -0.02)], Extent::TURN)?;
/// assert!((law.stroke() - 0.02).abs() < 1e-15);
///
/// let short = program(&[segment(Rise::Cycloidal, 0.02)], Extent::TURN);
/// assert_eq!(short.unwrap_err().code(), "law-uncovered");
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
///
/// # Errors
///
/// - The sum of the lengths differs from the extent.
/// - A segment has an invalid length, lift or motion.
/// - The lift or the velocity jumps between two segments, or the lift does not return to its initial value.
/// - The lift is below the base circle.
/// - Two general polynomials are adjacent.
///
/// The error names the segment.
pub fn program(segments: &[Segment], extent: Extent) -> Result<Law> {
    let draft = draft(segments, extent)?;
    checks::joints(&draft, segments, extent)?;
    checks::on_base_circle(draft, segments, extent)
}

/// Composes a law as [`program`] does, but permits jumps of lift and velocity and a lift below the base circle. It is used for reports on invalid
/// laws.
///
/// # Errors
///
/// - The sum of the lengths differs from the extent.
/// - A segment has an invalid length, lift or motion.
/// - Two general polynomials are adjacent.
pub fn assemble(segments: &[Segment], extent: Extent) -> Result<Law> {
    Ok(draft(segments, extent)?.law)
}

/// Law of a constant-breadth cam (flat faces) or constant-diameter cam (rollers). `half` contains the segments of the first half turn, from lift 0 to
/// the maximum lift L.
///
/// The second half turn has the lift L − s(θ − π). Therefore s(θ) + s(θ + π) = L everywhere, and two parallel faces at the distance 2·Rb + L both
/// touch the cam.
///
/// # Errors
///
/// - The segments of the half turn do not have the total length 180°, or contain a general polynomial.
/// - The lift of the half turn does not rise from 0 to its maximum at the end.
/// - The errors of [`program`].
pub fn constant_breadth(half: &[Segment]) -> Result<Law> {
    let total: f64 = half.iter().map(|s| s.angle).sum();
    if (total - PI).abs() > ROUNDING * PI {
        let covered = Quantity::angle(total);
        return Err(LawError::BreadthAngle { covered }.into());
    }
    if let Some(i) = half
        .iter()
        .position(|s| s.motion.general_degree().is_some())
    {
        return Err(LawError::BreadthPolynomial { segment: i + 1 }.into());
    }
    let first = assemble(half, Extent::Length(total))?;
    let lift: f64 = half.iter().map(|s| s.lift).sum();
    let (low, high) = first.extremes(0);
    let rounding = |s: &Segment| s.lift.abs() * s.motion.rounding();
    let slack = half.iter().map(rounding).fold(JUMP * lift.abs(), f64::max);
    if lift <= 0.0 || low.value < -slack || high.value > lift + slack {
        return Err(LawError::BreadthLift {
            lift: Quantity::length(lift),
            low: Quantity::length(low.value),
            high: Quantity::length(high.value),
        }
        .into());
    }
    let mut pieces = Pieces::starting_at(0.0);
    pieces.push_shape(&first, PI, 0.0, 1.0, false);
    pieces.push_shape(&first, PI, lift, -1.0, false);
    pieces.end_exactly_at(TAU);
    let law = pieces.finish(true);
    let mirrored = half.iter().map(|s| Segment {
        lift: -s.lift,
        ..s.clone()
    });
    let segments: Vec<Segment> = half.iter().cloned().chain(mirrored).collect();
    let ends = ends_of(&segments, TAU / (2.0 * total));
    let draft = Draft { law, ends };
    checks::joints(&draft, &segments, Extent::TURN)?;
    checks::on_base_circle(draft, &segments, Extent::TURN)
}

fn ends_of(segments: &[Segment], stretch: f64) -> Vec<f64> {
    segments
        .iter()
        .scan(0.0, |sum, s| {
            *sum += s.angle * stretch;
            Some(*sum)
        })
        .collect()
}

fn draft(segments: &[Segment], extent: Extent) -> Result<Draft> {
    let total = checks::lengths(segments, extent)?;
    checks::general(segments, extent)?;
    let stretch = extent.length() / total;
    let shapes: Vec<Option<Law>> = segments
        .iter()
        .map(|s| match s.motion.general_degree() {
            Some(_) => Ok(None),
            None => s.motion.law().map(Some),
        })
        .collect::<Result<_>>()?;
    let mut pieces = Pieces::starting_at(0.0);
    let mut height = 0.0;
    let n = segments.len();
    for (i, s) in segments.iter().enumerate() {
        let width = s.angle * stretch;
        match (&shapes[i], s.motion.general_degree()) {
            (Some(shape), _) => {
                let mirrored = s.lift < 0.0 && s.motion.mirrors();
                pieces.push_shape(shape, width, height, s.lift, mirrored);
            }
            (None, degree) => {
                let neighbour = |k: Option<usize>, at_end: bool| {
                    let (segment, shape) = (&segments[k?], shapes[k?].as_ref()?);
                    Some(end_of(segment, shape, segment.angle * stretch, at_end))
                };
                let (before, after) = if extent.is_closed() {
                    (Some((i + n - 1) % n), Some((i + 1) % n))
                } else {
                    (i.checked_sub(1), (i + 1 < n).then_some(i + 1))
                };
                let mut start = neighbour(before, true).unwrap_or_default();
                let mut end = neighbour(after, false).unwrap_or_default();
                start.s = height;
                end.s = height + s.lift;
                let poly = joining(degree.unwrap_or(5), start, end, width)?;
                let shape = Law::from_poly(poly, false);
                pieces.push_shape(&shape, width, 0.0, 1.0, false);
            }
        }
        height += s.lift;
    }
    pieces.end_exactly_at(extent.length());
    Ok(Draft {
        law: pieces.finish(extent.is_closed()),
        ends: ends_of(segments, stretch),
    })
}

/// Lift and derivatives of a segment at its end or its start, with respect to the cam angle.
fn end_of(segment: &Segment, shape: &Law, width: f64, at_end: bool) -> Svaj {
    let mut pieces = Pieces::starting_at(0.0);
    let mirrored = segment.lift < 0.0 && segment.motion.mirrors();
    pieces.push_shape(shape, width, 0.0, segment.lift, mirrored);
    let law = pieces.finish(false);
    if at_end {
        law.svaj_on(law.poly().pieces() - 1, 1.0)
    } else {
        law.svaj_on(0, 0.0)
    }
}
