//! Faults that only the page and its server can meet. Their sentences stand in `words/`.

use serde::Serialize;
use strum::VariantNames;

use crate::page::words::WORDS;
use gaitcam::error::Fault;
use gaitcam::wording::Catalogue;

/// What is wrong.
#[allow(missing_docs)] // The fields are the arguments of the sentences.
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
    /// A name that no file may have.
    FileName { name: String },
    /// No text, or no TOML.
    NotToml { line: usize, fault: String },
    /// A request that says nothing this server knows.
    BadRequest { fault: String },
    /// A file that was not given to a page without a folder.
    NotDropped,
    /// A design has no file of this name.
    NoFile { name: String },
    /// A list entry that is not there.
    NoEntry { list: String, number: usize },
    /// The port is taken.
    Port { port: u16, fault: String },
    /// The points of a force do not follow one another in time.
    FewPoints,
}

impl Fault for StudioError {
    const AREA: &'static str = "fault";
    const CODES: &'static str = "studio";
    const WORDS: &'static Catalogue = &WORDS;
}
