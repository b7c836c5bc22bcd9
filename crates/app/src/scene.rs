//! Scenes from files, with the folder that their paths are relative to.

use std::fs;
use std::path::{Path, PathBuf};

use toml::{Table, Value};

use crate::{read, target};
use gaitcam::error::{Error, FileError, Place, Placed, Result};
use gaitcam::force::ForceCurve;
use gaitcam::scene::{self, Scene, Source};

/// A scene with the folder that its paths are relative to.
#[derive(Debug, Clone, PartialEq)]
pub struct Input {
    /// The scene.
    pub scene: Scene,
    /// Its table as it was written and changed.
    pub table: Table,
    /// The same with the rows of every motion in place of the file that it names.
    pub whole: Table,
    /// The folder that its paths are relative to.
    pub folder: PathBuf,
    /// The file that it was read from.
    pub file: Option<PathBuf>,
}

impl Input {
    /// The scene of a table, which came from `file` or from nowhere.
    ///
    /// # Errors
    /// Keys and values that are wrong, with the file where there is one.
    pub fn new(table: Table, folder: PathBuf, file: Option<PathBuf>) -> Result<Input> {
        let named = |e| name_file(file.as_deref(), e);
        let whole = with_motions(&table, &folder).map_err(named)?;
        let scene = scene::read(&whole).map_err(named)?;
        Ok(Input {
            scene,
            table,
            whole,
            folder,
            file,
        })
    }

    /// The scene of a TOML file, or the one in a `summary.json`.
    ///
    /// # Errors
    /// Files that cannot be read, and as [`Input::new`].
    pub fn open(path: &Path) -> Result<Input> {
        Input::new(table(path)?, folder_of(path), Some(path.to_path_buf()))
    }

    /// The resolved scene, changes included, independent of the folder it is read from: the path of a
    /// recording is absolute, rows of motions replace their files.
    pub fn resolved(&self) -> Table {
        let mut table = self.whole.clone();
        let whole = |path: &Path| Some(fs::canonicalize(path).ok()?.to_string_lossy().into_owned());
        let file = self.recording().and_then(|path| {
            let plates = target::plates(&self.folder, &path);
            let files = plates.unwrap_or_else(|| vec![path]);
            let files: Option<Vec<String>> = files.iter().map(|f| whole(f)).collect();
            Some(files?.join(target::AND))
        });
        let more = self.scene.gait.as_ref().map_or(&[][..], |g| &g.more_files);
        let absolute = |path: &PathBuf| {
            let place = target::find(&self.folder, path);
            whole(&place).unwrap_or_else(|| place.to_string_lossy().into_owned())
        };
        let gait = table.get_mut("gait").and_then(Value::as_table_mut);
        if let (Some(file), Some(gait)) = (file, gait) {
            let mut all = vec![Value::String(file)];
            all.extend(more.iter().map(|path| Value::String(absolute(path))));
            let value = match all.len() {
                1 => all.remove(0),
                _ => Value::Array(all),
            };
            gait.insert("file".to_string(), value);
        }
        table
    }

    /// The recording that the scene names, if it names one.
    pub fn recording(&self) -> Option<PathBuf> {
        match &self.scene.gait.as_ref()?.source {
            Source::File(path) if !path.as_os_str().is_empty() => {
                Some(target::find(&self.folder, path))
            }
            Source::File(_) | Source::Model(_) | Source::Harmonics(_) => None,
        }
    }

    /// The files that its motions name.
    pub fn motions(&self) -> Vec<PathBuf> {
        let files = scene::motion_files(&self.table);
        files
            .iter()
            .map(|f| target::find(&self.folder, f))
            .collect()
    }

    /// Title block of a drawing of the scene.
    #[cfg(feature = "cad")]
    pub fn title(&self) -> gaitcam_cad::drawing::Title {
        gaitcam_cad::drawing::Title {
            date: self.file.as_deref().and_then(last_change),
            ..crate::workshop::title(&self.scene, &self.whole)
        }
    }

    /// The force curve that the scene names, if it names one.
    ///
    /// # Errors
    /// Faults of the load model, the file or the recording.
    pub fn target(&self) -> Result<Option<ForceCurve>> {
        target::target(&self.scene, &self.folder)
    }
}

/// The table of a scene with the rows of every motion in place of the file that it names; paths are relative to
/// `folder` first.
///
/// # Errors
/// Files that cannot be read or hold no motion.
pub fn with_motions(table: &Table, folder: &Path) -> Result<Table> {
    scene::with_motions(table, &mut |file| {
        let path = target::find(folder, file);
        let bytes = read::read_motion(&path)?;
        Ok((path, bytes))
    })
}

/// Day on which a file was last changed, counted from 1970-01-01 (UTC).
#[cfg(feature = "cad")]
fn last_change(file: &Path) -> Option<u64> {
    const SECONDS: u64 = 86_400;
    let time = fs::metadata(file).ok()?.modified().ok()?;
    Some(time.duration_since(std::time::UNIX_EPOCH).ok()?.as_secs() / SECONDS)
}

/// The folder that paths in a scene file are relative to.
pub fn folder_of(path: &Path) -> PathBuf {
    path.parent().unwrap_or(Path::new(".")).to_path_buf()
}

/// The table of a TOML file, or of the scene in a `summary.json`.
///
/// # Errors
/// Files that cannot be read or hold no scene.
pub fn table(path: &Path) -> Result<Table> {
    let text = read::read_text(path)?;
    if path.extension().is_some_and(|e| e == "json") {
        return of_summary(path, &text);
    }
    parse(&text, Some(path))
}

/// The table of a scene's text; `path` names the file in faults.
///
/// # Errors
/// Text that is no TOML, with its line where there is a file.
pub fn parse(text: &str, path: Option<&Path>) -> Result<Table> {
    text.parse()
        .map_err(|e: toml::de::Error| not_toml(path, text, &e))
}

/// The scene that a summary.json was made from.
fn of_summary(path: &Path, text: &str) -> Result<Table> {
    let value: serde_json::Value = serde_json::from_str(text).map_err(|e| not_json(path, &e))?;
    let missing = || FileError::NoSceneInSummary.in_file(path);
    let scene = value.get("scene").ok_or_else(missing)?;
    serde_json::from_value(scene.clone()).map_err(|_| missing())
}

/// The error of a text that is no JSON.
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

/// Puts the scene file's name before a key's.
fn name_file(path: Option<&Path>, mut e: Error) -> Error {
    if let (Some(path), Place::Key(key)) = (path, &e.place) {
        e.place = Place::Key(format!("{}: {key}", path.display()));
    }
    e
}
