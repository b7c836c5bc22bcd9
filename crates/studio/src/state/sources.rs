//! Sources of the target force: load models, recordings of the folder, files dropped on the page.

use std::path::Path;
use std::sync::{Arc, Mutex};
use std::time::SystemTime;

use super::folder::Folder;
use super::recent::Recent;
use gaitcam::error::Result;
use gaitcam::force::{self, ForceCurve, ReadOptions};
use gaitcam::scene::{self, Gait, Scene, Source};

/// Dropped files and mean cycles that are kept.
const DROPPED: usize = 6;
const CURVES: usize = 12;

/// Files dropped on the page, held in memory, and the latest curves.
pub struct Sources {
    dropped: Mutex<Recent<String, Arc<Vec<u8>>>>,
    curves: Mutex<Recent<String, ForceCurve>>,
}

impl Sources {
    /// Nothing dropped yet.
    pub fn new() -> Sources {
        Sources {
            dropped: Mutex::new(Recent::new(DROPPED)),
            curves: Mutex::new(Recent::new(CURVES)),
        }
    }

    /// Stores a dropped file under its name.
    pub fn drop_file(&self, name: &str, bytes: Vec<u8>) {
        crate::lock(&self.dropped).put(name.to_string(), Arc::new(bytes));
    }

    /// A file by the name that a scene gives it: a dropped one first, then one that came with the program, then one of
    /// the folder.
    ///
    /// # Errors
    /// As [`Folder::read`].
    pub fn bytes(&self, folder: &Folder, path: &Path) -> Result<Arc<Vec<u8>>> {
        if let Some(bytes) = self.dropped(path) {
            return Ok(bytes);
        }
        if let Some(bytes) = scene::built_in_file(path) {
            return Ok(Arc::new(bytes.to_vec()));
        }
        folder.read(path).map(Arc::new)
    }

    /// A dropped file.
    pub fn dropped(&self, path: &Path) -> Option<Arc<Vec<u8>>> {
        crate::lock(&self.dropped).get(&path.to_string_lossy().into_owned())
    }

    /// The force curve that a scene names, if it names one.
    ///
    /// # Errors
    /// Faults of the load model, the file or the recording.
    pub fn target(&self, folder: &Folder, scene: &Scene) -> Result<Option<ForceCurve>> {
        let Some(gait) = &scene.gait else {
            return Ok(None);
        };
        let key = self.key(folder, gait);
        if let Some(curve) = crate::lock(&self.curves).get(&key) {
            return Ok(Some(curve));
        }
        let curve = match (gait.model_force()?, &gait.source) {
            (Some(curve), _) => curve,
            (None, Source::Model(_) | Source::Harmonics(_)) => return Ok(None),
            (None, Source::File(path)) => {
                let bytes = self.bytes(folder, path)?;
                force::force_curve(path, &bytes, &self.options(folder, gait, path)?, gait.feet)?
            }
        };
        crate::lock(&self.curves).put(key, curve.clone());
        Ok(Some(curve))
    }

    /// How the recording of a scene is read.
    ///
    /// # Errors
    /// Units that name nothing.
    pub fn options(&self, folder: &Folder, gait: &Gait, path: &Path) -> Result<ReadOptions> {
        let subjects = force::metadata_name(path).and_then(|p| self.bytes(folder, &p).ok());
        gait.read_options(subjects.map(|bytes| bytes.to_vec()))
    }

    /// Key of a cached curve: the keys of the scene that it depends on, and size and date of the file.
    fn key(&self, folder: &Folder, gait: &Gait) -> String {
        let stamp = match &gait.source {
            Source::Model(_) | Source::Harmonics(_) => String::new(),
            Source::File(path) => self.stamp(folder, path),
        };
        let (source, feet) = (&gait.source, gait.feet);
        let model = (gait.step_frequency, gait.body_weight);
        let how = (gait.unit.as_ref(), gait.kind, gait.period, gait.span);
        let read = (&gait.time, &gait.force, how, gait.rate, gait.mass);
        format!("{source:?} {feet:?} {model:?} {read:?} {stamp}")
    }

    fn stamp(&self, folder: &Folder, path: &Path) -> String {
        if let Some(bytes) = self.dropped(path) {
            // The same allocation is the same file: a new one under the same name is another.
            return format!("{:p}", Arc::as_ptr(&bytes));
        }
        let about = folder
            .find(path)
            .ok()
            .and_then(|p| std::fs::metadata(p).ok());
        let stamp = about.map(|m| (m.len(), m.modified().unwrap_or(SystemTime::UNIX_EPOCH)));
        format!("{stamp:?}")
    }
}
