//! `gaitcam studio`: a local web application on which the cam changes under the slider.
//!
//! The page holds no mathematics: each change of a field is one request, answered by one design with all its
//! curves, checks and sentences. The server keeps nothing that the page needs: the whole scene travels with every
//! request, so tabs are independent and a reload loses nothing.
//!
//! ```text
//! http/    connections, heads, answers          guard.rs   token, host, origin
//! api/     one module per question              state/     opened folder, recordings, scheduler, latest designs
//! edit.rs  changes of a scene's table           form.rs    fields and sliders of a scene
//! curves.rs  what the diagrams show
//! ```
#![forbid(unsafe_code)]
#![deny(missing_docs)]
#![cfg_attr(not(test), warn(unused_crate_dependencies))]

mod api;
mod assets;
mod curves;
mod edit;
mod fault;
mod form;
mod guard;
mod http;
mod routes;
mod state;
mod words;

use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use fault::StudioError;
use gaitcam::error::{Error, Result};
use gaitcam::scene;
use gaitcam::wording::Language;
use guard::Guard;
use http::Server;
use state::{Folder, Start, Studio};

/// What is opened, and where.
#[derive(Debug, Clone, Default)]
pub struct Options {
    /// A scene file, a folder, or the name of a built-in scene; the working directory with the default scene
    /// otherwise.
    pub open: Option<PathBuf>,
    /// The port; 0 takes a free one.
    pub port: u16,
    /// Language of the page at first.
    pub language: Language,
}

/// A studio that listens but does not answer yet.
pub struct Ready {
    server: Server,
    studio: Studio,
}

impl Ready {
    /// The address to open, with its token.
    pub fn url(&self) -> String {
        self.studio.guard.url()
    }

    /// Answers for ever.
    pub fn serve(self) -> ! {
        self.server.serve(self.studio)
    }
}

/// Opens the folder and starts listening on the loopback address.
///
/// # Errors
/// Folders and scenes that are not there, a port that is taken.
pub fn open(options: &Options) -> Result<Ready> {
    words::settle(options.language);
    let (folder, start) = opened(options.open.as_deref())?;
    let port = |e: std::io::Error| {
        let (port, fault) = (options.port, e.to_string());
        Error::from(StudioError::Port { port, fault })
    };
    let server = Server::listen(options.port).map_err(port)?;
    let guard = Guard::new(server.port()).map_err(port)?;
    let studio = Studio::new(guard, folder, start, options.language);
    Ok(Ready { server, studio })
}

fn opened(path: Option<&Path>) -> Result<(Folder, Start)> {
    let default = |toml: &str| Start {
        scene: toml.to_string(),
        file: None,
    };
    let here = || Folder::open(Path::new("."));
    let Some(path) = path else {
        return Ok((here()?, default(scene::DEFAULT)));
    };
    if path.is_dir() {
        return Ok((Folder::open(path)?, default(scene::DEFAULT)));
    }
    if !path.exists()
        && let Some(built_in) = path.to_str().and_then(|p| scene::built_in(p).ok())
    {
        return Ok((here()?, default(built_in.toml)));
    }
    let parent = path.parent().filter(|p| !p.as_os_str().is_empty());
    let folder = Folder::open(parent.unwrap_or(Path::new(".")))?;
    let name = path.file_name().map(PathBuf::from).unwrap_or_default();
    let bytes = folder.read(&name)?;
    let scene = String::from_utf8_lossy(&bytes).into_owned();
    api::table(&scene)?;
    let file = Some(name.to_string_lossy().into_owned());
    Ok((folder, Start { scene, file }))
}

/// Locks; a thread that panicked has left nothing half done here.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
