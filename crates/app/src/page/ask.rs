//! Calls the function that processes a request, according to the route of the request.

use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Map, Value, json};

use crate::page::answer::{Answer, Body};
use crate::page::hash::Hash;
use crate::page::kept::{Engine, Host};
use crate::page::questions::{catalogue, design, export, range, recording, relax, runs, variation};
use crate::page::sources::{Files, Named};
use crate::page::words;
use gaitcam::error::Result;
use gaitcam::wording::Language;

impl Engine {
    /// Processes a request. JSON responses contain the hash of the request in the field `of`. If files of the request are not stored, the response
    /// contains the list `missing` with their hashes instead of a result.
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
            "relax" => asked(object, |q| relax::relax(files, q)),
            "range" => asked(object, |q| range::range(files, q)),
            "sensitivity" => asked(object, |q| variation::sensitivity(files, q)),
            "front" => asked(object, |q| variation::front(files, q)),
            "sweep" => asked(object, |q| runs::sweep(files, q)),
            "force" => asked(object, |q| recording::points(files, q)),
            "cycle" => asked(object, |q| recording::mean_cycle(files, q)),
            _ if cfg!(feature = "cad") => self.whole(files, route, object),
            _ => Answer::bad(route.to_string()),
        }
    }

    /// Processes the requests that need the second WebAssembly module, which includes CAD. The first module of the page forwards them.
    fn whole(&self, files: &Files, route: &str, object: Map<String, Value>) -> Answer {
        match route {
            "simulate" => asked(object, |q| runs::simulate(files, q)),
            "resonance" => asked(object, |q| runs::resonance(files, q)),
            "identify" => asked(object, |q| runs::identify(files, q)),
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

/// Parses the body of a request and passes it to `reply`. Returns the response.
fn asked<Q: DeserializeOwned, A: Serialize>(
    object: Map<String, Value>,
    reply: impl Fn(&Q) -> Result<A>,
) -> Answer {
    match serde_json::from_value::<Q>(object.into()) {
        Ok(question) => Answer::of(reply(&question)),
        Err(e) => Answer::bad(e.to_string()),
    }
}
