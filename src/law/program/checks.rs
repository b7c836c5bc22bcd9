//! Checks of a programme: total length, adjacent segments, jumps at joints, lift below the base circle.

use super::segment::{Draft, Extent, JUMP, ROUNDING, Segment, name};
use crate::error::{JoinCure, JoinError, LawError, Result};
use crate::law::{Joint, Law, Rise};
use crate::units::{Dimension, Quantity};

impl Extent {
    /// A length of the programme with its unit: an angle, or a travel for a translating cam.
    fn quantity(self, x: f64) -> Quantity {
        match self {
            Extent::Length(_) => Quantity::length(x),
            Extent::Turns(_) => Quantity::angle(x),
        }
    }

    /// A velocity with its unit: per angle, or per travel for a translating cam.
    fn velocity(self, v: f64) -> Quantity {
        let dimension = match self {
            Extent::Length(_) => Dimension::Ratio,
            Extent::Turns(_) => Dimension::LengthPerAngle(1),
        };
        Quantity::new(v, dimension)
    }
}

/// Checks that the sum of the lengths equals the extent up to rounding errors, and returns the sum. Also checks the length and lift of each
/// segment.
pub fn lengths(segments: &[Segment], extent: Extent) -> Result<f64> {
    if segments.is_empty() {
        return Err(LawError::NoSegment.into());
    }
    let length = extent.length();
    if !(length.is_finite() && length > 0.0) {
        return Err(LawError::Extent { length }.into());
    }
    for (i, s) in segments.iter().enumerate() {
        let segment = name(segments, i);
        if !s.lift.is_finite() || !s.angle.is_finite() {
            return Err(LawError::SegmentNotFinite { segment }.into());
        }
        if s.angle <= 0.0 {
            let length = extent.quantity(s.angle);
            return Err(LawError::SegmentLength { segment, length }.into());
        }
        if s.motion == Rise::Dwell && s.lift != 0.0 {
            let lift = Quantity::length(s.lift);
            return Err(LawError::DwellLift { segment, lift }.into());
        }
    }
    let total: f64 = segments.iter().map(|s| s.angle).sum();
    let missing = length - total;
    if missing.abs() > ROUNDING * length {
        let (covered, wanted) = (extent.quantity(total), extent.quantity(length));
        let fault = if missing > 0.0 {
            LawError::Uncovered {
                covered,
                wanted,
                missing: extent.quantity(missing),
            }
        } else {
            LawError::Overfull {
                covered,
                wanted,
                excess: extent.quantity(-missing),
            }
        };
        return Err(fault.into());
    }
    Ok(total)
}

/// Rejects adjacent general polynomials, because the motion at their common end is not determined.
pub fn general(segments: &[Segment], extent: Extent) -> Result<()> {
    let n = segments.len();
    for i in 0..n {
        let next = (i + 1) % n;
        if next == 0 && !extent.is_closed() {
            break;
        }
        let general = |k: usize| segments[k].motion.general_degree().is_some();
        if general(i) && general(next) {
            let (first, second) = (name(segments, i), name(segments, next));
            return Err(LawError::GeneralNeighbours { first, second }.into());
        }
    }
    Ok(())
}

/// Rejects jumps of lift or velocity at the ends of segments.
pub fn joints(draft: &Draft, segments: &[Segment], extent: Extent) -> Result<()> {
    let (lift, velocity) = (draft.law.bound(0), draft.law.bound(1));
    for joint in draft.law.joints() {
        let Some(second) = draft.starting(joint.at) else {
            continue;
        };
        let n = segments.len();
        let (first, second) = ((second + n - 2) % n, second - 1);
        let (before, after) = (name(segments, first), name(segments, second));
        let at = extent.quantity(joint.at);
        if joint.jump.s.abs() > JUMP * lift {
            return Err(JoinError::LiftJump {
                before,
                after,
                at,
                jump: Quantity::length(joint.jump.s),
            }
            .into());
        }
        if joint.jump.v.abs() > JUMP * velocity {
            return Err(JoinError::VelocityJump {
                before,
                after,
                at,
                jump: extent.velocity(joint.jump.v),
                from: extent.velocity(joint.sides[0].v),
                to: extent.velocity(joint.sides[1].v),
                cure: cure(segments, &joint, first, second, extent),
            }
            .into());
        }
    }
    Ok(())
}

/// Suggested change of the segments that removes a jump of velocity.
fn cure(
    segments: &[Segment],
    joint: &Joint,
    before: usize,
    after: usize,
    extent: Extent,
) -> JoinCure {
    let [vb, va] = joint.sides.map(|at| at.v);
    if vb * va > 0.0 {
        // The end velocity of a motion is inversely proportional to its length.
        let other = segments[after].angle * va / vb;
        return JoinCure::LetCover {
            segment: name(segments, after),
            length: extent.quantity(other),
        };
    }
    let moving = if va == 0.0 { before } else { after };
    JoinCure::PutBetween {
        segment: name(segments, moving),
    }
}

/// Returns the law of `draft` if its lift is not below the base circle. For a segment given as a table, the lift may be below the base circle by
/// half a unit of the last decimal of the rows. The law is then raised.
///
/// # Errors
///
/// The lift is below the base circle by more than this rounding error.
pub fn on_base_circle(draft: Draft, segments: &[Segment], extent: Extent) -> Result<Law> {
    let (low, high) = draft.law.extremes(0);
    let rounding = JUMP * (high.value - low.value);
    if low.value >= -rounding {
        return Ok(draft.law);
    }
    // Reports the first segment below the base circle. Later segments may be below it only as a consequence.
    let depth = draft.law.combination([-1.0, 0.0, 0.0, 0.0], 0.0);
    let peaks = depth.peaks_above(rounding, f64::NEG_INFINITY, f64::INFINITY);
    let beyond = |at: f64, depth: f64| {
        let i = draft.holding(at) - 1;
        let allowed = segments[i].lift.abs() * segments[i].motion.rounding();
        (depth > allowed).then_some((i, at, depth))
    };
    let first = peaks.iter().find_map(|peak| beyond(peak.at, peak.value));
    let Some((i, at, depth)) = first.or_else(|| beyond(low.at, -low.value)) else {
        return Ok(draft.law.raised(-low.value));
    };
    let start = i.checked_sub(1).map_or(0.0, |before| draft.ends[before]);
    let row = segments[i]
        .motion
        .row_before((at - start) / (draft.ends[i] - start));
    let height: f64 = segments[..i].iter().map(|s| s.lift).sum();
    let is_above = |s: f64| height + segments[i].lift * s >= -rounding;
    let (segment, depth) = (name(segments, i), Quantity::length(depth));
    let at = extent.quantity(at);
    let fault = match row {
        Some((first, lifts)) if lifts.into_iter().all(is_above) => {
            let second = first + 1;
            JoinError::TableBelowBaseCircle {
                segment,
                first,
                second,
                depth,
                at,
            }
        }
        _ => JoinError::BelowBaseCircle { segment, depth, at },
    };
    Err(fault.into())
}
