//! Which address asks what.

use crate::api::{self, answer, body, catalogue, design, export, files, recording, variation};
use crate::assets;
use crate::http::{Head, Method, Request, Response, Service, Status};
use crate::state::Studio;
use crate::words;

/// Largest body of a question, and of a dropped file, bytes.
const QUESTION: usize = 4 << 20;
const DROPPED: usize = 64 << 20;

impl Service for Studio {
    fn admit(&self, head: &Head) -> Result<(), Response> {
        self.guard.admit(head)
    }

    fn most(&self, head: &Head) -> usize {
        match (head.method, self.guard.inside(&head.path)) {
            (Method::Post, "recording") => DROPPED,
            (Method::Post, _) => QUESTION,
            _ => 0,
        }
    }

    fn answer(&self, request: &Request) -> Response {
        let path = self.guard.inside(&request.head.path);
        let tag = request
            .head
            .asked("language")
            .unwrap_or(self.language.tag());
        words::settle(api::language(tag));
        match request.head.method {
            Method::Post => self.post(path, request),
            Method::Get | Method::Head => self.get(path, &request.head),
        }
    }
}

impl Studio {
    fn get(&self, path: &str, head: &Head) -> Response {
        match path.split_once('/').unwrap_or((path, "")) {
            ("", _) => assets::page(&self.guard.base(), self.language),
            ("start.json", "") => Response::json(&catalogue::start(self)),
            ("laws.json", "") => answer(catalogue::laws()),
            ("folder.json", "") => Response::json(&self.folder.list()),
            ("folder", path) => answer(files::open(self, path)),
            ("scene", name) => catalogue::picture(self, name),
            ("export", path) => export::file(self, path, head.asked("tool")),
            _ => assets::file(path).unwrap_or_else(|| Response::refusal(Status::NotFound)),
        }
    }

    fn post(&self, path: &str, request: &Request) -> Response {
        match path {
            "design" => asked(request, |ask: &design::Ask| design::design(self, ask)),
            "relax" => asked(request, |w: &design::Which| design::relax(self, w)),
            "cancel" => asked(request, |w: &design::Cancel| design::cancel(self, w)),
            "save" => asked(request, |s: &files::Save| files::save(self, s)),
            "force" => asked(request, |p: &recording::Points| recording::points(self, p)),
            "contacts" => asked(request, |c: &recording::Contacts| {
                recording::contacts(self, c)
            }),
            "sensitivity" => asked(request, |v: &variation::Vary| {
                variation::sensitivity(self, v)
            }),
            "front" => asked(request, |v: &variation::Trade| variation::front(self, v)),
            "recording" => answer(recording::dropped(self, &request.head, &request.body)),
            _ => Response::refusal(Status::NotFound),
        }
    }
}

/// Reads a question and answers it.
fn asked<Q: serde::de::DeserializeOwned, A: serde::Serialize>(
    request: &Request,
    reply: impl Fn(&Q) -> gaitcam::error::Result<A>,
) -> Response {
    match body::<Q>(request) {
        Ok(question) => answer(reply(&question)),
        Err(refusal) => refusal,
    }
}
