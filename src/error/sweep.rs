//! Faults in a sweep: its axes, its plan, its tolerances and its tables.

use serde::Serialize;
use strum::VariantNames;

/// Faults of a sweep. Text fields quote the user.
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
#[allow(missing_docs)] // the fields are named in the messages
pub enum SweepError {
    /// An axis has no `=`.
    NoAssignment { typed: String },
    /// An axis has no values.
    NoValues,
    /// A sampled range has a count.
    SampledCount,
    /// A range of a grid without its count.
    NoCount,
    /// The count of a range is not a whole number.
    NotCount { typed: String },
    /// The ends of a range have different units.
    DifferentUnits { first: String, last: String },
    /// The end of a range is not a number.
    NotNumber { typed: String },
    /// A plan has no rows.
    NoRows,
    /// More rows than row numbers can represent.
    TooManyRows { rows: String },
    /// Columns of a list differ in length.
    ListLengths {
        key: String,
        values: u64,
        first: u64,
    },
    /// A recording that is missing in the sweep.
    NotCarried,
    /// Tolerances together with several scenes or values.
    ScatterAlone,
    /// No cam exists whose errors could be sampled.
    NoDesign,
    /// The time limit ended the search of a row.
    OutOfTime,
    /// A key that cannot be varied.
    Fixed { key: String, known: String },
    /// A key that is given twice.
    KeyTwice { key: String },
    /// A sample without varied keys.
    NothingToSample,
    /// More keys than the dimensions of Sobol sequences.
    SobolAxes { most: usize },
    /// A row with the name of an unknown base scene.
    NoScene { scene: usize },
    /// A tolerance without `=`.
    NoToleranceValue { typed: String },
    /// A part of the tolerances has no value.
    NoTolerance { typed: String },
    /// A tolerance is negative.
    NegativeTolerance { part: String, typed: String },
    /// A scene without a target force has no force error.
    NoForceError,
    /// Tolerances are not supported for oscillating followers.
    ScatterOfArm,
    /// A front over lift-off speed requires a moving axis.
    FrontWithoutMovingAxis,
    /// A front requires a base or prime radius here.
    FrontWithoutSize,
    /// No numeric column has this name.
    NoColumn {
        typed: String,
        nearest: Option<String>,
        known: String,
    },
    /// A fault of the Arrow library.
    Arrow { fault: String },
    /// A fault of the Parquet library.
    Parquet { fault: String },
}
