//! Faults in reading scenes and recordings from files and in putting results into folders.

use std::path::Path;

use serde::Serialize;
use strum::VariantNames;

use super::{Error, ErrorKind, Place};

/// What is wrong with a file or folder. Texts in fields are what the system says.
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)] // the messages of wording/en/file.ftl say what each field is
pub enum FileError {
    CannotRead { fault: String },
    CannotPlace { fault: String },
    Folder,
    Device,
    TooLarge { mib: u64 },
    NotUtf8,
    NotToml { fault: String },
    NotJson { fault: String },
    NoSceneInSummary,
    Replaced { file: String },
    AnotherSweep { differences: String },
    NotSweepFolder { file: String },
}

impl From<FileError> for Error {
    fn from(e: FileError) -> Error {
        Error::from(ErrorKind::File(e))
    }
}

impl FileError {
    /// In a whole file.
    pub fn file(self, path: &Path) -> Error {
        Error::from(self).at(Place::File(path.to_path_buf()))
    }

    /// In one line of a file, counted from 1.
    pub fn line(self, path: &Path, line: usize) -> Error {
        Error::from(self).at(Place::Line(path.to_path_buf(), line))
    }

    /// At a byte of a file, counted from 0.
    pub fn byte(self, path: &Path, offset: usize) -> Error {
        Error::from(self).at(Place::Byte(path.to_path_buf(), offset))
    }
}
