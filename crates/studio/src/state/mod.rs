//! State of a running studio: guard, opened folder, recordings, scheduler, latest designs.

mod folder;
mod recent;
mod scheduler;
mod sources;

use std::path::Path;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex};

use toml::Table;

use crate::guard::Guard;
use crate::lock;
use gaitcam::error::Result;
use gaitcam::scene::{self, Scene};
use gaitcam::synth::Design;
use gaitcam::wording::Language;
use gaitcam_output::Timing;

pub use folder::Folder;
use recent::Recent;
pub use scheduler::LONGEST;
use scheduler::Scheduler;
use sources::Sources;

/// Designs that are kept for exports and comparisons.
const DESIGNS: usize = 48;

/// What the page shows at first.
pub struct Start {
    /// The scene.
    pub scene: String,
    /// The file of the folder that it was read from.
    pub file: Option<String>,
}

/// A design with its inputs.
pub struct Kept {
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
}

/// A running studio.
pub struct Studio {
    /// Who may ask.
    pub guard: Guard,
    /// The opened folder.
    pub folder: Folder,
    /// What the page shows at first.
    pub start: Start,
    /// Its language at first.
    pub language: Language,
    /// Recordings and load models.
    pub sources: Sources,
    /// Which request may compute.
    pub scheduler: Scheduler,
    designs: Mutex<Recent<String, Arc<Kept>>>,
    next: AtomicU64,
}

impl Studio {
    /// A studio of a folder.
    pub fn new(guard: Guard, folder: Folder, start: Start, language: Language) -> Studio {
        Studio {
            guard,
            folder,
            start,
            language,
            sources: Sources::new(),
            scheduler: Scheduler::new(),
            designs: Mutex::new(Recent::new(DESIGNS)),
            next: AtomicU64::new(1),
        }
    }

    /// Stores a design and returns its number.
    pub fn keep(&self, kept: Arc<Kept>) -> String {
        let id = self.next.fetch_add(1, Ordering::Relaxed).to_string();
        lock(&self.designs).put(id.clone(), kept);
        id
    }

    /// The scene of a table with the rows of every motion in place of the file of the folder that it names, and that
    /// table.
    ///
    /// # Errors
    /// Files that the folder does not give or that hold no motion; faults of the scene.
    pub fn scene(&self, table: &Table) -> Result<(Scene, Table)> {
        let mut read = |file: &Path| {
            let bytes = self.sources.bytes(&self.folder, file)?;
            Ok((file.to_path_buf(), bytes.to_vec()))
        };
        let whole = scene::with_motions(table, &mut read)?;
        Ok((scene::read(&whole)?, whole))
    }

    /// A stored design.
    pub fn kept(&self, id: &str) -> Option<Arc<Kept>> {
        lock(&self.designs).get(&id.to_string())
    }
}
