//! What the files of a design are to contain.

use gaitcam_output::Language;

use crate::workshop::Workshop;

/// Rows of law.csv and profile.csv unless the user asks for another number.
pub const ROWS: usize = 1440;

/// What the files of a design are to contain.
#[derive(Debug, Clone, Copy)]
pub struct Contents {
    /// Rows of law.csv and profile.csv.
    pub points: usize,
    /// Pictures as PNG too.
    pub png: bool,
    /// Language of pictures and report.
    pub language: Language,
    /// Files for CAD and the workshop.
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
