//! Questions by their routes, and their answers.

use std::path::Path;
use std::sync::{Arc, Mutex};

use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Map, Value, json};

use crate::fault::StudioError;
use crate::hash::Hash;
use crate::questions::design::{self, Made};
use crate::questions::{catalogue, export, recording, runs, variation};
use crate::recent::Recent;
use crate::sources::{Files, Named};
use crate::{lock, words};
use gaitcam::error::{Error, Place, Result};
use gaitcam::force::ForceCurve;
use gaitcam::halt::Halt;
use gaitcam::wording::Language;

/// Files that are kept, and the most bytes of all of them.
const FILES: usize = 32;
const BYTES: usize = 256 << 20;
/// Force curves and designs that need not be computed again.
const CURVES: usize = 12;
const DESIGNS: usize = 12;

/// What the page shows at first.
#[derive(Debug, Clone, Default)]
pub struct Start {
    /// The scene.
    pub scene: String,
    /// The file of the folder that it was read from.
    pub file: Option<String>,
    /// The opened folder, where there is one.
    pub folder: Option<String>,
}

/// What the machine below gives to the answer of one question.
pub trait Host {
    /// A file that is neither kept nor built in, with its hash.
    ///
    /// # Errors
    /// Files that are not to be had.
    fn read(&self, path: &Path) -> Result<(Hash, Arc<Vec<u8>>)>;
    /// A clock, s.
    fn seconds(&self) -> f64;
    /// When the search of this question ends.
    fn halt(&self) -> Halt;
    /// What the page shows at first.
    fn start(&self) -> Start;
}

/// What an answer holds.
#[derive(Debug, Clone, PartialEq)]
pub enum Body {
    /// Data.
    Json(Vec<u8>),
    /// A file of a design.
    File {
        /// Its name.
        name: String,
        /// Its media type.
        kind: &'static str,
        /// Its contents.
        bytes: Vec<u8>,
    },
}

/// An answer.
#[derive(Debug, Clone, PartialEq)]
pub struct Answer {
    /// Whether the question was understood: a scene at fault is an answer too.
    pub understood: bool,
    /// What it holds.
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

    /// Data, or its error as data.
    pub fn of<T: Serialize>(result: Result<T>) -> Answer {
        match result {
            Ok(value) => Answer::json(&value),
            Err(error) => Answer::json(&fault_json(&error)),
        }
    }

    fn bad(fault: String) -> Answer {
        let error = Error::from(StudioError::BadRequest { fault });
        Answer {
            understood: false,
            ..Answer::json(&fault_json(&error))
        }
    }
}

/// Answers questions. What it keeps is found by contents alone, so that no page can see what another one has.
pub struct Engine {
    files: Mutex<Recent<Hash, Arc<Vec<u8>>>>,
    pub(crate) curves: Mutex<Recent<Hash, ForceCurve>>,
    pub(crate) designs: Mutex<Recent<Hash, Arc<Made>>>,
}

impl Default for Engine {
    fn default() -> Engine {
        Engine {
            files: Mutex::new(Recent::new(FILES)),
            curves: Mutex::new(Recent::new(CURVES)),
            designs: Mutex::new(Recent::new(DESIGNS)),
        }
    }
}

impl Engine {
    /// Keeps the bytes of a file and gives their hash.
    pub fn keep(&self, bytes: Vec<u8>) -> Hash {
        let hash = Hash::of(&bytes);
        let mut files = lock(&self.files);
        files.put(hash.clone(), Arc::new(bytes));
        files.shrink(BYTES, |bytes| bytes.len());
        hash
    }

    /// The bytes of a hash, where they are kept.
    pub fn kept(&self, hash: &Hash) -> Option<Arc<Vec<u8>>> {
        lock(&self.files).get(hash)
    }

    /// Answers a question. Every answer names the hash of the question in `of`; of a file that is named and not kept it
    /// gives nothing but its hash, in `missing`.
    pub fn answer(&self, host: &dyn Host, route: &str, question: &[u8]) -> Answer {
        let mut answer = match serde_json::from_slice::<Map<String, Value>>(question) {
            Ok(object) => self.routed(host, route, object),
            Err(e) => Answer::bad(e.to_string()),
        };
        if let Body::Json(json) = &mut answer.body {
            let of = format!("{{\"of\":\"{}\",", Hash::of(question));
            json.splice(..1, of.into_bytes());
        }
        answer
    }

    fn routed(&self, host: &dyn Host, route: &str, mut object: Map<String, Value>) -> Answer {
        let tag = object.remove("language");
        let tag = tag.as_ref().and_then(Value::as_str).unwrap_or("en");
        words::settle(Language::of_tag(tag).unwrap_or_default());
        let named = object.remove("files").unwrap_or(Value::Array(Vec::new()));
        let named: Vec<Named> = match serde_json::from_value(named) {
            Ok(named) => named,
            Err(e) => return Answer::bad(e.to_string()),
        };
        let own: Option<Hash> = object
            .get("hash")
            .and_then(|h| serde_json::from_value(h.clone()).ok());
        let missing = named.iter().map(|n| n.hash.clone()).chain(own);
        let missing: Vec<Hash> = missing.filter(|hash| self.kept(hash).is_none()).collect();
        if !missing.is_empty() {
            return Answer::json(&json!({"missing": missing}));
        }
        let files = &Files::new(self, host, named);
        match route {
            "start" => Answer::json(&catalogue::start(&host.start())),
            "laws" => Answer::of(catalogue::laws()),
            "scene-picture" => asked(object, |q| catalogue::picture(files, q)),
            "design" => asked(object, |q| design::design(files, q)),
            "read" => asked(object, |q| design::read(files, q)),
            "relax" => asked(object, |q| design::relax(files, q)),
            "sensitivity" => asked(object, |q| variation::sensitivity(files, q)),
            "front" => asked(object, |q| variation::front(files, q)),
            "simulate" => asked(object, |q| runs::simulate(files, q)),
            "sweep" => asked(object, |q| runs::sweep(files, q)),
            "force" => asked(object, |q| recording::points(files, q)),
            "recording" => asked(object, |q| recording::dropped(files, q)),
            "contacts" => asked(object, |q| recording::contacts(files, q)),
            "export" => match serde_json::from_value(object.into()) {
                Ok(question) => export::file(files, &question),
                Err(e) => Answer::bad(e.to_string()),
            },
            _ => Answer::bad(route.to_string()),
        }
    }
}

/// Reads a question and answers it.
fn asked<Q: DeserializeOwned, A: Serialize>(
    object: Map<String, Value>,
    reply: impl Fn(&Q) -> Result<A>,
) -> Answer {
    match serde_json::from_value::<Q>(object.into()) {
        Ok(question) => Answer::of(reply(&question)),
        Err(e) => Answer::bad(e.to_string()),
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
