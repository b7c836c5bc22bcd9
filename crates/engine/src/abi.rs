//! The functions that a browser calls: memory for a question, its answer, bytes to be kept.
//!
//! Numbers only: an address and a length in, the address of an answer out. The first four bytes of an answer are its
//! length; a file's answer is one JSON object with its media type, a line break, and the bytes.
#![allow(unsafe_code)] // The memory of a page is reached by addresses.

use std::path::Path;
use std::sync::{Arc, OnceLock};

use serde_json::json;

use crate::ask::{Body, Engine, Host, Start};
use crate::fault::StudioError;
use crate::hash::Hash;
use gaitcam::error::{Placed, Result};
use gaitcam::halt::Halt;
use gaitcam::scene;

#[link(wasm_import_module = "env")]
unsafe extern "C" {
    /// The page's clock, s.
    safe fn seconds() -> f64;
}

/// A page: it has no folder, and ends a search with its worker or after the longest time.
struct Page;

impl Host for Page {
    fn read(&self, path: &Path) -> Result<(Hash, Arc<Vec<u8>>)> {
        Err(StudioError::NotDropped.in_file(path))
    }

    fn seconds(&self) -> f64 {
        seconds()
    }

    fn halt(&self) -> Halt {
        let end = seconds() + crate::LONGEST;
        Halt::when(move || seconds() >= end)
    }

    fn start(&self) -> Start {
        Start {
            scene: scene::DEFAULT.to_string(),
            ..Start::default()
        }
    }
}

fn engine() -> &'static Engine {
    static ENGINE: OnceLock<Engine> = OnceLock::new();
    ENGINE.get_or_init(Engine::default)
}

/// Memory for `length` bytes; what is given its address takes it over.
#[unsafe(no_mangle)]
extern "C" fn room(length: usize) -> *mut u8 {
    Box::into_raw(vec![0; length].into_boxed_slice()).cast()
}

/// The bytes that the page has written into [`room`].
///
/// # Safety
/// `at` is the address that `room(length)` gave, and used once.
unsafe fn taken(at: *mut u8, length: usize) -> Vec<u8> {
    let slice = std::ptr::slice_from_raw_parts_mut(at, length);
    unsafe { Box::from_raw(slice) }.into_vec()
}

/// An answer for the page, which it gives back by [`free`].
fn given(bytes: &[u8]) -> *mut u8 {
    let mut all = (bytes.len() as u32).to_le_bytes().to_vec();
    all.extend_from_slice(bytes);
    Box::into_raw(all.into_boxed_slice()).cast()
}

/// Takes an answer back.
///
/// # Safety
/// `at` is the address of an answer of `length` bytes, its own four included.
#[unsafe(no_mangle)]
unsafe extern "C" fn free(at: *mut u8, length: usize) {
    drop(unsafe { taken(at, length) });
}

/// Answers a question: a route, a line break, and the question.
///
/// # Safety
/// As [`taken`].
#[unsafe(no_mangle)]
unsafe extern "C" fn ask(at: *mut u8, length: usize) -> *mut u8 {
    let all = unsafe { taken(at, length) };
    let (route, question) = all.split_at(all.iter().position(|b| *b == b'\n').unwrap_or(0));
    let route = std::str::from_utf8(route).unwrap_or_default();
    let question = question.get(1..).unwrap_or_default();
    match engine().answer(&Page, route, question).body {
        Body::Json(json) => given(&json),
        Body::File { kind, bytes, .. } => {
            let mut file = json!({"kind": kind}).to_string().into_bytes();
            file.push(b'\n');
            file.extend_from_slice(&bytes);
            given(&file)
        }
    }
}

/// Keeps the bytes of a file; the answer is their hash.
///
/// # Safety
/// As [`taken`].
#[unsafe(no_mangle)]
unsafe extern "C" fn keep(at: *mut u8, length: usize) -> *mut u8 {
    let hash = engine().keep(unsafe { taken(at, length) });
    given(hash.as_str().as_bytes())
}
