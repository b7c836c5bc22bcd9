//! Opening and saving of scenes in the opened folder. A scene is saved under a new name, so that no file is replaced.

use std::path::Path;

use serde::Deserialize;
use serde_json::{Value, json};

use crate::Studio;
use gaitcam::error::{Placed, Result};
use gaitcam_app::page::fault::StudioError;
use gaitcam_app::page::{Named, table};

/// Text of a scene file in the opened folder, with its path.
///
/// # Errors
///
/// The file is outside the folder, or its text is not TOML.
pub fn open(studio: &Studio, path: &str) -> Result<Value> {
    let path = Path::new(path);
    let text = String::from_utf8_lossy(&studio.folder.read(path)?).into_owned();
    table(&text).map_err(|e| e.in_file(path))?;
    Ok(json!({"scene": text, "file": path.display().to_string()}))
}

/// Request to save a scene together with the dropped recording that the scene uses.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Save {
    /// TOML text of the scene.
    pub scene: String,
    /// Requested name of the scene file.
    pub name: String,
    /// Stored files, each with its name in the scene.
    #[serde(default)]
    pub files: Vec<Named>,
    /// Language of the error messages.
    #[serde(default)]
    pub language: String,
}

/// Saves a scene and, in the same folder, the dropped recording that the scene uses. Existing files are not replaced.
///
/// # Errors
///
/// A file name is invalid, or the folder is not writable.
pub fn save(studio: &Studio, save: &Save) -> Result<Value> {
    let mut table = table(&save.scene)?;
    // The name of the scene is checked before the recording is written.
    if save.name.trim().is_empty() {
        let name = save.name.clone();
        return Err(StudioError::FileName { name }.into());
    }
    let name = match save.name.ends_with(".toml") {
        true => save.name.clone(),
        false => format!("{}.toml", save.name),
    };
    studio.folder.check_name(&name)?;
    let file = table
        .get("gait")
        .and_then(|g| g.get("file"))
        .and_then(|f| f.as_str())
        .map(str::to_string);
    let mut written = Vec::new();
    let mut text = save.scene.clone();
    let named = |file: &str| save.files.iter().find(|n| n.name == file);
    if let Some(file) = file
        && let Some(bytes) = named(&file).and_then(|n| studio.engine.kept(&n.hash))
    {
        let name = studio.folder.write_new(&file, &bytes)?;
        if name != file
            && let Some(gait) = table.get_mut("gait").and_then(toml::Value::as_table_mut)
        {
            gait.insert("file".to_string(), name.clone().into());
            text = toml::to_string(&table).unwrap_or_default();
        }
        written.push(name);
    }
    written.push(studio.folder.write_new(&name, text.as_bytes())?);
    Ok(json!({"written": written, "scene": text}))
}
