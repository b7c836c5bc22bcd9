//! `gaitcam studio`: a local web application that updates the design while a slider moves.
//!
//! The JavaScript of the page does no computations. Each change of a field is sent as one request with the whole scene. The response is a design
//! with all its curves, checks and messages. The server delivers the files of the page and passes requests to the engine. In a page without a
//! server, the same engine runs as WebAssembly. The server reads and writes files of one folder only.
//!
//! ```text
//! http/      connections, heads, responses       guard.rs    token, host, origin
//! routes.rs  URL routing                         folder.rs   the opened folder
//! files.rs   opening and saving of scenes        assets.rs   files of the page
//! ```
#![forbid(unsafe_code)]
#![cfg_attr(not(test), deny(clippy::disallowed_methods))]
#![deny(missing_docs)]
#![cfg_attr(not(test), warn(unused_crate_dependencies))]

mod assets;
mod files;
mod folder;
mod guard;
mod http;
mod routes;

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Instant;

use folder::Folder;
use gaitcam::error::{Error, Result};
use gaitcam::scene;
use gaitcam::wording::Language;
use gaitcam_app::page::fault::StudioError;
use gaitcam_app::page::{Engine, Start, set_language, table};
use gaitcam_app::read::cannot_be_read;
use guard::{Guard, Place};
use http::Server;

/// Options of the command `gaitcam studio`.
#[derive(Debug, Clone, Default)]
pub struct Options {
    /// Scene file, folder, or name of a built-in scene. `None` opens the default scene in the working directory.
    pub open: Option<PathBuf>,
    /// Port number. 0 selects the preferred port of the folder, or a free port if the preferred port is in use.
    pub port: u16,
    /// Initial language of the page; `None` selects the language of the browser.
    pub language: Option<Language>,
}

/// State of a running studio: access control, opened folder, start state, language and engine.
struct Studio {
    guard: Guard,
    folder: Folder,
    start: Start,
    /// Initial language of the page; `None` selects the language of the browser.
    language: Option<Language>,
    engine: Engine,
    began: Instant,
}

/// Studio that already listens on its port but does not process requests yet.
pub struct Ready {
    server: Server,
    studio: Studio,
}

impl Ready {
    /// URL of the page, which contains the token.
    pub fn url(&self) -> String {
        self.studio.guard.url()
    }

    /// Processes requests until the program ends.
    pub fn serve(self) -> ! {
        self.server.serve(self.studio)
    }
}

/// Opens the folder and listens on the requested port of the loopback address.
///
/// # Errors
///
/// A folder or scene does not exist, or the port is in use.
pub fn open(options: &Options) -> Result<Ready> {
    set_language(options.language.unwrap_or_default());
    let (folder, start) = opened(options.open.as_deref())?;
    let fault = |e: std::io::Error| {
        let (port, fault) = (options.port, e.to_string());
        Error::from(StudioError::Port { port, fault })
    };
    let place = Place::of(folder.root()).map_err(fault)?;
    let server = match options.port {
        0 => Server::listen(place.port).or_else(|_| Server::listen(0)),
        port => Server::listen(port),
    };
    let server = server.map_err(fault)?;
    let studio = Studio {
        guard: Guard::new(server.port(), place.token),
        folder,
        start,
        language: options.language,
        engine: Engine::default(),
        began: Instant::now(),
    };
    Ok(Ready { server, studio })
}

fn opened(path: Option<&Path>) -> Result<(Folder, Start)> {
    let start = |folder: &Folder, toml: &str, file: Option<String>| Start {
        scene: toml.to_string(),
        file,
        folder: Some(folder.root().display().to_string()),
    };
    let with = |folder: Folder, toml: &str| {
        let start = start(&folder, toml, None);
        Ok((folder, start))
    };
    let here = || Folder::open(Path::new("."));
    let Some(path) = path else {
        return with(here()?, scene::DEFAULT);
    };
    if path.is_dir() {
        return with(Folder::open(path)?, scene::DEFAULT);
    }
    if !path.exists()
        && let Some(built_in) = path.to_str().and_then(|p| scene::built_in(p).ok())
    {
        return with(here()?, built_in.toml);
    }
    // The corresponding error of a folder tells the user to drop the file on the page, which is not open yet.
    fs::metadata(path).map_err(|e| cannot_be_read(path, &e))?;
    let parent = path.parent().filter(|p| !p.as_os_str().is_empty());
    let folder = Folder::open(parent.unwrap_or(Path::new(".")))?;
    let name = path.file_name().map(PathBuf::from).unwrap_or_default();
    let bytes = folder.read(&name)?;
    let scene = String::from_utf8_lossy(&bytes).into_owned();
    table(&scene)?;
    let start = start(&folder, &scene, Some(name.to_string_lossy().into_owned()));
    Ok((folder, start))
}

/// Locks the mutex, also after a panic in another thread, because such a panic leaves no inconsistent data.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
