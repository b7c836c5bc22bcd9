//! Faults in reading scenes, recordings and tables of motion from files and in putting results into folders.

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
#[allow(missing_docs)] // the messages of wording/en/file.ftl say what each field is
pub enum FileError {
    CannotRead {
        fault: String,
    },
    CannotPlace {
        fault: String,
    },
    Foreign,
    Held {
        process: Option<String>,
    },
    Folder,
    Device,
    TooLarge {
        mib: u64,
    },
    NotUtf8,
    NotToml {
        fault: String,
    },
    NotJson {
        fault: String,
    },
    NoSceneInSummary,
    Replaced {
        file: String,
    },
    AnotherSweep {
        differences: String,
    },
    NotSweepFolder {
        file: String,
    },
    MotionColumn {
        column: String,
        example: String,
        columns: String,
    },
    MotionUnit {
        column: String,
        example: String,
    },
    MotionControlAngle {
        column: String,
    },
    MotionValue {
        column: String,
        typed: String,
    },
    MotionOrder {
        column: String,
        x: f64,
        before: f64,
    },
    MotionManyRows {
        most: usize,
    },
    MotionDiffers {
        column: String,
        covered: f64,
        key: String,
        typed: String,
    },
}
