//! Options that determine the files of a design and their contents.

use gaitcam_output::Language;

use crate::workshop::Workshop;

/// Default number of rows of law.csv and profile.csv.
pub const ROWS: usize = 1440;

/// Options for the files of a design.
#[derive(Debug, Clone, Copy)]
pub struct Contents {
    /// Number of rows of law.csv and profile.csv.
    pub points: usize,
    /// Whether figures are also written as PNG.
    pub png: bool,
    /// Language of figures and report.
    pub language: Language,
    /// Options of the files for CAD and manufacturing.
    pub workshop: Workshop,
}

impl Default for Contents {
    fn default() -> Contents {
        Contents {
            points: ROWS,
            png: true,
            language: Language::En,
            workshop: Workshop::default(),
        }
    }
}
