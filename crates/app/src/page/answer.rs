//! Answers and their errors as data.

use serde::Serialize;
use serde_json::{Value, json};

use crate::page::fault::StudioError;
use crate::page::words;
use gaitcam::error::{Error, Place, ReadError, Result};

/// Content of an answer.
#[derive(Debug, Clone, PartialEq)]
pub enum Body {
    /// Data as JSON text, in UTF-8.
    Json(Vec<u8>),
    /// A file of a design.
    File {
        /// Name of the file.
        name: String,
        /// Media type of the file.
        kind: &'static str,
        /// Contents of the file.
        bytes: Vec<u8>,
    },
}

/// An answer to the page.
#[derive(Debug, Clone, PartialEq)]
pub struct Answer {
    /// Whether the question was understood; a fault of the scene is an answer too.
    pub understood: bool,
    /// Content of the answer.
    pub body: Body,
}

impl Answer {
    /// Data as an answer.
    pub fn json(value: &impl Serialize) -> Answer {
        // Structs with string keys: this cannot fail.
        let body = Body::Json(serde_json::to_vec(value).unwrap_or_default());
        let understood = true;
        Answer { understood, body }
    }

    /// Data, or the error as data.
    pub fn of<T: Serialize>(result: Result<T>) -> Answer {
        match result {
            Ok(value) => Answer::json(&value),
            Err(error) => Answer::json(&fault_json(&error)),
        }
    }

    /// Error of a question that is not understood.
    pub(crate) fn bad(fault: String) -> Answer {
        let error = Error::from(StudioError::BadRequest { fault });
        Answer {
            understood: false,
            ..Answer::json(&fault_json(&error))
        }
    }
}

/// Error as data for the page.
pub fn fault_json(error: &Error) -> Value {
    let language = words::current();
    let key = match &error.place {
        Place::Key(key) => Some(key.clone()),
        _ => None,
    };
    let place = error.place.to_string();
    // What can be chosen under `gait.force`.
    let columns: &[String] = match error.fault() {
        Some(ReadError::NoForceColumn { columns }) => columns,
        _ => &[],
    };
    json!({"error": {
        "code": error.code(),
        "key": key,
        "place": place.trim_end_matches(": "),
        "message": error.what(language),
        "help": error.help(language),
        "columns": columns,
    }})
}
