//! Contents of the files of a design.

use gaitcam_output::Language;

use crate::workshop::Workshop;

/// Default number of rows of law.csv and profile.csv.
pub const ROWS: usize = 1440;

/// Contents of the files of a design.
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
