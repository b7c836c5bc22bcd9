//! Errors in a sweep: its axes, its plan, its tolerances and its tables.

use serde::Serialize;
use strum::VariantNames;

/// Errors of a sweep. Text fields contain the text that the user typed.
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
    /// A range has a number of values, although its values are sampled.
    SampledCount,
    /// A range of a grid has no number of values.
    NoCount,
    /// The number of values of a range is not a whole number.
    NotCount { typed: String },
    /// The ends of a range have different units.
    DifferentUnits { first: String, last: String },
    /// The end of a range is not a number.
    NotNumber { typed: String },
    /// A plan has no rows.
    NoRows,
    /// The number of rows exceeds the maximum row number.
    TooManyRows { rows: String },
    /// The columns of a list differ in length.
    ListLengths {
        key: String,
        values: u64,
        first: u64,
    },
    /// A recording is not stored with the sweep.
    NotCarried,
    /// Tolerances are combined with another variation, although tolerances apply to one design only.
    ScatterAlone,
    /// The scene has no feasible cam, so no manufacturing errors can be sampled.
    NoDesign,
    /// The time limit was reached before the cam of a row was found.
    OutOfTime,
    /// A key is not suitable for variation.
    Fixed { key: String, known: String },
    /// A key is given twice.
    KeyTwice { key: String },
    /// A sample is requested without varied keys.
    NothingToSample,
    /// The number of keys exceeds the dimensions of the Sobol sequence.
    SobolAxes { most: usize },
    /// A row contains the number of an unknown base scene.
    NoScene { scene: usize },
    /// A tolerance has no `=`.
    NoToleranceValue { typed: String },
    /// The name of a part is unknown or has no tolerance.
    NoTolerance { typed: String },
    /// A tolerance is negative.
    NegativeTolerance { part: String, typed: String },
    /// The scene has no target force and therefore no force error.
    NoForceError,
    /// Tolerances are not supported for oscillating followers.
    ScatterOfArm,
    /// A front over lift-off speed requires a moving axis.
    FrontWithoutMovingAxis,
    /// A front requires a given base or prime radius if the pressure determines the size of the cam.
    FrontWithoutSize,
    /// No numeric column has this name.
    NoColumn {
        typed: String,
        nearest: Option<String>,
        known: String,
    },
    /// Error of the Arrow library.
    Arrow { fault: String },
    /// Error of the Parquet library.
    Parquet { fault: String },
}
