//! Faults in reading scenes, recordings and tables of motion from files and in putting results into folders.

use gaitcam_base::wording::InLanguages;
use serde::Serialize;
use strum::VariantNames;

/// What is wrong with a file or folder. Texts in fields are from the operating system.
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
    /// It cannot be read: `missing`, `denied`, or what the operating system says.
    CannotRead { fault: String },
    /// The operating system refuses to move the files into place.
    CannotPlace { fault: String },
    /// A name that this program does not write stands in its way.
    Foreign,
    /// Another process holds the folder.
    Held { process: Option<String> },
    /// A folder in place of a file.
    Folder,
    /// A pipe or device in place of a file.
    Device,
    /// Larger than is read.
    TooLarge { mib: u64 },
    /// Not UTF-8 text.
    NotUtf8,
    /// Not TOML.
    NotToml { fault: String },
    /// Not JSON.
    NotJson { fault: String },
    /// A summary without a scene.
    NoSceneInSummary,
    /// A file exists that would be replaced.
    Replaced { file: String },
    /// The folder holds another sweep.
    AnotherSweep { differences: String },
    /// The folder holds files that are no block of a sweep.
    NotSweepFolder { file: String },
    /// Cycles that cannot be those of a population, by file or walker.
    Walkers {
        count: usize,
        unreadable: Option<InLanguages>,
        weight: Option<String>,
        unit: Option<String>,
        feet: Option<String>,
        kind: Option<String>,
        cycle: Option<String>,
    },
    /// No table of numbers where the curve of a motor, or the rows of a motion, are to be; `start` is the start of the file.
    NoTable { start: String, purpose: String },
    /// The curve of a motor lacks a column.
    MotorColumn { column: String, columns: String },
    /// A motion lacks a column.
    MotionColumn {
        column: String,
        example: String,
        columns: String,
    },
    /// A column of a motion has no unit, or one of another kind.
    MotionUnit { column: String, example: String },
    /// A cell of a motion is not a number.
    MotionValue { column: String, typed: String },
    /// The angles of a motion do not increase.
    MotionOrder { column: String, x: f64, before: f64 },
    /// A motion has too many rows.
    MotionManyRows { most: usize },
    /// The segment states another extent or lift than its file.
    MotionDiffers {
        column: String,
        covered: f64,
        key: String,
        typed: String,
    },
}
