//! Scenes as the command line gives them: a file, standard input or the built-in scene, with changes.

pub mod files;
pub mod target;

use std::fs;
use std::path::{Path, PathBuf};

use clap::Args;
use toml::Table;

use crate::error::{CliError, NameFault};
use gaitcam::error::{Error, Place, Result};
use gaitcam::force::ForceCurve;
use gaitcam::scene::{self, Scene, Source};
use gaitcam::units::{Dimension, parse};

/// A scene with changes.
#[derive(Args, Debug, Default, Clone)]
pub struct SceneArgs {
    /// Scene file, name of a built-in scene (gaitcam scenes), or - for standard input; default footbridge
    pub scene: Option<PathBuf>,
    /// Change a value: --set 'limits.stroke=40 mm' (may be repeated)
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub set: Vec<String>,
}

/// A scene with the folder that its paths are relative to.
pub struct Input {
    /// The scene.
    pub scene: Scene,
    /// Its table after changes, for sweeps.
    pub table: Table,
    /// The folder that its paths are relative to.
    pub folder: PathBuf,
    /// The file that it was read from.
    pub file: Option<PathBuf>,
}

/// Reads the scene (or the built-in one) and applies the changes.
pub fn scene(args: &SceneArgs) -> Result<Input> {
    let file = args.scene.as_deref().filter(|p| *p != Path::new("-"));
    let (text, folder) = match (&args.scene, file) {
        (None, _) => (scene::DEFAULT.to_string(), Path::new(".")),
        (Some(_), None) => (files::read_standard_input()?, Path::new(".")),
        (_, Some(path)) if !path.exists() && built_in(path).is_some() => {
            (built_in(path).unwrap_or("").to_string(), Path::new("."))
        }
        (_, Some(path)) => (
            files::read_text(path)?,
            path.parent().unwrap_or(Path::new(".")),
        ),
    };
    let json = file.filter(|p| p.extension().is_some_and(|e| e == "json"));
    let mut table: Table = match json {
        Some(path) => of_summary(path, &text)?,
        None => text
            .parse()
            .map_err(|e: toml::de::Error| not_toml(file, &text, &e))?,
    };
    for change in &args.set {
        scene::set(&mut table, change).map_err(at_flag("--set"))?;
    }
    let scene = scene::read(&table).map_err(|e| name_file(file, e))?;
    Ok(Input {
        scene,
        table,
        folder: folder.to_path_buf(),
        file: file.map(Path::to_path_buf),
    })
}

/// The built-in scene that a path names.
fn built_in(path: &Path) -> Option<&'static str> {
    let found = scene::built_in(path.to_str()?).ok()?;
    Some(found.toml)
}

/// Places a fault at a flag, unless it is placed already.
pub fn at_flag(flag: &str) -> impl Fn(Error) -> Error {
    move |e| e.at(Place::Argument(flag.to_string()))
}

/// The value of a flag with a unit, where the flag is given.
pub fn quantity(flag: &str, text: Option<&str>, dimension: Dimension) -> Result<Option<f64>> {
    text.map(|t| parse(t, dimension).map_err(at_flag(flag)))
        .transpose()
}

impl Input {
    /// The scene as it was settled, changes included, so that it means the same from any folder: paths
    /// are absolute.
    pub fn resolved(&self) -> Table {
        let mut table = self.table.clone();
        let file = self
            .recording()
            .and_then(|path| fs::canonicalize(path).ok());
        let gait = table.get_mut("gait").and_then(toml::Value::as_table_mut);
        if let (Some(file), Some(gait)) = (file, gait) {
            let file = file.to_string_lossy().into_owned();
            gait.insert("file".to_string(), toml::Value::String(file));
        }
        table
    }

    /// The recording that the scene names, if it names one.
    pub fn recording(&self) -> Option<PathBuf> {
        match &self.scene.gait.as_ref()?.source {
            Source::File(path) => Some(target::find(&self.folder, path)),
            Source::Model(_) => None,
        }
    }

    /// The force curve that the scene names, if it names one.
    pub fn target(&self) -> Result<Option<ForceCurve>> {
        target::target(&self.scene, &self.folder)
    }

    /// Where results go: `out` as given, else `out/NAME` with `ending` after the scene's name.
    pub fn result_folder(&self, out: Option<&Path>, ending: &str) -> Result<PathBuf> {
        if let Some(out) = out {
            return Ok(out.to_path_buf());
        }
        let name = &self.scene.name;
        check_file_name(name)?;
        Ok(PathBuf::from("out").join(format!("{name}{ending}")))
    }
}

/// Refuses a scene's name that is no plain file name.
fn check_file_name(name: &str) -> Result<()> {
    let fault = if name.trim().is_empty() {
        NameFault::Blank
    } else if name.starts_with('-') {
        NameFault::Dash
    } else if name.chars().any(|c| c.is_control() || is_invisible(c)) {
        NameFault::Control
    } else if name == "." || name == ".." || name.chars().any(|c| "/\\:*?\"<>|~".contains(c)) {
        NameFault::NotPlain
    } else {
        return Ok(());
    };
    let shown: String = name.escape_debug().take(60).collect();
    Err(CliError::SceneName { shown, fault }.key("name"))
}

/// Marks that turn the direction of text or take no room (Unicode bidirectional controls and their like).
fn is_invisible(c: char) -> bool {
    matches!(c, '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}')
}

/// The scene that a summary.json was made from.
fn of_summary(path: &Path, text: &str) -> Result<Table> {
    let value: serde_json::Value = serde_json::from_str(text).map_err(|e| not_json(path, &e))?;
    let missing = || CliError::NoSceneInSummary.file(path);
    let scene = value.get("scene").ok_or_else(missing)?;
    serde_json::from_value(scene.clone()).map_err(|_| missing())
}

/// The error of a text that is no JSON.
pub fn not_json(path: &Path, e: &serde_json::Error) -> Error {
    let fault = e.to_string();
    CliError::NotJson { fault }.line(path, e.line())
}

fn not_toml(path: Option<&Path>, text: &str, e: &toml::de::Error) -> Error {
    let line = e.span().map_or(1, |s| {
        text[..s.start.min(text.len())].matches('\n').count() + 1
    });
    let fault = e.message().replace('\n', ", ");
    let error = Error::from(CliError::NotToml { fault });
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
