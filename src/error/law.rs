//! Errors in motions, programmes and polynomials of boundary conditions.

use serde::Serialize;
use strum::VariantNames;

use crate::units::Quantity;

/// Errors in a motion, a programme of segments or a set of conditions.
///
/// ```
/// use gaitcam::error::LawError;
/// use gaitcam::law::{Extent, Rise, Segment, program};
///
/// // A rise covers a third of the turn. The other segments are missing.
/// let up = Segment { motion: Rise::Poly345, lift: 0.02, angle: 120f64.to_radians() };
/// let error = program(&[up], Extent::TURN).unwrap_err();
/// let Some(LawError::Uncovered { missing, .. }) = error.fault() else { panic!("{error}") };
/// assert!((missing.value - 240f64.to_radians()).abs() < 1e-12);
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named in the messages
pub enum LawError {
    /// A programme has no segments.
    NoSegment,
    /// The length of a programme is not positive.
    Extent { length: f64 },
    /// The lift or the length of a segment is not finite.
    SegmentNotFinite { segment: SegmentName },
    /// The length of a segment is not positive.
    SegmentLength {
        segment: SegmentName,
        length: Quantity,
    },
    /// A dwell has a lift.
    DwellLift {
        segment: SegmentName,
        lift: Quantity,
    },
    /// The segments do not cover the whole length.
    Uncovered {
        covered: Quantity,
        wanted: Quantity,
        missing: Quantity,
    },
    /// The segments exceed the whole length.
    Overfull {
        covered: Quantity,
        wanted: Quantity,
        excess: Quantity,
    },
    /// The common end of two adjacent general polynomials has no conditions.
    GeneralNeighbours {
        first: SegmentName,
        second: SegmentName,
    },
    /// The segments of a constant-breadth cam do not cover half a turn.
    BreadthAngle { covered: Quantity },
    /// The half turn of a constant-breadth cam contains a general polynomial.
    BreadthPolynomial { segment: usize },
    /// The segments of a constant-breadth cam do not lead from 0 to the maximum lift.
    BreadthLift {
        lift: Quantity,
        low: Quantity,
        high: Quantity,
    },
    /// A polynomial has no conditions.
    NoCondition,
    /// The interval of a polynomial is invalid.
    Interval { start: f64, end: f64 },
    /// A polynomial has too many conditions.
    ManyConditions {
        conditions: usize,
        degree: usize,
        most: usize,
    },
    /// A condition is not finite.
    ConditionNotFinite { condition: usize },
    /// A condition lies outside the interval.
    ConditionOutside {
        condition: usize,
        at: Quantity,
        start: Quantity,
        end: Quantity,
    },
    /// A condition prescribes a derivative of a higher order than the degree.
    ConditionOrder {
        condition: usize,
        order: usize,
        degree: usize,
    },
    /// Two conditions prescribe the same derivative at the same angle.
    ConditionTwice {
        first: usize,
        second: usize,
        order: usize,
        at: Quantity,
    },
    /// The conditions do not determine a polynomial.
    NotFixed { conditions: usize, degree: usize },
    /// A parameter of a motion is not a number.
    Parameter { word: String, motion: String },
    /// The number of parameters of a motion is wrong.
    Parameters { motion: String, given: usize },
    /// The name of the motion is unknown.
    UnknownMotion {
        motion: String,
        nearest: Option<String>,
        catalogue: Vec<String>,
    },
    /// The motion is a type of VDI 2143 for which the catalogue has several laws or none.
    MotionType { motion: String, laws: Vec<String> },
    /// A motion of the kind table or spline has no values.
    MotionNeedsPoints { motion: String },
    /// The motion refers to a file, which cannot be read when the law is computed.
    MotionFile { motion: String, file: String },
    /// A general polynomial has a degree other than 5 or 7.
    GeneralDegree { degree: usize },
    /// The fractions of an SCCA law do not add up to 1.
    SccaShares { b: f64, c: f64, d: f64 },
    /// The eccentric does not enclose its shaft.
    EccentricRatio { ratio: f64 },
    /// A table has an odd number of values.
    TablePairs { numbers: usize },
    /// A table has too few rows.
    TableRows { table: String, rows: usize },
    /// A row of a table is not finite.
    TableNotFinite { table: String, row: usize },
    /// The x values of a table do not increase.
    TableOrder {
        table: String,
        row: usize,
        x: f64,
        before: f64,
    },
    /// The last lift of a table equals its first lift.
    TableLevel { table: String },
    /// The spacing of a table is too uneven for a spline.
    TableSpacing { table: String },
}

/// Reasons why a programme of segments does not define a valid law.
///
/// ```
/// use gaitcam::error::JoinError;
/// use gaitcam::law::{Extent, Rise, Segment, program};
///
/// // The lift does not return to its start.
/// let up = Segment { motion: Rise::Poly345, lift: 0.02, angle: std::f64::consts::TAU };
/// let error = program(&[up], Extent::TURN).unwrap_err();
/// assert!(matches!(error.fault(), Some(JoinError::LiftJump { .. })));
/// assert!(error.is_answer());
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named in the messages
pub enum JoinError {
    /// The lift is discontinuous between two segments.
    LiftJump {
        before: SegmentName,
        after: SegmentName,
        at: Quantity,
        jump: Quantity,
    },
    /// The velocity is discontinuous between two segments.
    VelocityJump {
        before: SegmentName,
        after: SegmentName,
        at: Quantity,
        jump: Quantity,
        from: Quantity,
        to: Quantity,
        cure: JoinCure,
    },
    /// The lift falls below the base circle.
    BelowBaseCircle {
        segment: SegmentName,
        depth: Quantity,
        at: Quantity,
    },
    /// The spline through a table is below the base circle between two rows, by more than half a unit of the last decimal of the lifts.
    TableBelowBaseCircle {
        segment: SegmentName,
        first: usize,
        second: usize,
        depth: Quantity,
        at: Quantity,
    },
}

/// Segment of a programme, as named in messages.
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
    /// Number of the segment, counted from 1, and its motion.
    Segment {
        /// Number of the segment, counted from 1.
        number: usize,
        /// Name of the motion of the segment.
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

/// Suggested change that makes the velocity continuous between two segments.
///
/// ```
/// use gaitcam::error::{JoinCure, JoinError};
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
/// let Some(JoinError::VelocityJump { cure, .. }) = error.fault() else { panic!("{error}") };
/// let JoinCure::PutBetween { segment } = cure else { panic!("{cure:?}") };
/// assert_eq!(segment.number(), 1);
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum JoinCure {
    /// Both segments move in the same direction. If the length of one segment is changed to `length`, the velocities at the joint are
    /// equal.
    LetCover {
        /// Segment whose length must be changed.
        segment: SegmentName,
        /// New length of the segment.
        length: Quantity,
    },
    /// One of the two segments has a nonzero velocity at the joint, so a further segment is needed between the two.
    PutBetween {
        /// The segment whose velocity at the joint is not zero.
        segment: SegmentName,
    },
}
