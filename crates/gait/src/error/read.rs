//! Faults of a force file.

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
#[allow(missing_docs)] // fields are named for what they hold
pub enum ReadError {
    /// The file is empty.
    Empty,
    /// The kind of file is not supported.
    Foreign { kind: FileKind },
    /// The given sampling rate is not positive.
    RateNotPositive { rate: Quantity },
    /// The given mass is not positive.
    MassNotPositive { mass: Quantity },

    /// No table of numbers; `start` is the start of the file.
    NoTable { start: String },
    /// A force column in the header without rows of numbers.
    HeaderWithoutRows { column: String },
    /// A file without a column of vertical force.
    NoForceColumn { columns: Vec<String> },
    /// More force columns than a walkway has plates.
    ManyForces { found: usize },
    /// The columns are readings of single sensors, such as the pressures of an insole.
    SingleSensors { sensors: usize },
    /// A long table of cycles over their phase, one for each subject, task and step, without a clock.
    LongTable { cycles: usize },
    /// A long table of cycles of several movements.
    LongTasks { tasks: Vec<String> },
    /// Several vertical forces of a long table, of which only one can be read.
    LongForces { columns: Vec<String> },
    /// The file has no column names, and no column resembles a vertical force.
    NamelessColumns,
    /// An unknown column name.
    NoColumn {
        column: String,
        columns: Vec<String>,
    },
    /// An unknown column name, with a similar one.
    MisspeltColumn {
        column: String,
        near: String,
        columns: Vec<String>,
    },
    /// An unnamed column was requested by something other than its number.
    NoColumnNumber { column: String, count: usize },
    /// A force column with a unit that is not a unit of force.
    NoForceUnit { column: String, unit: String },
    /// One column is both force and time.
    ForceIsTime,
    /// The times of a column decrease from one row to the next.
    TimeBackwards { time: f64, after: f64 },
    /// Rows are much shorter than the header row.
    ShortRows { fields: usize },
    /// Commas separate both fields and decimals.
    CommasTwice { columns: usize, fields: usize },
    /// Fewer than two samples.
    FewSamples { samples: usize },
    /// Time does not increase.
    TimeStandsStill { at: Quantity },
    /// Most of the time has no samples.
    MostlyGaps { lost: Quantity, whole: Quantity },
    /// Neither a time column nor a sampling rate.
    NoRate,
    /// Converter counts without calibration or mass.
    CountsWithoutMass,
    /// Force in body weights without a mass.
    MassMissing { unit: &'static str },

    /// A sample of a stance that is not a number.
    StanceSample { sample: usize, text: String },
    /// A table of stances without stances.
    NoStanceRow,
    /// Force in body weights without a mass for this row.
    RowMassMissing { unit: &'static str, row: usize },

    /// The table of a cycle lacks a column.
    CycleColumnMissing {
        column: CycleColumn,
        columns: Vec<String>,
    },
    /// The file is marked as a cycle but contains no table.
    CycleWithoutTable,
    /// A line of a cycle is not a row of time and force.
    CycleRow,
    /// A value of a cycle is missing or not a number.
    CycleValue,
    /// The samples of a cycle last longer than its period.
    CycleTooLong { span: Quantity, period: Quantity },
    /// Critical points without a period.
    CyclePeriodMissing,
    /// Critical points in wrong order of time.
    PointsNotRising,
    /// A critical point beyond the period.
    PointBeyondPeriod { at: Quantity, period: Quantity },

    /// A MAT file without an array of numbers that can be a force.
    MatWithoutForce { arrays: Vec<String> },
    /// An array of a MAT file with fewer values than announced.
    MatCut {
        array: String,
        announced: usize,
        found: usize,
    },
    /// The only time column of a cycle is its phase, and the duration of the cycle is not given.
    PhaseWithoutPeriod { column: String },
    /// The phase of a cycle is that of a stance, and the part of the turn that it covers is not given.
    PhaseOfStance { column: String },
    /// A C3D file is said to be one cycle.
    CycleInC3d,
    /// Several forces in a file of one cycle.
    CycleForces { columns: Vec<String> },

    /// Invalid processor type of a C3D file.
    Processor { code: u8 },
    /// A C3D file without analog samples.
    NoAnalog,
    /// A number of analog values per frame that is not a multiple of the channels.
    OddAnalog { values: usize, samples: usize },
    /// A C3D file without a complete frame.
    NoFrame { bytes: usize },
    /// A C3D file without a frame rate.
    NoFrameRate,
    /// An unknown analog channel.
    NoChannel { channel: String, channels: String },
    /// Neither a force plate nor an analog force channel.
    NoPlate { channels: String },
    /// Files that are not the plates of one trial, one file each.
    NotPlatesOfOneTrial,
    /// A force plate that needs a calibration matrix but has none, with channels in other units than force.
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

/// Unsupported kinds of file, recognised by their first bytes.
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

/// A required column of a cycle.
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
