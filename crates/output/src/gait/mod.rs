//! Output for recordings: tables as text, and JSON for programs.

mod feet;
mod json;
mod table;
mod trials;

use gaitcam::wording::{Catalogue, Sentences};

pub use json::{cycle_json, json};
pub use table::{cycle_table, table};
pub use trials::{TrialRow, trials_json, trials_table};

/// Messages with the labels of the tables.
const LABELS: Sentences = Sentences {
    files: &[[include_str!("en.ftl"), include_str!("es.ftl")]],
    as_typed: &["list"],
    ..Sentences::NONE
};

/// Messages of the tables: labels, and the notes and names that appear in the tables.
static WORDS: Catalogue = Catalogue::new(&[
    gaitcam_base::wording::SENTENCES,
    gaitcam::force::wording::SENTENCES,
    LABELS,
]);
