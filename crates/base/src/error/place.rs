//! Location of an error in the input.

use std::fmt;
use std::path::{Path, PathBuf};

use serde::Serialize;

use super::Error;
use crate::wording::Language;

/// Location of an error in the input.
///
/// ```
/// use gaitcam_base::error::Place;
///
/// assert_eq!(Place::Line("walk.csv".into(), 41).to_string(), "walk.csv line 41: ");
/// assert_eq!(Place::Unplaced.to_string(), "");
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Place {
    /// No location, because the caller passed the values directly.
    Unplaced,
    /// A file as a whole.
    File(PathBuf),
    /// One line of a text file, counted from 1.
    Line(PathBuf, usize),
    /// A byte offset in a binary file, counted from 0.
    Byte(PathBuf, usize),
    /// A dotted key of a scene, for example `limits.stroke`.
    Key(String),
    /// A flag or argument on the command line, for example `--set`.
    Argument(String),
}

impl Place {
    /// The location as the prefix of a message, with a colon; empty if there is no location.
    pub fn before(&self, language: Language) -> String {
        let line_word = match language {
            Language::En => "line",
            Language::Es => "línea",
        };
        match self {
            Place::Unplaced => String::new(),
            Place::File(path) => format!("{}: ", path.display()),
            Place::Line(path, line) => format!("{} {line_word} {line}: ", path.display()),
            Place::Byte(path, offset) => format!("{} byte {offset}: ", path.display()),
            Place::Key(key) => format!("{key}: "),
            Place::Argument(flag) => format!("{flag}: "),
        }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.before(Language::En))
    }
}

/// Methods that set the location of an error. An error that already has a location keeps it.
///
/// ```
/// use gaitcam_base::error::{Error, Place, Placed};
///
/// let error = Error::own("is-folder", "is a folder").in_file("walk.csv".as_ref());
/// assert_eq!(error.place, Place::File("walk.csv".into()));
/// // A location that is already set is not replaced.
/// assert_eq!(error.clone().at_key("gait.file"), error);
/// ```
pub trait Placed: Into<Error> {
    /// Sets the location to a file as a whole.
    fn in_file(self, path: &Path) -> Error {
        self.into().at(Place::File(path.to_path_buf()))
    }

    /// Sets the location to a line of a file, counted from 1.
    fn at_line(self, path: &Path, line: usize) -> Error {
        self.into().at(Place::Line(path.to_path_buf(), line))
    }

    /// Sets the location to a byte offset in a file, counted from 0.
    fn at_byte(self, path: &Path, offset: usize) -> Error {
        self.into().at(Place::Byte(path.to_path_buf(), offset))
    }

    /// Sets the location to a dotted key of a scene, for example `limits.stroke`.
    fn at_key(self, key: &str) -> Error {
        self.into().at(Place::Key(key.to_string()))
    }

    /// Sets the location to a flag or argument on the command line.
    fn at_argument(self, argument: &str) -> Error {
        self.into().at(Place::Argument(argument.to_string()))
    }
}

impl<E: Into<Error>> Placed for E {}
