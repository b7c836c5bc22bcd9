//! What the page asks and what it is answered; one module per question.

pub mod catalogue;
pub mod design;
pub mod export;
pub mod files;
pub mod recording;
pub mod variation;

use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Value, json};
use toml::Table;

use crate::fault::StudioError;
use crate::http::{Request, Response, Status};
use crate::words;
use gaitcam::error::{Error, Place, Result};
use gaitcam::wording::Language;

/// The body of a request, or the refusal of one that says nothing.
pub fn body<T: DeserializeOwned>(request: &Request) -> std::result::Result<T, Response> {
    serde_json::from_slice(&request.body).map_err(|e| {
        let fault = e.to_string();
        let error = Error::from(StudioError::BadRequest { fault });
        Response {
            status: Status::BadRequest,
            ..Response::json(&fault_json(&error))
        }
    })
}

/// A result, or its error as data: a scene at fault is an answer, not a failure of the connection.
pub fn answer<T: Serialize>(result: Result<T>) -> Response {
    match result {
        Ok(value) => Response::json(&value),
        Err(error) => Response::json(&fault_json(&error)),
    }
}

/// An error for the page.
pub fn fault_json(error: &Error) -> Value {
    let language = words::current();
    let key = match &error.place {
        Place::Key(key) => Some(key.clone()),
        _ => None,
    };
    let place = error.place.to_string();
    json!({"error": {
        "code": error.code(),
        "key": key,
        "place": place.trim_end_matches(": "),
        "message": error.what(language),
        "help": error.help(language),
    }})
}

/// The language of a tag, English where it is none.
pub fn language(tag: &str) -> Language {
    Language::of_tag(tag).unwrap_or_default()
}

/// A scene's text as a table.
///
/// # Errors
/// Text that is no TOML, with its line.
pub fn table(text: &str) -> Result<Table> {
    text.parse().map_err(|e: toml::de::Error| {
        let start = e.span().map_or(0, |s| s.start.min(text.len()));
        let line = text[..start].matches('\n').count() + 1;
        let fault = e.message().replace('\n', ", ");
        StudioError::NotToml { line, fault }.into()
    })
}
