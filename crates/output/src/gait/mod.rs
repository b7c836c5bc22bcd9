//! Results of reading recordings: tables for people, JSON for programs.

mod feet;
mod json;
mod table;
mod trials;

use gaitcam::wording::{Catalogue, File};

pub use json::{cycle_json, json};
pub use table::{cycle_table, table};
pub use trials::{TrialRow, trials_json, trials_table};

/// Labels of the tables.
const LABELS: &[File] = &[[include_str!("en.ftl"), include_str!("es.ftl")]];

/// The labels with the notes and names that the tables quote.
static WORDS: Catalogue = Catalogue::new(&[
    gaitcam_base::wording::FILES,
    gaitcam::force::wording::FILES,
    LABELS,
]);
