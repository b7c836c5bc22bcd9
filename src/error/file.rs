//! Errors in reading scenes, recordings and tables of motion from files, and in writing results to folders.

use gaitcam_base::wording::InLanguages;
use serde::Serialize;
use strum::VariantNames;

/// Errors of a file or folder. The field `fault` contains the text of the operating system or of the parser.
///
/// ```
/// use gaitcam::error::{FileError, Placed};
///
/// let error = FileError::NotUtf8.at_byte("walk.csv".as_ref(), 41);
/// assert_eq!(error.code(), "file-not-utf8");
/// assert!(error.to_string().starts_with("walk.csv byte 41: "));
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named in the messages
pub enum FileError {
    /// The file cannot be read. `fault` is `missing`, `denied`, or the text of the operating system.
    CannotRead { fault: String },
    /// A file named in the scene does not exist.
    Missing { file: String },
    /// The operating system cannot move the written files to their final names.
    CannotPlace { fault: String },
    /// A file or folder that gaitcam did not write has the name of an output file.
    Foreign,
    /// Another process has locked the folder.
    Held { process: Option<String> },
    /// The path is a folder instead of a file.
    Folder,
    /// The path is a pipe or device instead of a file.
    Device,
    /// The file is larger than the maximum size.
    TooLarge { mib: u64 },
    /// The file is not UTF-8 text.
    NotUtf8,
    /// The file is not TOML.
    NotToml { fault: String },
    /// The file is not JSON.
    NotJson { fault: String },
    /// The file is not a table of comma-separated values.
    NotCsv { fault: String },
    /// The file has no columns of measured points.
    MeasuredColumns { found: String },
    /// A coordinate of a measured point is not a number.
    MeasuredField { typed: String },
    /// The file `summary.json` does not contain a scene.
    NoSceneInSummary,
    /// An existing file would be replaced.
    Replaced { file: String },
    /// The folder contains another sweep.
    AnotherSweep { differences: String },
    /// The folder contains files that are not blocks of a sweep.
    NotSweepFolder { file: String },
    /// Some cycles cannot be used in the population. The fields list their files or walkers, one field for each reason.
    Walkers {
        count: usize,
        unreadable: Option<InLanguages>,
        weight: Option<String>,
        unit: Option<String>,
        feet: Option<String>,
        kind: Option<String>,
        cycle: Option<String>,
        open: Option<String>,
    },
    /// No file and no walker of the population has the excluded name.
    NoSuchWalker {
        name: String,
        nearest: Option<String>,
        known: String,
    },
    /// The file with the torque curve of a motor or with a motion contains no table of numbers. `start` is the beginning of the file.
    NoTable { start: String, purpose: String },
    /// The torque curve of a motor lacks a column.
    MotorColumn { column: String, columns: String },
    /// A motion lacks a column.
    MotionColumn {
        column: String,
        example: String,
        columns: String,
    },
    /// A column of a motion has no unit, or a unit of another dimension.
    MotionUnit { column: String, example: String },
    /// A cell of a motion is not a number.
    MotionValue { column: String, typed: String },
    /// The angles of a motion do not increase.
    MotionOrder { column: String, x: f64, before: f64 },
    /// A motion has too many rows.
    MotionManyRows { most: usize },
    /// The length or the lift of a segment differs from that in its motion file.
    MotionDiffers {
        column: String,
        covered: f64,
        key: String,
        typed: String,
    },
}
