//! Responses to the page, including errors as data.

use serde::Serialize;
use serde_json::{Value, json};

use crate::page::fault::StudioError;
use crate::page::{plain, remedies, words};
use gaitcam::error::{Error, Place, ReadError, Result};

/// Pairs of columns that contain the coordinates of a contour. Each is given by the first word of a column name.
const CONTOURS: [[&str; 2]; 4] = [
    ["x", "y"],
    ["angle", "radius"],
    ["theta", "radius"],
    ["theta", "r"],
];

/// Content of a response: data or a file.
#[derive(Debug, Clone, PartialEq)]
pub enum Body {
    /// Data as JSON text, in UTF-8.
    Json(Vec<u8>),
    /// A file of a design.
    File {
        /// Name under which the user saves the file.
        name: String,
        /// Media type of the file.
        kind: &'static str,
        /// Content of the file, as bytes.
        bytes: Vec<u8>,
    },
}

/// Response to a request of the page.
#[derive(Debug, Clone, PartialEq)]
pub struct Answer {
    /// Whether the request itself was valid. A valid request may contain an invalid scene.
    pub understood: bool,
    /// Content of the response: JSON data, or a file of a design.
    pub body: Body,
}

impl Answer {
    /// Response to a valid request, with `value` converted to JSON.
    pub fn json(value: &impl Serialize) -> Answer {
        // The serialisation cannot fail, because all values are structs with string keys.
        let body = Body::Json(serde_json::to_vec(value).unwrap_or_default());
        let understood = true;
        Answer { understood, body }
    }

    /// Response to a valid request: the data, or the error converted to JSON.
    pub fn of<T: Serialize>(result: Result<T>) -> Answer {
        match result {
            Ok(value) => Answer::json(&value),
            Err(error) => Answer::json(&fault_json(&error)),
        }
    }

    /// Response to an invalid request, with the reason `fault`.
    pub(crate) fn bad(fault: String) -> Answer {
        let error = Error::from(StudioError::BadRequest { fault });
        Answer {
            understood: false,
            ..Answer::json(&fault_json(&error))
        }
    }
}

/// Error as JSON for the page: code, key, location, message, help text and corrections.
pub fn fault_json(error: &Error) -> Value {
    let language = words::current();
    if let Some(contour) = contour(error) {
        return fault_json(&contour);
    }
    let key = match &error.place {
        Place::Key(key) => Some(key.as_str()),
        _ => None,
    };
    let code = error.code();
    let section = match key.and_then(|key| key.split_once('.')) {
        Some((section, _)) => section,
        None if code.starts_with("force-") || code.starts_with("read-") => "gait",
        None => "",
    };
    let place = match key {
        Some(key) => plain::label(key, language),
        None => error.place.before(language),
    };
    json!({"error": {
        "code": code,
        "key": key,
        "place": place.trim_end_matches(": "),
        "message": plain::plain(&error.what(language), section, language),
        "help": error.help(language).map(|help| plain::plain(&help, section, language)),
        "remedies": remedies::of(error),
    }})
}

/// Specific error for a table whose columns are the coordinates of a contour; `None` for other errors.
fn contour(error: &Error) -> Option<Error> {
    let Some(ReadError::NoForceColumn { columns }) = error.fault() else {
        return None;
    };
    let names = columns.iter().map(|c| c.to_lowercase());
    let stems: Vec<String> = names
        .map(|c| {
            c.split(['_', ' ', '[', '('])
                .next()
                .unwrap_or("")
                .to_string()
        })
        .collect();
    let has = |name: &&str| stems.iter().any(|stem| stem == name);
    // A table with three components contains a force.
    let is_flat = columns.len() <= 4 && !has(&"z");
    let is_contour = is_flat && CONTOURS.iter().any(|pair| pair.iter().all(&has));
    let columns = columns.join(", ");
    is_contour.then(|| Error::from(StudioError::Contour { columns }).placed(error.place.clone()))
}
