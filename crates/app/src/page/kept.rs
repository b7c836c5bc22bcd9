//! Cache between requests, and services of the host for a response.

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

/// Maximum number of stored files, and of their bytes.
const FILES: usize = 32;
const BYTES: usize = 256 << 20;
/// Maximum number of cached force curves and designs.
const CURVES: usize = 12;
const DESIGNS: usize = 12;

/// State that the page shows first.
#[derive(Debug, Clone, Default)]
pub struct Start {
    /// TOML text of the scene.
    pub scene: String,
    /// Path of the scene file in the folder, if any.
    pub file: Option<String>,
    /// Opened folder, if any.
    pub folder: Option<String>,
}

/// Services of the host for the response to one request.
pub trait Host {
    /// Content and hash of a file that is neither stored nor built in.
    ///
    /// # Errors
    ///
    /// Files that cannot be read.
    fn read(&self, path: &Path) -> Result<(Hash, Arc<Vec<u8>>)>;
    /// Clock of the host, s.
    fn seconds(&self) -> f64;
    /// Stop condition for the search of this request.
    fn halt(&self) -> Halt;
    /// State that the page shows first.
    fn start(&self) -> Start;
}

/// A design with its inputs.
pub struct Made {
    /// Table of the scene.
    pub table: Table,
    /// Table of the scene with the rows of every motion instead of its file.
    pub whole: Table,
    /// Scene as parsed from the request.
    pub scene: Scene,
    /// Design of the scene, with its checks.
    pub design: Design,
    /// Computing time of the design.
    pub time: Timing,
    /// Hash of all inputs of the design.
    pub hash: Hash,
    /// Hash of the force.
    pub force: Option<Hash>,
}

/// Processes requests. Cached data are found by hash only, so that pages cannot see each other's data.
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
    /// Stores the bytes of a file and returns their hash.
    pub fn keep(&self, bytes: Vec<u8>) -> Hash {
        let hash = Hash::of(&bytes);
        let mut files = lock(&self.files);
        files.put(hash.clone(), Arc::new(bytes));
        files.shrink(BYTES, |bytes| bytes.len());
        hash
    }

    /// Stored bytes with a hash.
    pub fn kept(&self, hash: &Hash) -> Option<Arc<Vec<u8>>> {
        lock(&self.files).get(hash)
    }
}
