//! Tests of reading recordings, of their mean cycle, and of the load models.

mod c3d;
mod c3d_file;
mod cycle;
mod damaged_files;
mod doubtful;
mod hard;
mod in_span;
mod joint;
mod laboratories;
mod layouts;
mod mat;
mod models;
mod mot;
mod recordings;
mod sensors;
mod wording;

use gaitcam_gait::Recording;
use gaitcam_gait::error::Error;
use gaitcam_gait::wording::code;

/// Codes of the notes on assumptions and exclusions of a recording.
fn notes(r: &Recording) -> Vec<String> {
    r.notes.iter().map(|n| code("note", n)).collect()
}

/// Code of an error, with its location.
fn fault(e: &Error) -> String {
    format!("{}{}", e.place, e.code())
}
