//! Faults in motions, programmes and polynomials of boundary conditions: they give no law.

use serde::Serialize;
use strum::VariantNames;

use crate::units::Quantity;

/// What is wrong with a motion, a programme of segments or a set of conditions.
///
/// ```
/// use gaitcam::error::LawError;
/// use gaitcam::law::{Extent, Rise, Segment, program};
///
/// // A rise over a third of a turn; the rest of the turn is missing.
/// let up = Segment { motion: Rise::Poly345, lift: 0.02, angle: 120f64.to_radians() };
/// let error = program(&[up], Extent::TURN).unwrap_err();
/// let Some(LawError::Uncovered { missing, .. }) = error.fault() else { panic!("{error}") };
/// assert!((missing.value - 240f64.to_radians()).abs() < 1e-12);
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)] // the messages of wording/en/law.ftl say what each field is
pub enum LawError {
    NoSegment,
    Extent {
        length: f64,
    },
    SegmentNotFinite {
        segment: SegmentName,
    },
    SegmentLength {
        segment: SegmentName,
        length: Quantity,
    },
    DwellLift {
        segment: SegmentName,
        lift: Quantity,
    },
    Uncovered {
        covered: Quantity,
        wanted: Quantity,
        missing: Quantity,
    },
    Overfull {
        covered: Quantity,
        wanted: Quantity,
        excess: Quantity,
    },
    GeneralNeighbours {
        first: SegmentName,
        second: SegmentName,
    },
    LiftJump {
        before: SegmentName,
        after: SegmentName,
        at: Quantity,
        jump: Quantity,
    },
    VelocityJump {
        before: SegmentName,
        after: SegmentName,
        at: Quantity,
        jump: Quantity,
        from: Quantity,
        to: Quantity,
        cure: JoinCure,
    },
    BelowBaseCircle {
        segment: SegmentName,
        depth: Quantity,
        at: Quantity,
    },
    BreadthAngle {
        covered: Quantity,
    },
    BreadthPolynomial {
        segment: usize,
    },
    BreadthLift {
        lift: Quantity,
        low: Quantity,
        high: Quantity,
    },
    NoCondition,
    Interval {
        start: f64,
        end: f64,
    },
    ManyConditions {
        conditions: usize,
        degree: usize,
        most: usize,
    },
    ConditionNotFinite {
        condition: usize,
    },
    ConditionOutside {
        condition: usize,
        at: Quantity,
        start: Quantity,
        end: Quantity,
    },
    ConditionOrder {
        condition: usize,
        order: usize,
        degree: usize,
    },
    ConditionTwice {
        first: usize,
        second: usize,
        order: usize,
        at: Quantity,
    },
    NotFixed {
        conditions: usize,
        degree: usize,
    },
    Parameter {
        word: String,
        motion: String,
    },
    Parameters {
        motion: String,
        given: usize,
    },
    UnknownMotion {
        motion: String,
        nearest: Option<String>,
        catalogue: Vec<String>,
    },
    MotionNeedsPoints {
        motion: String,
    },
    MotionFile {
        motion: String,
        file: String,
    },
    GeneralDegree {
        degree: usize,
    },
    SccaShares {
        b: f64,
        c: f64,
        d: f64,
    },
    EccentricRatio {
        ratio: f64,
    },
    TablePairs {
        numbers: usize,
    },
    TableRows {
        table: String,
        rows: usize,
    },
    TableNotFinite {
        table: String,
        row: usize,
    },
    TableOrder {
        table: String,
        row: usize,
        x: f64,
        before: f64,
    },
    TableLevel {
        table: String,
    },
    TableSpacing {
        table: String,
    },
    SplineDegree {
        spline: String,
        degree: usize,
    },
    SplinePoints {
        spline: String,
        points: usize,
        degree: usize,
        least: usize,
    },
    SplineLevel {
        spline: String,
    },
}

/// A segment of a programme in a message.
///
/// ```
/// use gaitcam::error::LawError;
/// use gaitcam::law::{Extent, Rise, Segment, program};
///
/// let pi = std::f64::consts::PI;
/// let segment = |motion, lift| Segment { motion, lift, angle: pi };
/// let error = program(&[segment(Rise::Poly345, 0.02), segment(Rise::Dwell, -0.02)], Extent::TURN).unwrap_err();
/// let Some(LawError::DwellLift { segment, .. }) = error.fault() else { panic!("{error}") };
/// assert_eq!(segment.number(), 2);
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
pub enum SegmentName {
    /// Its number, counted from 1, and its motion.
    Segment {
        /// Counted from 1.
        number: usize,
        /// Name of its motion.
        motion: String,
    },
}

impl SegmentName {
    /// Number of the segment, counted from 1.
    pub fn number(&self) -> usize {
        let SegmentName::Segment { number, .. } = self;
        *number
    }
}

/// Change that makes the velocity continuous between two segments.
///
/// ```
/// use gaitcam::error::{JoinCure, LawError};
/// use gaitcam::law::{Extent, Rise, Segment, program};
///
/// // Constant velocity next to a dwell is a jump of velocity.
/// let pi = std::f64::consts::PI;
/// let segment = |motion, lift, angle| Segment { motion, lift, angle };
/// let list = [
///     segment(Rise::ConstantVelocity, 0.02, 0.5 * pi),
///     segment(Rise::Dwell, 0.0, 0.5 * pi),
///     segment(Rise::Poly345, -0.02, pi),
/// ];
/// let error = program(&list, Extent::TURN).unwrap_err();
/// let Some(LawError::VelocityJump { cure, .. }) = error.fault() else { panic!("{error}") };
/// let JoinCure::PutBetween { segment } = cure else { panic!("{cure:?}") };
/// assert_eq!(segment.number(), 1);
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum JoinCure {
    /// Both move in the same direction: another length of one makes the velocities equal.
    LetCover {
        /// The segment to change.
        segment: SegmentName,
        /// Its new length.
        length: Quantity,
    },
    /// One of the two segments moves at the joint: a segment has to be put between them.
    PutBetween {
        /// The moving segment.
        segment: SegmentName,
    },
}
