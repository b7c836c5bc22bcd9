//! The force curve that a scene names.

use std::path::{Path, PathBuf};

use crate::read::read_bytes;
use gaitcam::error::Result;
use gaitcam::force::{self, ForceCurve};
use gaitcam::scene::{self, Scene, Source};

/// The force curve that a scene names, if it names one; its paths are relative to `folder` first.
///
/// # Errors
/// Faults of the load model, the file or the recording.
pub fn target(scene: &Scene, folder: &Path) -> Result<Option<ForceCurve>> {
    let Some(gait) = &scene.gait else {
        return Ok(None);
    };
    match &gait.source {
        Source::Model(_) | Source::Harmonics(_) => gait.model_force(),
        Source::File(path) => {
            let bytes = content(folder, path)?;
            let path = find(folder, path);
            let options = gait.read_options(metadata(&path))?;
            force::force_curve(&path, &bytes, &options, gait.feet).map(Some)
        }
    }
}

/// The content of a file that a scene names: one on the disk first, then one that came with the program.
///
/// # Errors
/// A file that cannot be read.
pub fn content(folder: &Path, path: &Path) -> Result<Vec<u8>> {
    let place = find(folder, path);
    match scene::built_in_file(path).filter(|_| !place.exists()) {
        Some(bytes) => Ok(bytes.to_vec()),
        None => read_bytes(&place),
    }
}

/// A path of a scene: relative to the scene file if it exists there, else to the working directory.
pub fn find(folder: &Path, path: &Path) -> PathBuf {
    let beside = folder.join(path);
    if beside.exists() {
        beside
    } else {
        path.to_path_buf()
    }
}

/// The table of subjects in the folder of a table of stances, if there is one.
pub fn metadata(path: &Path) -> Option<Vec<u8>> {
    read_bytes(&force::metadata_name(path)?).ok()
}
