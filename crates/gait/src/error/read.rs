//! Errors of a force file.

use serde::Serialize;
use strum::VariantNames;

use super::Fault;
use crate::units::Quantity;
use crate::wording::{Catalogue, WORDS};

/// Reasons why a file cannot be read.
///
/// ```
/// use gaitcam_gait::error::ReadError;
/// use gaitcam_gait::{ReadOptions, read};
///
/// let error = read("walk.csv".as_ref(), b"", &ReadOptions::default()).unwrap_err();
/// assert_eq!(error.fault(), Some(&ReadError::Empty));
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named in the messages
pub enum ReadError {
    /// The file is empty.
    Empty,
    /// The kind of file is not supported.
    Foreign { kind: FileKind },
    /// The given sampling rate is not positive.
    RateNotPositive { rate: Quantity },
    /// The given mass is not positive.
    MassNotPositive { mass: Quantity },

    /// The file contains no table of numbers. `start` is the first part of its text.
    NoTable { start: String },
    /// The header contains a force column, but there are no rows of numbers.
    HeaderWithoutRows { column: String },
    /// The file has no column of vertical force.
    NoForceColumn { columns: Vec<String> },
    /// The number of force columns exceeds the number of plates of a walkway.
    ManyForces { found: usize },
    /// The columns are readings of single sensors, such as the pressures of an insole.
    SingleSensors { sensors: usize },
    /// The file is a long table without times. It contains one cycle over the phase for each subject, task and step.
    LongTable { cycles: usize },
    /// The file is a long table with cycles of several movements.
    LongTasks { tasks: Vec<String> },
    /// A long table has several vertical forces, of which only one can be read.
    LongForces { columns: Vec<String> },
    /// The file has no column names, and no column resembles a vertical force.
    NamelessColumns,
    /// The name of a column is unknown.
    NoColumn {
        column: String,
        columns: Vec<String>,
    },
    /// The name of a column is unknown, but a similar name exists.
    MisspeltColumn {
        column: String,
        near: String,
        columns: Vec<String>,
    },
    /// The columns have no names, and the requested column is not a number from 1 to `count`.
    NoColumnNumber { column: String, count: usize },
    /// The unit of a force column is not a unit of force.
    NoForceUnit { column: String, unit: String },
    /// One column is used both as force and as time.
    ForceIsTime,
    /// The times decrease from one row to the next, or do not increase within a cycle.
    TimeBackwards { time: f64, after: f64 },
    /// The rows are much shorter than the header row.
    ShortRows { fields: usize },
    /// Commas separate both fields and decimals.
    CommasTwice { columns: usize, fields: usize },
    /// The file has fewer than two samples, or a cycle in a long table has fewer than four.
    FewSamples { samples: usize },
    /// The time does not increase.
    TimeStandsStill { at: Quantity },
    /// Samples are missing for about three quarters of the time or more.
    MostlyGaps { lost: Quantity, whole: Quantity },
    /// The file has no time column, and no sampling rate is known.
    NoRate,
    /// The forces are converter counts without calibration or mass.
    CountsWithoutMass,
    /// The unit of force depends on the mass of the walker, but no mass is given.
    MassMissing { unit: &'static str },

    /// A sample of a stance is not a number.
    StanceSample { sample: usize, text: String },
    /// A table of stances contains no stances.
    NoStanceRow,
    /// The unit of force depends on the mass of the walker, but this row has no mass.
    RowMassMissing { unit: &'static str, row: usize },

    /// The table of a cycle has no time column or no force column.
    CycleColumnMissing {
        column: CycleColumn,
        columns: Vec<String>,
    },
    /// The file is marked as a cycle but contains no table.
    CycleWithoutTable,
    /// A line in the table of a cycle is not a row of numbers.
    CycleRow,
    /// A value in the table of a cycle is missing or not a number.
    CycleValue,
    /// The samples of a cycle last longer than its period.
    CycleTooLong { span: Quantity, period: Quantity },
    /// Critical points are given without a period.
    CyclePeriodMissing,
    /// The times of the critical points do not increase.
    PointsNotRising,
    /// A critical point is after the end of the period.
    PointBeyondPeriod { at: Quantity, period: Quantity },

    /// The MAT file has no numeric array with a suitable size for a force.
    MatWithoutForce { arrays: Vec<String> },
    /// An array of a MAT file has fewer values than announced.
    MatCut {
        array: String,
        announced: usize,
        found: usize,
    },
    /// The file of one cycle contains only phases, and the duration of the cycle is not given.
    PhaseWithoutPeriod { column: String },
    /// The file contains phases of a stance, but the span of the stance is not given.
    PhaseOfStance { column: String },
    /// A C3D file is given as a file of one cycle.
    CycleInC3d,
    /// A file of one cycle contains several forces.
    CycleForces { columns: Vec<String> },

    /// The processor type of a C3D file is invalid.
    Processor { code: u8 },
    /// The C3D file has no analog samples.
    NoAnalog,
    /// The number of analog values in a frame is not a multiple of the number of samples per channel.
    OddAnalog { values: usize, samples: usize },
    /// The C3D file has no complete frame.
    NoFrame { bytes: usize },
    /// The C3D file has no frame rate.
    NoFrameRate,
    /// The name of an analog channel is unknown.
    NoChannel { channel: String, channels: String },
    /// The file has neither a force plate nor an analog force channel.
    NoPlate { channels: String },
    /// Several files were given, but they are not the plates of one trial with one plate per file.
    NotPlatesOfOneTrial,
    /// A force plate requires a calibration matrix but has none, and its channels are not in a unit of force.
    PlateUncalibrated { plate: usize, channels: String },
    /// All force plates have an unsupported TYPE.
    PlateTypeUnknown {
        plate: usize,
        kind: i64,
        channels: String,
    },
}

impl Fault for ReadError {
    const AREA: &'static str = "read";
    const WORDS: &'static Catalogue = &WORDS;
}

/// Unsupported kind of file, recognised by its first bytes.
///
/// ```
/// use gaitcam_gait::error::{FileKind, ReadError};
/// use gaitcam_gait::{ReadOptions, read};
///
/// let error = read("walk.csv".as_ref(), b"%PDF-1.7", &ReadOptions::default()).unwrap_err();
/// assert_eq!(error.fault(), Some(&ReadError::Foreign { kind: FileKind::Pdf }));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[allow(missing_docs)] // the names are the documentation
#[non_exhaustive]
pub enum FileKind {
    Zip,
    OldOffice,
    Matlab,
    Hdf5,
    Parquet,
    Gzip,
    Pdf,
    Xml,
    Numpy,
    Picture,
    Binary,
}

/// Column that a file of one cycle requires: time or force.
///
/// ```
/// use gaitcam_gait::error::{CycleColumn, ReadError};
/// use gaitcam_gait::{Feet, ReadOptions, one_cycle};
///
/// let text = "# cycle, period_s = 1\ntime_s,height\n0,1\n0.5,2\n";
/// let error = one_cycle("a.csv".as_ref(), text.as_bytes(), &ReadOptions::default(), Feet::Both).unwrap_err();
/// let Some(ReadError::CycleColumnMissing { column, .. }) = error.fault() else { panic!("{error}") };
/// assert_eq!(column, &CycleColumn::Force);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[allow(missing_docs)] // the names are the documentation
#[non_exhaustive]
pub enum CycleColumn {
    Time,
    Force,
}
