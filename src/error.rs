//! Faults in the input: what is wrong, where it is, and what would be right.
//!
//! A bad cam is not an error but a [`Verdict`](crate::cam::Verdict), an impossible one is an
//! [`Infeasible`](crate::synth::Infeasible) answer, and a panic is our own bug.

use std::fmt;
use std::path::{Path, PathBuf};

/// Where in the input a fault was found.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Place {
    /// Nothing to point at (for library callers who pass values).
    Unplaced,
    /// A whole file.
    File(PathBuf),
    /// One line of a text file, counted from 1.
    Line(PathBuf, usize),
    /// A byte offset in a binary file, counted from 0.
    Byte(PathBuf, usize),
    /// A dotted key of a scene, for example `limits.stroke`.
    Key(String),
    /// A flag or argument of the command line, for example `--set`.
    Argument(String),
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Place::Unplaced => Ok(()),
            Place::File(path) => write!(f, "{}: ", path.display()),
            Place::Line(path, line) => write!(f, "{} line {line}: ", path.display()),
            Place::Byte(path, offset) => write!(f, "{} byte {offset}: ", path.display()),
            Place::Key(key) => write!(f, "{key}: "),
            Place::Argument(flag) => write!(f, "{flag}: "),
        }
    }
}

/// A fault in the input, in words for the person who has to mend it.
///
/// Displays as one line: `walk.csv line 41: time goes backwards (0.312 s after 0.318 s); …`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Error {
    /// Where the fault is.
    pub place: Place,
    /// What is wrong.
    pub what: String,
    /// What would be right; empty where nothing helpful can be said.
    pub help: String,
}

/// Result of everything that reads input.
pub type Result<T> = std::result::Result<T, Error>;

impl Error {
    /// A fault without a place; callers that know the place add it with [`Error::at`].
    pub fn new(what: impl Into<String>) -> Self {
        Error {
            place: Place::Unplaced,
            what: what.into(),
            help: String::new(),
        }
    }

    /// A fault in a whole file.
    pub fn file(path: &Path, what: impl Into<String>) -> Self {
        Error::new(what).at(Place::File(path.to_path_buf()))
    }

    /// A fault in one line (counted from 1) of a text file.
    pub fn line(path: &Path, line: usize, what: impl Into<String>) -> Self {
        Error::new(what).at(Place::Line(path.to_path_buf(), line))
    }

    /// A fault at a byte offset of a binary file.
    pub fn byte(path: &Path, offset: usize, what: impl Into<String>) -> Self {
        Error::new(what).at(Place::Byte(path.to_path_buf(), offset))
    }

    /// A fault in the value of a scene key.
    pub fn key(key: &str, what: impl Into<String>) -> Self {
        Error::new(what).at(Place::Key(key.to_string()))
    }

    /// A fault in a command-line argument.
    pub fn argument(flag: &str, what: impl Into<String>) -> Self {
        Error::new(what).at(Place::Argument(flag.to_string()))
    }

    /// Says what would be right.
    #[must_use]
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = help.into();
        self
    }

    /// Places the fault, unless a more exact place is already known.
    #[must_use]
    pub fn at(mut self, place: Place) -> Self {
        if self.place == Place::Unplaced {
            self.place = place;
        }
        self
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", self.place, self.what)?;
        if self.help.is_empty() {
            Ok(())
        } else {
            write!(f, "; {}", self.help)
        }
    }
}

impl std::error::Error for Error {}

/// The candidate nearest to `word` by edit distance, if any is near enough to be a slip of the pen.
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    candidates
        .into_iter()
        .map(|c| (strsim::damerau_levenshtein(word, c), c))
        .filter(|(d, c)| *d <= 1 + c.len().max(word.len()) / 3)
        .min_by_key(|(d, _)| *d)
        .map(|(_, c)| c)
}
