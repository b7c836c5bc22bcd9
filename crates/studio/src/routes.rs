//! URL routing of the studio's server.

use std::path::Path;
use std::sync::Arc;
use std::time::{Duration, Instant};

use serde_json::json;

use crate::http::{Gone, Head, Method, Request, Response, Service, Status};
use crate::{Studio, assets, files};
use gaitcam::error::{Error, Result};
use gaitcam::halt::Halt;
use gaitcam::wording::Language;
use gaitcam_app::page::fault::StudioError;
use gaitcam_app::page::{Answer, Body, Hash, Host, LONGEST, Start, set_language};

/// Maximum size of a request body, bytes. `KEPT` applies to the upload of a file, and `QUESTION` to all other requests.
const QUESTION: usize = 4 << 20;
const KEPT: usize = 64 << 20;

impl Service for Studio {
    fn admit(&self, head: &Head) -> std::result::Result<(), Response> {
        self.guard.admit(head)
    }

    fn most(&self, head: &Head) -> usize {
        match (head.method, self.guard.inside(&head.path)) {
            (Method::Post, "keep") => KEPT,
            (Method::Post, _) => QUESTION,
            _ => 0,
        }
    }

    fn answer(&self, request: &Request, gone: Gone) -> Response {
        let path = self.guard.inside(&request.head.path);
        match request.head.method {
            Method::Post => self.post(path, request, gone),
            Method::Get | Method::Head => self.get(path, &request.head),
        }
    }
}

impl Studio {
    fn get(&self, path: &str, head: &Head) -> Response {
        set_language(of_tag(head.asked("language").unwrap_or_default()));
        match path.split_once('/').unwrap_or((path, "")) {
            ("", _) => assets::page(&self.guard.base(), self.language),
            ("folder.json", "") => Response::json(&self.folder.list()),
            ("folder", path) => answered(Answer::of(files::open(self, path))),
            ("bytes", path) => match self.folder.read(Path::new(path)) {
                Ok(bytes) => Response::new("application/octet-stream", bytes),
                Err(error) => answered(Answer::of::<()>(Err(error))),
            },
            _ => assets::file(path).unwrap_or_else(|| Response::refusal(Status::NotFound)),
        }
    }

    fn post(&self, path: &str, request: &Request, gone: Gone) -> Response {
        let body = &request.body;
        match path {
            "keep" => Response::json(&json!({"hash": self.engine.keep(body.clone())})),
            "save" => answered(match serde_json::from_slice::<files::Save>(body) {
                Ok(save) => {
                    set_language(of_tag(&save.language));
                    Answer::of(files::save(self, &save))
                }
                Err(e) => {
                    let fault = e.to_string();
                    Answer::of::<()>(Err(Error::from(StudioError::BadRequest { fault })))
                }
            }),
            route => {
                let end = Instant::now() + Duration::from_secs_f64(LONGEST);
                let halt = Halt::when(move || gone() || Instant::now() >= end);
                let asking = Asking { studio: self, halt };
                answered(self.engine.answer(&asking, route, body))
            }
        }
    }
}

fn of_tag(tag: &str) -> Language {
    Language::of_tag(tag).unwrap_or_default()
}

/// Converts a response of the engine to an HTTP response.
fn answered(answer: Answer) -> Response {
    let status = match answer.understood {
        true => Status::Ok,
        false => Status::BadRequest,
    };
    let response = match answer.body {
        Body::Json(json) => Response::new("application/json", json),
        Body::File { name, kind, bytes } => Response::new(kind, bytes).saved_as(&name),
    };
    Response { status, ..response }
}

/// Host of the engine for one request. The search of the request ends when the page disconnects or the time limit is reached.
struct Asking<'s> {
    studio: &'s Studio,
    halt: Halt,
}

impl Host for Asking<'_> {
    fn read(&self, path: &Path) -> Result<(Hash, Arc<Vec<u8>>)> {
        self.studio.folder.hashed(path)
    }

    fn seconds(&self) -> f64 {
        self.studio.began.elapsed().as_secs_f64()
    }

    fn halt(&self) -> Halt {
        self.halt.clone()
    }

    fn start(&self) -> Start {
        self.studio.start.clone()
    }
}
