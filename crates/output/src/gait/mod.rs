//! Results of reading recordings: tables as text, JSON for programs.

mod feet;
mod json;
mod table;
mod trials;

use gaitcam::wording::{Catalogue, Sentences};

pub use json::{cycle_json, json};
pub use table::{cycle_table, table};
pub use trials::{TrialRow, trials_json, trials_table};

/// Catalogue of the table labels.
const LABELS: Sentences = Sentences {
    files: &[[include_str!("en.ftl"), include_str!("es.ftl")]],
    as_typed: &["list"],
    ..Sentences::NONE
};

/// Labels together with the notes and names that the tables quote.
static WORDS: Catalogue = Catalogue::new(&[
    gaitcam_base::wording::SENTENCES,
    gaitcam::force::wording::SENTENCES,
    LABELS,
]);
