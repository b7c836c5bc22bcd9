//! What is kept from one question to the next, and what the machine below gives to an answer.

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

/// A design with its inputs.
pub struct Made {
    /// The scene's table.
    pub table: Table,
    /// The same with the rows of every motion in place of the file that it names.
    pub whole: Table,
    /// The scene.
    pub scene: Scene,
    /// The design.
    pub design: Design,
    /// How long it took.
    pub time: Timing,
    /// The hash of all that it depends on.
    pub hash: Hash,
    /// The hash of its force.
    pub force: Option<Hash>,
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
}
