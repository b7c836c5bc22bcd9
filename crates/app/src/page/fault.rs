//! Faults of the page and its server. Their messages are in `words/`.

use serde::Serialize;
use strum::VariantNames;

use crate::page::words::WORDS;
use gaitcam::error::Fault;
use gaitcam::wording::Catalogue;

/// Faults of the page.
#[allow(missing_docs)] // The fields are the arguments of the sentences.
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
pub enum StudioError {
    /// A path leads out of the opened folder.
    Outside,
    /// The system cannot read a file.
    CannotRead { fault: String },
    /// The system cannot write a file.
    CannotWrite { fault: String },
    /// An invalid file name.
    FileName { name: String },
    /// Not text, or not TOML.
    NotToml { line: usize, fault: String },
    /// A request that the server does not know.
    BadRequest { fault: String },
    /// A file that was not given to a page without a folder.
    NotDropped,
    /// A design has no file of this name.
    NoFile { name: String },
    /// A missing list entry.
    NoEntry { list: String, number: usize },
    /// The port is in use.
    Port { port: u16, fault: String },
    /// A force without one mean cycle.
    NoCycle,
    /// A contour of a cam in place of a recording.
    Contour { columns: String },
    /// The times of the points of a force are not increasing.
    FewPoints,
}

impl Fault for StudioError {
    const AREA: &'static str = "fault";
    const CODES: &'static str = "studio";
    const WORDS: &'static Catalogue = &WORDS;
}
