//! What is wrong with a file of force.

use serde::Serialize;
use strum::VariantNames;

use super::Fault;
use crate::units::Quantity;
use crate::wording::{Catalogue, WORDS};

/// Why a file cannot be read.
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
    /// The file is of a kind that is not read.
    Foreign { kind: FileKind },
    /// The sampling rate given is not positive.
    RateNotPositive { rate: Quantity },
    /// The mass given is not positive.
    MassNotPositive { mass: Quantity },

    /// No table of numbers; `start` is the start of the file.
    NoTable { start: String },
    /// A header names a column of force, and no row of numbers follows it.
    HeaderWithoutRows { column: String },
    /// No column of vertical force.
    NoForceColumn { columns: Vec<String> },
    /// More columns of force than a walkway has.
    ManyForces { found: usize },
    /// The columns are readings of single sensors, such as the pressures of an insole.
    SingleSensors { sensors: usize },
    /// A long table of cycles over their phase, one for each subject, task and step, without a clock.
    LongTable { cycles: usize },
    /// A long table of cycles of several movements.
    LongTasks { tasks: Vec<String> },
    /// Several vertical forces of a long table, of which one can be read.
    LongForces { columns: Vec<String> },
    /// The file names no columns and none resembles a vertical force.
    NamelessColumns,
    /// No column of this name.
    NoColumn {
        column: String,
        columns: Vec<String>,
    },
    /// No column of this name; one is spelt similarly.
    MisspeltColumn {
        column: String,
        near: String,
        columns: Vec<String>,
    },
    /// A nameless column was asked for by something else than its number.
    NoColumnNumber { column: String, count: usize },
    /// A column of force states a unit that is not a unit of force.
    NoForceUnit { column: String, unit: String },
    /// The column of force is the one of time.
    ForceIsTime,
    /// The times of a column decrease from one row to the next.
    TimeBackwards { time: f64, after: f64 },
    /// Rows are much shorter than the header.
    ShortRows { fields: usize },
    /// Commas part the fields and the decimals too.
    CommasTwice { columns: usize, fields: usize },
    /// There are no samples, or only one.
    FewSamples { samples: usize },
    /// Time does not increase.
    TimeStandsStill { at: Quantity },
    /// Most of the time is without samples.
    MostlyGaps { lost: Quantity, whole: Quantity },
    /// Neither time nor sampling rate.
    NoRate,
    /// Converter counts without calibration, and no mass to scale them by.
    CountsWithoutMass,
    /// Force in body weights, and no mass.
    MassMissing { unit: &'static str },

    /// A sample of a stance is not a number.
    StanceSample { sample: usize, text: String },
    /// A table of stances without a stance.
    NoStanceRow,
    /// Force in body weights, and no mass for this row.
    RowMassMissing { unit: &'static str, row: usize },

    /// The table of a cycle lacks a column.
    CycleColumnMissing {
        column: CycleColumn,
        columns: Vec<String>,
    },
    /// The file is marked as a cycle and contains no table.
    CycleWithoutTable,
    /// A line of a cycle is not a row of time and force.
    CycleRow,
    /// A value of a cycle is missing or not a number.
    CycleValue,
    /// The samples of a cycle last longer than its period.
    CycleTooLong { span: Quantity, period: Quantity },
    /// Critical points without a period.
    CyclePeriodMissing,
    /// Critical points that do not follow each other in time.
    PointsNotRising,
    /// A critical point beyond the period.
    PointBeyondPeriod { at: Quantity, period: Quantity },

    /// The processor type of a C3D file does not exist.
    Processor { code: u8 },
    /// A C3D file without analog samples.
    NoAnalog,
    /// Analog values per frame that do not make whole samples.
    OddAnalog { values: usize, samples: usize },
    /// A C3D file without one whole frame.
    NoFrame { bytes: usize },
    /// A C3D file without a frame rate.
    NoFrameRate,
    /// No analog channel of this name.
    NoChannel { channel: String, channels: String },
    /// Neither a force plate nor an analog channel of force.
    NoPlate { channels: String },
    /// Files named together that are not the plates of one trial, one file each.
    NotPlatesOfOneTrial,
    /// A force plate whose TYPE needs a calibration matrix has none, and its channels are not in a unit of force.
    PlateUncalibrated { plate: usize, channels: String },
    /// The only force plates are of a TYPE that is not read.
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

/// A column that a cycle must have.
///
/// ```
/// use gaitcam_gait::error::{CycleColumn, ReadError};
/// use gaitcam_gait::{ReadOptions, one_cycle};
///
/// let text = "# cycle, period_s = 1\ntime_s,height\n0,1\n0.5,2\n";
/// let error = one_cycle("a.csv".as_ref(), text.as_bytes(), &ReadOptions::default()).unwrap_err();
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
