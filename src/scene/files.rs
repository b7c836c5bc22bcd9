//! Reading the force of a scene from the content of its files.

use std::iter::once;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::walkers::{PopulationReader, is_table_of_walkers};
use super::{Gait, Source};
use crate::error::{ForceError, Placed, ReadError, Result};
use crate::force::{self, ForceCurve, ReadOptions};

/// Separator between the names of the plate files of one trial, in the name of a recording.
pub const BETWEEN_PLATES: &str = " + ";

/// Access to files by their names in a scene. The files can be on the disk, in memory or in a browser.
///
/// ```
/// use std::path::Path;
/// use std::sync::Arc;
///
/// use gaitcam::error::Result;
/// use gaitcam::scene::{Files, Gait};
///
/// /// Returns the same content for every file name.
/// struct One(&'static str);
///
/// impl Files for One {
///     fn has(&self, _: &Path) -> bool {
///         true
///     }
///
///     fn read(&self, _: &Path) -> Result<Arc<Vec<u8>>> {
///         Ok(Arc::new(self.0.into()))
///     }
/// }
///
/// let gait = Gait { period: Some(1.0), ..Gait::file("cycle.csv") };
/// let force = gait.force(&One("time,Fz\n0,600\n0.25,800\n0.5,600\n0.75,400\n"))?.unwrap();
/// assert!((force.mean_n() - 600.0).abs() < 1e-6);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
pub trait Files {
    /// Whether a file with this name exists.
    fn has(&self, name: &Path) -> bool;

    /// Content of a file.
    ///
    /// # Errors
    ///
    /// The file is missing or unreadable.
    fn read(&self, name: &Path) -> Result<Arc<Vec<u8>>>;

    /// Names of all files if they are in memory; otherwise empty.
    fn names(&self) -> Vec<PathBuf> {
        Vec::new()
    }

    /// Names of the recordings in a folder, in ascending order; `None` if the name is not a folder.
    ///
    /// # Errors
    ///
    /// The folder cannot be read.
    fn folder(&self, name: &Path) -> Result<Option<Vec<PathBuf>>> {
        if self.has(name) {
            return Ok(None);
        }
        let mut inside = self.names();
        inside.retain(|file| file.starts_with(name) && !is_about_subjects(file));
        inside.sort();
        Ok((!inside.is_empty()).then_some(inside))
    }

    /// Path of a file as shown in messages.
    fn shown(&self, name: &Path) -> PathBuf {
        name.to_path_buf()
    }
}

/// Path of a recording, its content and the options for reading it.
type Recording = (PathBuf, Arc<Vec<u8>>, ReadOptions);

impl Gait {
    /// Reads the force of the scene. For several walkers, it is their mean. `None` if the caller provides the force.
    ///
    /// # Errors
    ///
    /// Errors of the load model, of a file or of a recording. For a population, the error lists every walker with an error.
    pub fn force(&self, files: &dyn Files) -> Result<Option<ForceCurve>> {
        let Source::File(first) = &self.source else {
            return self.model_force();
        };
        if first.as_os_str().is_empty() {
            return Ok(None);
        }
        if let Some((place, bytes, options)) = self.recording(files)? {
            return force::force_curve(&place, &bytes, &options, self.feet).map(Some);
        }
        let mut reader = PopulationReader::new(self);
        for name in self.recordings(files)? {
            let place = files.shown(&name);
            if reader.leaves_out(&place) {
                continue;
            }
            match content(files, &name) {
                Ok(bytes) => reader.take(&place, &bytes, || subjects(files, &name)),
                Err(why) => reader.refuse(&place, why),
            }
        }
        reader.mean(&files.shown(first)).map(Some)
    }

    /// Path, content and reading options of the recording of the scene. `None` for a load model, for several walkers, or if the caller provides the
    /// force.
    ///
    /// # Errors
    ///
    /// A file cannot be read; a unit is unknown.
    pub fn recording(&self, files: &dyn Files) -> Result<Option<Recording>> {
        let Source::File(name) = &self.source else {
            return Ok(None);
        };
        let is_one = self.more_files.is_empty() && files.folder(name)?.is_none();
        if !is_one || name.as_os_str().is_empty() {
            return Ok(None);
        }
        let bytes = content(files, name)?;
        if is_table_of_walkers(name, &bytes) {
            return Ok(None);
        }
        let options = self.read_options(subjects(files, name))?;
        Ok(Some((files.shown(name), bytes, options)))
    }

    /// Names of all files that contain the force: recordings, all plate files of each trial, and tables of subjects.
    ///
    /// # Errors
    ///
    /// A folder cannot be read or contains no recording.
    pub fn files(&self, files: &dyn Files) -> Result<Vec<PathBuf>> {
        let mut out = Vec::new();
        for name in self.recordings(files)? {
            for plate in plates(files, &name) {
                let subjects = force::metadata_name(&plate).filter(|name| files.has(name));
                out.extend(subjects.into_iter().chain([plate]));
            }
        }
        out.sort();
        out.dedup();
        Ok(out)
    }

    /// Names of the recordings of the scene. A folder is replaced by the recordings that it contains.
    fn recordings(&self, files: &dyn Files) -> Result<Vec<PathBuf>> {
        let Source::File(first) = &self.source else {
            return Ok(Vec::new());
        };
        let mut out = Vec::new();
        let names = once(first).chain(&self.more_files);
        for name in names.filter(|name| !name.as_os_str().is_empty()) {
            match files.folder(name)? {
                None => out.push(name.clone()),
                Some(inside) if inside.is_empty() => {
                    return Err(ForceError::NoWalkers.in_file(&files.shown(name)));
                }
                Some(inside) => out.extend(inside),
            }
        }
        Ok(out)
    }
}

/// Whether the name of a file denotes a table of subjects.
fn is_about_subjects(file: &Path) -> bool {
    let stem = file.file_stem().unwrap_or_default().to_string_lossy();
    stem.to_lowercase().ends_with("metadata")
}

/// Content of a recording. The plate files of one trial are joined.
///
/// # Errors
///
/// A file cannot be read; files belong to several trials; the name of a plate is missing.
pub fn content(files: &dyn Files, name: &Path) -> Result<Arc<Vec<u8>>> {
    let plates = plates(files, name);
    if let [file] = &plates[..] {
        return files.read(file);
    }
    let read = |name: &PathBuf| Ok(files.read(name)?.to_vec());
    let all: Vec<Vec<u8>> = plates.iter().map(read).collect::<Result<_>>()?;
    force::joined_plates(&all).map(Arc::new).ok_or_else(|| {
        let shown = plates
            .iter()
            .map(|name| files.shown(name).display().to_string());
        let shown = shown.collect::<Vec<_>>().join(BETWEEN_PLATES);
        ReadError::NotPlatesOfOneTrial.in_file(Path::new(&shown))
    })
}

/// Names of the plate files of a trial. Any other recording is one file, so the result is its name.
pub fn plates(files: &dyn Files, name: &Path) -> Vec<PathBuf> {
    match name.to_str() {
        Some(text) if text.contains(BETWEEN_PLATES) && !files.has(name) => text
            .split(BETWEEN_PLATES)
            .map(|n| PathBuf::from(n.trim()))
            .collect(),
        _ => vec![name.to_path_buf()],
    }
}

/// Content of the table of subjects for a table of stances in the same folder; `None` if it does not exist.
fn subjects(files: &dyn Files, name: &Path) -> Option<Vec<u8>> {
    let bytes = files.read(&force::metadata_name(name)?).ok()?;
    Some(bytes.to_vec())
}
