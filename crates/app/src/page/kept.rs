//! Data that is cached between requests, and services of the host. The host is the server or the browser in which requests are processed.

use std::path::Path;
use std::sync::{Arc, Mutex};

use toml::Table;

use crate::page::hash::Hash;
use crate::page::lock;
use crate::page::recent::Recent;
use gaitcam::error::Result;
use gaitcam::force::ForceCurve;
use gaitcam::halt::Halt;
use gaitcam::scene::Scene;
use gaitcam::synth::Design;
use gaitcam_output::Timing;

/// Maximum number of stored files. [`BYTES`] limits their total size.
const FILES: usize = 32;
const BYTES: usize = 256 << 20;
/// Maximum number of cached force curves and designs.
const CURVES: usize = 12;
const DESIGNS: usize = 12;

/// State that the page shows when it is opened.
#[derive(Debug, Clone, Default)]
pub struct Start {
    /// TOML text of the scene.
    pub scene: String,
    /// Path of the scene file in the opened folder; `None` without a file.
    pub file: Option<String>,
    /// Path of the opened folder; `None` without a folder.
    pub folder: Option<String>,
}

/// Services of the host (a server or a browser) for a request: files, clock, time limit and start state.
pub trait Host {
    /// Content and hash of a file that is neither stored by the page nor built in.
    ///
    /// # Errors
    ///
    /// The file cannot be read.
    fn read(&self, path: &Path) -> Result<(Hash, Arc<Vec<u8>>)>;
    /// Current time of the host's clock, s.
    fn seconds(&self) -> f64;
    /// Stop condition for the search of this request.
    fn halt(&self) -> Halt;
    /// State that the page shows when it is opened.
    fn start(&self) -> Start;
}

/// Design with its inputs and their hashes.
pub struct CachedDesign {
    /// Table of the scene, as in its TOML text.
    pub table: Table,
    /// Table of the scene, in which the file name of every motion is replaced by the rows of the file.
    pub whole: Table,
    /// Scene as parsed from the request.
    pub scene: Scene,
    /// Design of the scene, with its checks.
    pub design: Design,
    /// Computing times of the design, s.
    pub time: Timing,
    /// Hash of all inputs of the design.
    pub hash: Hash,
    /// Hash of the target force; `None` without a force.
    pub force: Option<Hash>,
}

/// Processor of requests, with its caches. Cached data can be retrieved only by hash, so that one page cannot read the data of another
/// page.
pub struct Engine {
    files: Mutex<Recent<Hash, Arc<Vec<u8>>>>,
    pub(crate) curves: Mutex<Recent<Hash, ForceCurve>>,
    pub(crate) designs: Mutex<Recent<Hash, Arc<CachedDesign>>>,
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
    /// Stores the bytes of a file in the cache and returns their hash.
    pub fn keep(&self, bytes: Vec<u8>) -> Hash {
        let hash = Hash::of(&bytes);
        let mut files = lock(&self.files);
        files.put(hash.clone(), Arc::new(bytes));
        files.shrink(BYTES, |bytes| bytes.len());
        hash
    }

    /// Stored bytes with the given hash; `None` if they are not in the cache.
    pub fn kept(&self, hash: &Hash) -> Option<Arc<Vec<u8>>> {
        lock(&self.files).get(hash)
    }
}
