//! Faults in motions, programmes and polynomials of boundary conditions.

use serde::Serialize;
use strum::VariantNames;

use crate::units::Quantity;

/// Faults of a motion, a programme of segments or a set of conditions.
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
#[allow(missing_docs)] // the fields are named in the messages
pub enum LawError {
    /// A programme has no segments.
    NoSegment,
    /// The extent of a programme is not positive.
    Extent { length: f64 },
    /// Lift or length of a segment are not finite.
    SegmentNotFinite { segment: SegmentName },
    /// The length of a segment is not positive.
    SegmentLength {
        segment: SegmentName,
        length: Quantity,
    },
    /// A dwell with a lift.
    DwellLift {
        segment: SegmentName,
        lift: Quantity,
    },
    /// The segments do not fill the extent.
    Uncovered {
        covered: Quantity,
        wanted: Quantity,
        missing: Quantity,
    },
    /// The segments exceed the extent.
    Overfull {
        covered: Quantity,
        wanted: Quantity,
        excess: Quantity,
    },
    /// Two adjacent general polynomials have no end conditions.
    GeneralNeighbours {
        first: SegmentName,
        second: SegmentName,
    },
    /// The segments of a constant-breadth cam do not cover half a turn.
    BreadthAngle { covered: Quantity },
    /// A general polynomial in the half turn of a constant-breadth cam.
    BreadthPolynomial { segment: usize },
    /// The segments of a constant-breadth cam do not lead from 0 to the maximum lift.
    BreadthLift {
        lift: Quantity,
        low: Quantity,
        high: Quantity,
    },
    /// A polynomial has no conditions.
    NoCondition,
    /// Invalid interval of a polynomial.
    Interval { start: f64, end: f64 },
    /// Too many conditions on a polynomial.
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
    /// A condition fixes a derivative above the degree.
    ConditionOrder {
        condition: usize,
        order: usize,
        degree: usize,
    },
    /// Two conditions fix the same derivative at the same angle.
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
    /// Wrong number of parameters.
    Parameters { motion: String, given: usize },
    /// Unknown name of a motion.
    UnknownMotion {
        motion: String,
        nearest: Option<String>,
        catalogue: Vec<String>,
    },
    /// A table or spline has no numbers.
    MotionNeedsPoints { motion: String },
    /// A motion in a file, which the caller has to read.
    MotionFile { motion: String, file: String },
    /// A general polynomial of a degree other than 5 or 7.
    GeneralDegree { degree: usize },
    /// The fractions of an SCCA law do not add to 1.
    SccaShares { b: f64, c: f64, d: f64 },
    /// The eccentric does not enclose its shaft.
    EccentricRatio { ratio: f64 },
    /// A table with an odd number of values.
    TablePairs { numbers: usize },
    /// Too few rows of a table.
    TableRows { table: String, rows: usize },
    /// A row of a table is not finite.
    TableNotFinite { table: String, row: usize },
    /// The x of a table does not increase.
    TableOrder {
        table: String,
        row: usize,
        x: f64,
        before: f64,
    },
    /// A table ends at its first lift.
    TableLevel { table: String },
    /// The spacing of a table is too uneven for a spline.
    TableSpacing { table: String },
}

/// Reasons why a programme of segments gives no valid law.
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
    /// The lift jumps between two segments.
    LiftJump {
        before: SegmentName,
        after: SegmentName,
        at: Quantity,
        jump: Quantity,
    },
    /// The velocity jumps between two segments.
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
    /// The spline through a table falls below the base circle between two rows, by more than half a unit of their
    /// last decimal.
    TableBelowBaseCircle {
        segment: SegmentName,
        first: usize,
        second: usize,
        depth: Quantity,
        at: Quantity,
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
    /// Number of the segment, counted from 1, and its motion.
    Segment {
        /// Number of the segment, counted from 1.
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
    /// Both segments move in the same direction, and another length of one makes the velocities equal.
    LetCover {
        /// The segment to change.
        segment: SegmentName,
        /// New length of the segment.
        length: Quantity,
    },
    /// One of the two segments moves at the joint, so that a segment between them is needed.
    PutBetween {
        /// The segment that moves.
        segment: SegmentName,
    },
}
