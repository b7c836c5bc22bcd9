//! The force curve that a scene names.

use std::path::{Path, PathBuf};

use crate::population::{inside, population};
use crate::read::read_bytes;
pub use crate::read::{find, metadata};
use gaitcam::error::{Placed, ReadError, Result};
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
            if let Some(mean) = population(gait, folder, path)? {
                return Ok(Some(mean));
            }
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
    if place.exists() {
        return read_bytes(&place);
    }
    if let Some(bytes) = scene::built_in_file(path) {
        return Ok(bytes.to_vec());
    }
    match plates(folder, path) {
        Some(files) => joined(&files),
        None => read_bytes(&place),
    }
}

/// The files that a name in a scene stands for, by their names: one, or the recordings of a folder.
///
/// # Errors
/// A file or folder that cannot be read.
pub fn contents(folder: &Path, path: &Path) -> Result<Vec<(PathBuf, Vec<u8>)>> {
    let place = find(folder, path);
    if !place.is_dir() {
        return Ok(vec![(path.to_path_buf(), content(folder, path)?)]);
    }
    let named = |file: &PathBuf| {
        let rest = file.strip_prefix(&place).unwrap_or(file);
        Ok((path.join(rest), read_bytes(file)?))
    };
    inside(&place)?.recordings.iter().map(named).collect()
}

/// Stands between the files of the plates of one trial, in a scene as on the screen.
pub const AND: &str = " + ";

/// The files of the plates that a path names together, `None` where it names one file.
pub fn plates(folder: &Path, path: &Path) -> Option<Vec<PathBuf>> {
    let text = path.to_str()?;
    let names = text
        .split(AND)
        .map(|name| find(folder, Path::new(name.trim())));
    (text.contains(AND) && !find(folder, path).exists()).then(|| names.collect())
}

/// The recording that the files of the plates of one trial hold together.
///
/// # Errors
/// A file that cannot be read, files of several trials or without the name of a plate.
pub fn joined(files: &[PathBuf]) -> Result<Vec<u8>> {
    if let [file] = files {
        return read_bytes(file);
    }
    let all = files
        .iter()
        .map(|f| read_bytes(f))
        .collect::<Result<Vec<_>>>()?;
    let joined = force::joined_plates(&all);
    joined.ok_or_else(|| {
        let names: Vec<String> = files.iter().map(|f| f.display().to_string()).collect();
        ReadError::NotPlatesOfOneTrial.in_file(Path::new(&names.join(AND)))
    })
}
