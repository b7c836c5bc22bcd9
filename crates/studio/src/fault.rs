//! Faults that only the studio can meet. Their sentences stand in `words/`.

use serde::Serialize;
use strum::VariantNames;

use crate::words::Words;
use gaitcam::error::{Error, ErrorKind};
use gaitcam::wording::{Language, code};

/// What is wrong.
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
pub enum StudioError {
    /// A path leads out of the opened folder.
    Outside,
    /// The system does not give a file.
    CannotRead { fault: String },
    /// The system does not take a file.
    CannotWrite { fault: String },
    /// No plain file, or too large.
    NoFile { mib: u64 },
    /// A name that no file may have.
    FileName { name: String },
    /// No text, or no TOML.
    NotToml { line: usize, fault: String },
    /// A request that says nothing this server knows.
    BadRequest { fault: String },
    /// A design that was shown so long ago that it is forgotten.
    Forgotten,
    /// A list entry that is not there.
    NoEntry { list: String, number: usize },
    /// The port is taken.
    Port { port: u16, fault: String },
    /// The points of a force do not follow one another in time.
    FewPoints,
}

/// Area of the messages.
const AREA: &str = "fault";

impl StudioError {
    /// The sentence and the cure in a language.
    pub fn words(&self, language: Language) -> (String, Option<String>) {
        let words = Words::of(language).catalogue();
        (words.sentence(AREA, self), words.help(AREA, self))
    }
}

impl From<StudioError> for Error {
    fn from(fault: StudioError) -> Error {
        let (what, help) = fault.words(crate::words::current());
        Error::from(ErrorKind::Own {
            code: code("studio", &fault),
            what,
            help,
        })
    }
}
