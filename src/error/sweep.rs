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
#[allow(missing_docs)] // the fields are named in the messages
pub enum SweepError {
    /// An axis without `=`.
    NoAssignment { typed: String },
    /// An axis without values.
    NoValues,
    /// A sampled range with a count.
    SampledCount,
    /// A range of a grid without its count.
    NoCount,
    /// The count of a range is not a whole number.
    NotCount { typed: String },
    /// The ends of a range have different units.
    DifferentUnits { first: String, last: String },
    /// The end of a range is not a number.
    NotNumber { typed: String },
    /// A plan without rows.
    NoRows,
    /// More rows than row numbers can count.
    TooManyRows { rows: String },
    /// Columns of a list differ in length.
    ListLengths {
        key: String,
        values: u64,
        first: u64,
    },
    /// A recording that the sweep does not carry.
    NotCarried,
    /// Tolerances beside several scenes or values.
    ScatterAlone,
    /// No cam exists whose errors could be sampled.
    NoDesign,
    /// The time limit ended the search of a row.
    OutOfTime,
    /// A key that cannot vary.
    Fixed { key: String, known: String },
    /// A key that is given twice.
    KeyTwice { key: String },
    /// A sample over no key.
    NothingToSample,
    /// More keys than Sobol sequences have axes.
    SobolAxes { most: usize },
    /// A row names a base scene that does not exist.
    NoScene { scene: usize },
    /// A tolerance without `=`.
    NoToleranceValue { typed: String },
    /// A part without tolerance.
    NoTolerance { typed: String },
    /// A negative tolerance.
    NegativeTolerance { part: String, typed: String },
    /// A scene without target force has no force error.
    NoForceError,
    /// Tolerances of a cam under an arm.
    ScatterOfArm,
    /// A front over lift-off speed needs a moving axis.
    FrontWithoutMovingAxis,
    /// A front needs a base or prime radius here.
    FrontWithoutSize,
    /// No column of numbers has this name.
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
