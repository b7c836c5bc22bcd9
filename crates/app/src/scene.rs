//! Reading of scenes from files, with their input files.

use std::fs;
use std::path::{Path, PathBuf};

use toml::{Table, Value};

use crate::disk::Disk;
use crate::read;
use gaitcam::error::{Error, FileError, Place, Placed, Result};
use gaitcam::force::ForceCurve;
use gaitcam::scene::{self, BETWEEN_PLATES, Files, Scene, Source, plates};

/// Scene with the files from which it was read.
#[derive(Debug, Clone, PartialEq)]
pub struct Input {
    /// The parsed scene, without the data of its force file.
    pub scene: Scene,
    /// Table of the scene as in its file, with the changes of the user.
    pub table: Table,
    /// Table of the scene, in which the file name of every motion is replaced by the rows of the file.
    pub whole: Table,
    /// Access to the input files of the scene.
    pub files: Disk,
    /// Path of the scene file; `None` if the scene was not read from a file.
    pub file: Option<PathBuf>,
}

impl Input {
    /// Creates the input from the table of a scene. `file` is the file from which the table was read; `None` without a file.
    ///
    /// # Errors
    ///
    /// Keys or values are invalid. The error contains the path of the file.
    pub fn new(table: Table, files: Disk, file: Option<PathBuf>) -> Result<Input> {
        let named = |e| name_file(file.as_deref(), e);
        let whole = files.with_motions(&table).map_err(named)?;
        let scene = scene::read(&whole).map_err(named)?;
        Ok(Input {
            scene,
            table,
            whole,
            files,
            file,
        })
    }

    /// Reads the scene from a TOML file or from a `summary.json`.
    ///
    /// # Errors
    ///
    /// The file cannot be read, or its scene is invalid as for [`Input::new`].
    pub fn open(path: &Path) -> Result<Input> {
        Input::new(table(path)?, Disk::beside(path), Some(path.to_path_buf()))
    }

    /// Table of the scene with all paths made independent of the folder of the scene file. Paths of recordings are absolute. The rows of
    /// motion files replace the names of these files.
    pub fn resolved(&self) -> Table {
        let mut table = self.whole.clone();
        let absolute = |name: &PathBuf| {
            let place = self.files.place(name);
            let whole = place.and_then(|place| dunce::canonicalize(place).ok());
            whole
                .as_ref()
                .unwrap_or(name)
                .to_string_lossy()
                .into_owned()
        };
        let whole = |name: &PathBuf| {
            let all = plates(&self.files, name);
            let all: Vec<String> = all.iter().map(absolute).collect();
            Value::String(all.join(BETWEEN_PLATES))
        };
        if let (Some((first, more)), Some(gait)) = (
            self.recordings(),
            table.get_mut("gait").and_then(Value::as_table_mut),
        ) {
            let value = match more {
                [] => whole(first),
                more => Value::Array(std::iter::once(first).chain(more).map(whole).collect()),
            };
            gait.insert("file".to_string(), value);
        }
        table
    }

    /// File name of the scene's recording, and file names of the recordings of additional walkers. `None` without a recording.
    fn recordings(&self) -> Option<(&PathBuf, &[PathBuf])> {
        let gait = self.scene.gait.as_ref()?;
        match &gait.source {
            Source::File(name) if !name.as_os_str().is_empty() => Some((name, &gait.more_files)),
            Source::File(_) | Source::Model(_) | Source::Harmonics(_) => None,
        }
    }

    /// Path of the scene's recording; `None` without a recording.
    pub fn recording(&self) -> Option<PathBuf> {
        Some(self.files.shown(self.recordings()?.0))
    }

    /// Paths of all files from which the scene was read: scene file, recordings and motions.
    ///
    /// # Errors
    ///
    /// A folder of recordings cannot be read.
    pub fn paths(&self) -> Result<Vec<PathBuf>> {
        let gait = self.scene.gait.as_ref();
        let of_force = gait.map(|gait| gait.files(&self.files)).transpose()?;
        let motions = scene::motion_files(&self.table);
        let named = of_force.into_iter().flatten().chain(motions);
        let named = named.filter_map(|name| self.files.place(&name));
        Ok(self.file.iter().cloned().chain(named).collect())
    }

    /// Entries of the title block for a drawing of the scene: revision, date and accuracy.
    #[cfg(feature = "cad")]
    pub fn title(&self) -> gaitcam_cad::drawing::Title {
        gaitcam_cad::drawing::Title {
            date: self.file.as_deref().and_then(last_change),
            ..crate::workshop::title(&self.scene, &self.whole)
        }
    }

    /// Force curve of the scene; `None` if the scene has no force.
    ///
    /// # Errors
    ///
    /// The load model, the file or the recording is invalid.
    pub fn target(&self) -> Result<Option<ForceCurve>> {
        let gait = self.scene.gait.as_ref();
        let force = gait.map(|gait| gait.force(&self.files)).transpose();
        let named = |e| name_file(self.file.as_deref(), at_key_if_missing(e));
        Ok(force.map_err(named)?.flatten())
    }
}

/// Date of the last change of a file, in days since 1970-01-01 (UTC).
#[cfg(feature = "cad")]
fn last_change(file: &Path) -> Option<u64> {
    const SECONDS: u64 = 86_400;
    let time = fs::metadata(file).ok()?.modified().ok()?;
    Some(time.duration_since(std::time::UNIX_EPOCH).ok()?.as_secs() / SECONDS)
}

/// Table of a scene, read from a TOML file or from a `summary.json`.
///
/// # Errors
///
/// The file cannot be read or contains no scene.
pub fn table(path: &Path) -> Result<Table> {
    let text = read::read_text(path)?;
    if path.extension().is_some_and(|e| e == "json") {
        return of_summary(path, &text);
    }
    parse(&text, Some(path))
}

/// Table of a scene, and access to its input files. If no file has this path, the built-in scene with this name is used.
///
/// # Errors
///
/// The file cannot be read or contains no scene, or the name is unknown.
pub fn named(path: &Path) -> Result<(Table, Disk)> {
    let name = path
        .to_str()
        .filter(|name| !name.contains(['/', '\\', '.']));
    match name.filter(|_| !path.exists()) {
        Some(name) => Ok((
            parse(scene::built_in(name)?.toml, Some(path))?,
            Disk::default(),
        )),
        None => Ok((table(path)?, Disk::beside(path))),
    }
}

/// Parses the text of a scene. Errors contain `path` as their location.
///
/// # Errors
///
/// The text is not TOML. The error contains the line if a file is given.
pub fn parse(text: &str, path: Option<&Path>) -> Result<Table> {
    text.parse()
        .map_err(|e: toml::de::Error| not_toml(path, text, &e))
}

/// Table of the scene in the text of a `summary.json`.
fn of_summary(path: &Path, text: &str) -> Result<Table> {
    let value: serde_json::Value = serde_json::from_str(text).map_err(|e| not_json(path, &e))?;
    let missing = || FileError::NoSceneInSummary.in_file(path);
    let scene = value.get("scene").ok_or_else(missing)?;
    serde_json::from_value(scene.clone()).map_err(|_| missing())
}

/// Error for a text that is not JSON, with the line of the error in the text.
pub fn not_json(path: &Path, e: &serde_json::Error) -> Error {
    let fault = e.to_string();
    FileError::NotJson { fault }.at_line(path, e.line())
}

fn not_toml(path: Option<&Path>, text: &str, e: &toml::de::Error) -> Error {
    let line = e.span().map_or(1, |s| {
        text[..s.start.min(text.len())].matches('\n').count() + 1
    });
    let fault = e.message().replace('\n', ", ");
    let error = Error::from(FileError::NotToml { fault });
    match path {
        Some(path) => error.at_line(path, line),
        None => error,
    }
}

/// Moves the location of an error about a missing recording to the scene key that contains the name of the recording. Other errors are
/// unchanged.
fn at_key_if_missing(e: Error) -> Error {
    let is_missing =
        |f: &FileError| matches!(f, FileError::CannotRead { fault } if fault == "missing");
    match &e.place {
        Place::File(path) if e.fault().is_some_and(is_missing) => {
            let file = path.display().to_string();
            FileError::Missing { file }.at_key("gait.file")
        }
        _ => e,
    }
}

/// Adds the path of the scene file to the location of an error.
fn name_file(path: Option<&Path>, mut e: Error) -> Error {
    if let (Some(path), Place::Key(key)) = (path, &e.place) {
        e.place = Place::Key(format!("{}: {key}", path.display()));
    }
    e
}
