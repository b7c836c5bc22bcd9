//! Functions that a browser calls. They reserve memory for a request, process the request, store a file, and free the response.
//!
//! Only addresses and lengths are passed. The first four bytes of a response are its length. The response for a file consists of a JSON object with
//! the media type, a line break, and the bytes of the file.
//!
//! This module owns the memory that the page may read or write. A wrong address is therefore treated as an empty request and never leads to an
//! invalid access.
#![allow(unsafe_code)] // Exported names and the imported clock; there is no unsafe block.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::{Arc, LazyLock, Mutex};

use serde_json::json;

use crate::page::answer::Body;
use crate::page::fault::StudioError;
use crate::page::hash::Hash;
use crate::page::kept::{Engine, Host, Start};
use crate::page::lock;
use gaitcam::error::{Placed, Result};
use gaitcam::halt::Halt;
use gaitcam::scene;

#[link(wasm_import_module = "env")]
unsafe extern "C" {
    /// Current time of the page's clock, s.
    safe fn seconds() -> f64;
}

/// Host in a browser. It has no folder. A search ends at the time limit, or when the page stops the worker that runs it.
struct Page;

impl Host for Page {
    fn read(&self, path: &Path) -> Result<(Hash, Arc<Vec<u8>>)> {
        Err(StudioError::NotDropped.in_file(path))
    }

    fn seconds(&self) -> f64 {
        seconds()
    }

    fn halt(&self) -> Halt {
        let end = seconds() + crate::page::LONGEST;
        Halt::when(move || seconds() >= end)
    }

    fn start(&self) -> Start {
        Start {
            scene: scene::DEFAULT.to_string(),
            ..Start::default()
        }
    }
}

static ENGINE: LazyLock<Engine> = LazyLock::new(Engine::default);
/// Buffers that this module shares with the page, by their addresses. They contain requests from the page or responses to the page.
static SHARED: Mutex<BTreeMap<usize, Vec<u8>>> = Mutex::new(BTreeMap::new());

fn share(mut bytes: Vec<u8>) -> *mut u8 {
    let at = bytes.as_mut_ptr();
    lock(&SHARED).insert(at as usize, bytes);
    at
}

fn taken(at: *mut u8) -> Vec<u8> {
    lock(&SHARED).remove(&(at as usize)).unwrap_or_default()
}

/// Stores bytes for the page, preceded by their length, and returns their address.
fn given(bytes: &[u8]) -> *mut u8 {
    let mut all = (bytes.len() as u32).to_le_bytes().to_vec();
    all.extend_from_slice(bytes);
    share(all)
}

/// Reserves `length` bytes and returns their address. The page fills the memory and passes the address to [`ask`] or [`keep`].
#[unsafe(no_mangle)]
extern "C" fn room(length: usize) -> *mut u8 {
    share(vec![0; length])
}

/// Frees the memory of a response after the page has copied it.
#[unsafe(no_mangle)]
extern "C" fn free(at: *mut u8) {
    taken(at);
}

/// Processes a request, which consists of a route, a line break and the request body. Returns the address of the response.
#[unsafe(no_mangle)]
extern "C" fn ask(at: *mut u8) -> *mut u8 {
    let all = taken(at);
    let (route, question) = all.split_at(all.iter().position(|b| *b == b'\n').unwrap_or(0));
    let route = std::str::from_utf8(route).unwrap_or_default();
    let question = question.get(1..).unwrap_or_default();
    match ENGINE.answer(&Page, route, question).body {
        Body::Json(json) => given(&json),
        Body::File { kind, bytes, .. } => {
            let mut file = json!({"kind": kind}).to_string().into_bytes();
            file.push(b'\n');
            file.extend_from_slice(&bytes);
            given(&file)
        }
    }
}

/// Stores the bytes of a file. Returns the address of a response with the hash of the bytes.
#[unsafe(no_mangle)]
extern "C" fn keep(at: *mut u8) -> *mut u8 {
    given(ENGINE.keep(taken(at)).as_str().as_bytes())
}
