//! Questions of the page and their answers: the same in the server of `gaitcam studio` and, compiled to WebAssembly, inside the page.
//!
//! A question is a JSON object with the whole scene and the hashes of the files that it names; an answer depends on nothing else. Cached data are
//! found by their contents alone: bytes by their hash, force curves and designs by the hash of all that they are made from.
//!
//! ```text
//! ask.rs      questions by their routes              sources.rs  files and force curves of a question
//! questions/  one file per kind of question          form.rs     fields and sliders of a scene
//! answer.rs   answers and errors as data             kept.rs     files, curves and designs kept between questions
//! edit.rs     changes of a scene's table             curves/     what the diagrams show
//! abi.rs      the functions that a browser calls    remedies.rs  what can be done about a fault
//! plain.rs    sentences with labels in place of keys
//! ```

#[cfg(target_family = "wasm")]
mod abi;
mod answer;
mod ask;
mod curves;
mod edit;
pub mod fault;
mod form;
mod hash;
mod kept;
mod plain;
mod questions;
mod recent;
mod remedies;
mod sources;
mod words;

use std::sync::{Mutex, MutexGuard, PoisonError};

use toml::Table;

use fault::StudioError;
use gaitcam::error::Result;

pub use answer::{Answer, Body, fault_json};
pub use hash::Hash;
pub use kept::{Engine, Host, Start};
pub use recent::Recent;
pub use sources::Named;
pub use words::{current as language, settle as set_language};

/// Longest time of a search, s.
pub const LONGEST: f64 = 60.0;

/// A scene's text as a table.
///
/// # Errors
/// Text that is not TOML, with its line.
pub fn table(text: &str) -> Result<Table> {
    text.parse().map_err(|e: toml::de::Error| {
        let start = e.span().map_or(0, |s| s.start.min(text.len()));
        let line = text[..start].matches('\n').count() + 1;
        let fault = e.message().replace('\n', ", ");
        StudioError::NotToml { line, fault }.into()
    })
}

/// Locks the mutex; a panic of another thread leaves no inconsistent state.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
