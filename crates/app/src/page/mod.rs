//! Requests of the page and their responses. The server of `gaitcam studio` uses this module. The page without a server contains the same
//! module, compiled to WebAssembly.
//!
//! A request is a JSON object with the whole scene and the hashes of its files. A response depends only on the request. Bytes are cached by
//! their hash. Force curves and designs are cached by the hash of all their inputs.
//!
//! ```text
//! ask.rs      requests by their routes               sources.rs  files and force curves of a request
//! questions/  one file per kind of request           form.rs     fields and sliders of a scene
//! answer.rs   responses and errors as data           kept.rs     files, curves and designs cached between requests
//! edit.rs     changes of a scene's table             curves/     data of the diagrams
//! abi.rs      functions that a browser calls         remedies.rs corrections for errors
//! plain.rs    messages with labels instead of keys
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

/// Time limit of one search, s.
pub const LONGEST: f64 = 60.0;

/// Parses the text of a scene as a TOML table.
///
/// # Errors
///
/// The text is not TOML. The error contains the line.
pub fn table(text: &str) -> Result<Table> {
    text.parse().map_err(|e: toml::de::Error| {
        let start = e.span().map_or(0, |s| s.start.min(text.len()));
        let line = text[..start].matches('\n').count() + 1;
        let fault = e.message().replace('\n', ", ");
        StudioError::NotToml { line, fault }.into()
    })
}

/// Locks the mutex, also after a panic in another thread, because such a panic leaves no inconsistent data.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
