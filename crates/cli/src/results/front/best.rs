//! Designs the best row of a sweep and writes its result.

use std::path::PathBuf;

use serde_json::Value;
use toml::Table;

use super::FrontArgs;
use super::read::Columns;
use crate::console::error::CliError;
use crate::input::SceneArgs;
use crate::sweep::with_ending;
use crate::synth::{self, SynthArgs};
use gaitcam::error::{FileError, Placed, Result};
use gaitcam::sweep::{Key, Point};
use gaitcam_app::blocks::PLAN;
use gaitcam_app::disk::Disk;
use gaitcam_app::folder::Folder;
use gaitcam_app::read::read_bytes;
use gaitcam_app::scene::{Input, not_json};

/// Designs the scene of the best row. The scene is rebuilt from the description of the sweep and the cells of the row.
pub(super) fn open_best(
    args: &FrontArgs,
    folder: &Folder,
    columns: &Columns,
    best: &Point,
) -> Result<u8> {
    let described = if args.file.is_dir() {
        args.file.join(PLAN)
    } else {
        with_ending(&args.file, ".sweep.json")
    };
    let bytes = read_bytes(&described)?;
    let sweep: Value = serde_json::from_slice(&bytes).map_err(|e| not_json(&described, &e))?;
    let scenes = sweep["scenes"].as_array().cloned().unwrap_or_default();
    let column = |name: &str| columns.names.iter().position(|n| n == name);
    let named = column("scene").map(|c| best.cells[c].clone());
    let scene = scenes
        .iter()
        .find(|s| named.as_deref().is_none_or(|n| s["name"] == n));
    let scene = scene.ok_or_else(|| CliError::NoBaseScene.in_file(&described))?;
    let mut table: Table =
        scene["text"]
            .as_str()
            .unwrap_or("")
            .parse()
            .map_err(|e: toml::de::Error| {
                let fault = e.message().to_string();
                FileError::NotToml { fault }.in_file(&described)
            })?;
    let inputs: Vec<(Key, &String)> = columns
        .inputs
        .iter()
        .map(|&c| (Key::of_column(&columns.names[c]), &best.cells[c]))
        .collect();
    for (key, cell) in inputs.iter().filter(|(k, _)| !k.is_number()) {
        key.write_words(&mut table, cell)?;
    }
    for (key, cell) in inputs.iter().filter(|(k, _)| k.is_number()) {
        let value = cell.parse().map_err(|_| {
            let (row, cell) = (best.row, (*cell).clone());
            CliError::RowNotNumber { row, cell }.in_file(&args.file)
        })?;
        key.write_number(&mut table, value)?;
    }
    let from = Disk {
        folder: scene["folder"].as_str().map(PathBuf::from),
    };
    let table = Input::new(table, from, None)?.resolved();
    let path = folder.path().join("best.toml");
    folder.write("best.toml", table.to_string().as_bytes())?;
    synth::run(&SynthArgs {
        scene: SceneArgs::of(path),
        out: Some(folder.path().join("best")),
        json: args.json,
        ..SynthArgs::default()
    })
}
