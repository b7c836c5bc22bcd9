//! Reading scenes and the force curves they name.

use std::fs;
use std::path::{Path, PathBuf};

use toml::Table;

use super::SceneArgs;
use gaitcam::error::{Error, Place, Result};
use gaitcam::force::{self, ForceCurve};
use gaitcam::scene::{self, Scene, Source};

/// A scene with the folder that its paths are relative to.
pub struct Input {
    /// The scene.
    pub scene: Scene,
    /// Its table after changes, for sweeps.
    pub table: Table,
    /// The folder that its paths are relative to.
    pub folder: PathBuf,
}

/// Reads the scene file (or the built-in scene) and applies the changes.
pub fn scene(args: &SceneArgs) -> Result<Input> {
    let (text, folder) = match &args.scene {
        None => (scene::DEFAULT.to_string(), PathBuf::from(".")),
        Some(path) => (
            read_text(path)?,
            path.parent().unwrap_or(Path::new(".")).to_path_buf(),
        ),
    };
    let json = args
        .scene
        .as_deref()
        .filter(|p| p.extension().is_some_and(|e| e == "json"));
    let mut table: Table = match json {
        Some(path) => of_summary(path, &text)?,
        None => text
            .parse()
            .map_err(|e: toml::de::Error| not_toml(args.scene.as_deref(), &text, &e))?,
    };
    for change in &args.set {
        scene::set(&mut table, change)?;
    }
    let scene = scene::read(&table).map_err(|e| name_file(args.scene.as_deref(), e))?;
    Ok(Input {
        scene,
        table,
        folder,
    })
}

/// The scene that a summary.json was made from.
fn of_summary(path: &Path, text: &str) -> Result<Table> {
    let value: serde_json::Value = serde_json::from_str(text)
        .map_err(|e| Error::line(path, e.line(), format!("is not JSON ({e})")))?;
    let missing = || {
        Error::file(path, "holds no scene").help("give a summary.json of gaitcam, or a scene file")
    };
    let scene = value.get("scene").ok_or_else(missing)?;
    serde_json::from_value(scene.clone()).map_err(|_| missing())
}

impl Input {
    /// The scene as it was settled, changes included, so that it means the same from any folder: paths
    /// are absolute.
    pub fn resolved(&self) -> Table {
        let mut table = self.table.clone();
        let file = self.scene.gait.as_ref().and_then(|g| match &g.source {
            Source::File { path, .. } => fs::canonicalize(find(&self.folder, path)).ok(),
            Source::Model { .. } => None,
        });
        let gait = table.get_mut("gait").and_then(toml::Value::as_table_mut);
        if let (Some(file), Some(gait)) = (file, gait) {
            let file = file.to_string_lossy().into_owned();
            gait.insert("file".to_string(), toml::Value::String(file));
        }
        table
    }

    /// The force curve that the scene names, if it names one.
    pub fn target(&self) -> Result<Option<ForceCurve>> {
        target(&self.scene, &self.folder)
    }
}

/// The force curve that a scene names, if it names one; its paths are relative to `folder` first.
pub fn target(scene: &Scene, folder: &Path) -> Result<Option<ForceCurve>> {
    let Some(gait) = &scene.gait else {
        return Ok(None);
    };
    match &gait.source {
        Source::Model {
            name,
            step_frequency_hz,
            body_weight_n,
        } => {
            let curve = force::model(name, *step_frequency_hz, *body_weight_n, gait.feet);
            curve
                .map(Some)
                .map_err(|e| e.at(Place::Key("gait.model".to_string())))
        }
        Source::File {
            path,
            time,
            force,
            unit,
            rate_hz,
            mass_kg,
        } => {
            let path = find(folder, path);
            let bytes = read_bytes(&path)?;
            let unit = unit
                .as_deref()
                .map(|u| {
                    u.parse()
                        .map_err(|e: Error| e.at(Place::Key("gait.unit".to_string())))
                })
                .transpose()?;
            let options = force::ReadOptions {
                time: time.clone(),
                force: force.clone(),
                unit,
                rate_hz: *rate_hz,
                mass_kg: *mass_kg,
                metadata: metadata(&path),
            };
            force::force_curve(&path, &bytes, &options, gait.feet).map(Some)
        }
    }
}

/// A path of a scene: beside the scene file if it is there, else from the working directory.
fn find(folder: &Path, path: &Path) -> PathBuf {
    let beside = folder.join(path);
    if beside.exists() {
        beside
    } else {
        path.to_path_buf()
    }
}

/// The table of subjects that lies beside a table of stances, if there is one.
pub fn metadata(path: &Path) -> Option<Vec<u8>> {
    fs::read(force::metadata_name(path)?).ok()
}

/// A whole file.
pub fn read_bytes(path: &Path) -> Result<Vec<u8>> {
    fs::read(path)
        .map_err(|e| Error::file(path, format!("cannot be read ({e})")).help("check the path"))
}

fn read_text(path: &Path) -> Result<String> {
    String::from_utf8(read_bytes(path)?).map_err(|e| {
        Error::byte(path, e.utf8_error().valid_up_to(), "is not UTF-8 text")
            .help("a scene is a TOML file, see scenes/")
    })
}

fn not_toml(path: Option<&Path>, text: &str, e: &toml::de::Error) -> Error {
    let line = e.span().map_or(1, |s| {
        text[..s.start.min(text.len())].matches('\n').count() + 1
    });
    let error =
        Error::new(e.message().replace('\n', ", ")).help("a scene is a TOML file, see scenes/");
    match path {
        Some(path) => error.at(Place::Line(path.to_path_buf(), line)),
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
