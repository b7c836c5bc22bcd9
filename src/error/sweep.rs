//! Faults in a sweep: its axes, its plan, its tolerances and its tables.

use serde::Serialize;
use strum::VariantNames;

/// What is wrong with a sweep. Texts in fields are as the user typed them.
///
/// ```
/// use gaitcam::error::SweepError;
/// use gaitcam::sweep::Axis;
///
/// let error = Axis::parse("limits.stroke", false).unwrap_err();
/// assert!(matches!(error.fault(), Some(SweepError::NoAssignment { .. })));
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)] // the messages of wording/en/sweep.ftl say what each field is
pub enum SweepError {
    NoAssignment {
        typed: String,
    },
    NoValues,
    SampledCount,
    NoCount,
    NotCount {
        typed: String,
    },
    DifferentUnits {
        first: String,
        last: String,
    },
    NotNumber {
        typed: String,
    },
    NoRows,
    TooManyRows {
        rows: String,
    },
    ListLengths {
        key: String,
        values: u64,
        first: u64,
    },
    NotCarried,
    NoDesign,
    OutOfTime,
    Fixed {
        key: String,
        known: String,
    },
    KeyTwice {
        key: String,
    },
    NothingToSample,
    SobolAxes {
        most: usize,
    },
    NoScene {
        scene: usize,
    },
    NoToleranceValue {
        typed: String,
    },
    NoTolerance {
        typed: String,
    },
    NegativeTolerance {
        part: String,
        typed: String,
    },
    NoForceError,
    FrontWithoutMovingAxis,
    FrontWithoutSize,
    NoColumn {
        typed: String,
        nearest: Option<String>,
        known: String,
    },
    Arrow {
        fault: String,
    },
    Parquet {
        fault: String,
    },
}
