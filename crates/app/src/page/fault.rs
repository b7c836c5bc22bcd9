//! Errors of the page and of its server. Their messages are in `words/`.

use serde::Serialize;
use strum::VariantNames;

use crate::page::words::WORDS;
use gaitcam::error::Fault;
use gaitcam::wording::Catalogue;

/// Error in a request of the page, or in its server.
#[allow(missing_docs)] // The fields are the arguments of the sentences.
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
pub enum StudioError {
    /// The path is outside the opened folder.
    Outside,
    /// The operating system cannot read a file.
    CannotRead { fault: String },
    /// The operating system cannot write a file.
    CannotWrite { fault: String },
    /// The file name is invalid.
    FileName { name: String },
    /// The content is not text, or not TOML.
    NotToml { line: usize, fault: String },
    /// The server does not support the request.
    BadRequest { fault: String },
    /// The user has not provided the file to a page without a folder.
    NotDropped,
    /// The design has no file of this name.
    NoFile { name: String },
    /// The list entry does not exist.
    NoEntry { list: String, number: usize },
    /// The network port is used by another program.
    Port { port: u16, fault: String },
    /// The force has no single mean cycle.
    NoCycle,
    /// The file contains the contour of a cam and not a recording.
    Contour { columns: String },
    /// The number of points of a drawn force is too small or too large, or a point is not finite.
    FewPoints,
}

impl Fault for StudioError {
    const AREA: &'static str = "fault";
    const CODES: &'static str = "studio";
    const WORDS: &'static Catalogue = &WORDS;
}
