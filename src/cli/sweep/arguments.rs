//! From arguments to a plan: scenes, lists, recordings, and the force curves that rows name.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

use serde_json::{Value, json};

use super::SweepArgs;
use crate::cli::{SceneArgs, input};
use crate::error::{Error, Place, Result};
use crate::gait::ForceCurve;
use crate::scene::Scene;
use crate::sweep::{Axis, Design, Key, List, NamedScene, Plan, Values};

/// A plan with the folders that the paths of its scenes are relative to.
pub struct Sweep {
    /// The plan.
    pub plan: Plan,
    /// One folder per base scene.
    pub folders: Vec<PathBuf>,
}

/// Force curves of recordings kept in memory.
const KEPT_CURVES: usize = 256;

/// Reads scenes, list and axes.
pub fn plan(args: &SweepArgs) -> Result<Sweep> {
    let files: Vec<Option<&PathBuf>> = if args.scenes.is_empty() {
        vec![None]
    } else {
        args.scenes.iter().map(Some).collect()
    };
    let mut scenes = Vec::new();
    let mut folders = Vec::new();
    for file in files {
        let input = input::scene(&SceneArgs {
            scene: file.cloned(),
            set: args.set.clone(),
        })?;
        scenes.push(NamedScene {
            name: file.map_or(input.scene.name.clone(), |f| f.display().to_string()),
            table: input.table,
        });
        folders.push(input.folder);
    }
    let mut axes = Vec::new();
    if !args.recordings.is_empty() {
        axes.push(recordings(&args.recordings)?);
    }
    for text in &args.vary {
        axes.push(Axis::parse(text, args.sample.is_some())?);
    }
    let design = match args.sample {
        None => Design::Grid,
        Some(count) => Design::Sample {
            method: args.method(),
            count,
            seed: args.seed,
        },
    };
    let list = args.list.as_deref().map(list).transpose()?;
    if axes.is_empty() && list.is_none() && scenes.len() == 1 {
        return Err(Error::argument("--vary", "an empty grid: nothing varies")
            .help("write --vary 'limits.stroke=20 mm:60 mm:5', --list FILE.csv or --recordings FOLDER"));
    }
    Ok(Sweep {
        plan: Plan {
            scenes,
            list,
            axes,
            design,
        },
        folders,
    })
}

/// What a journal must agree with: the plan, and the program, since another version may design otherwise.
pub fn description(sweep: &Sweep) -> Value {
    let mut description = sweep.plan.description();
    for (i, folder) in sweep.folders.iter().enumerate() {
        description["scenes"][i]["folder"] = json!(folder.display().to_string());
    }
    description["version"] = json!(env!("CARGO_PKG_VERSION"));
    description
}

/// Rows of a csv whose header names keys.
fn list(path: &Path) -> Result<List> {
    let bytes = input::read_bytes(path)?;
    let mut reader = csv::ReaderBuilder::new()
        .trim(csv::Trim::All)
        .from_reader(&bytes[..]);
    let fault = |e: csv::Error| {
        let line = e.position().map_or(1, |p| p.line() as usize);
        Error::line(path, line, e.to_string())
    };
    let names = reader.headers().map_err(fault)?.clone();
    let mut columns: Vec<Vec<String>> = vec![Vec::new(); names.len()];
    for record in reader.records() {
        let record = record.map_err(fault)?;
        for (column, cell) in columns.iter_mut().zip(&record) {
            if cell.is_empty() {
                let line = record.position().map_or(1, |p| p.line() as usize);
                return Err(
                    Error::line(path, line, "a value is missing").help("every row needs every key")
                );
            }
            column.push(cell.to_string());
        }
    }
    if columns.first().is_none_or(Vec::is_empty) {
        return Err(Error::file(path, "an empty grid: there is no row")
            .help("the first line names keys, each further line gives their values"));
    }
    let columns = names
        .iter()
        .zip(&columns)
        .map(|(name, values)| Axis::list(name, values.iter().map(String::as_str)))
        .collect::<Result<Vec<Axis>>>()
        .map_err(|e| Error::file(path, e.to_string()))?;
    Ok(List { columns })
}

/// Every file given or inside a folder given, in the order of names; hidden ones are left out.
fn recordings(paths: &[PathBuf]) -> Result<Axis> {
    let mut files = Vec::new();
    for path in paths {
        collect(path, &mut files)?;
    }
    if files.is_empty() {
        return Err(Error::argument(
            "--recordings",
            "an empty grid: there is no file",
        ));
    }
    Ok(Axis {
        key: Key::words("gait.file"),
        values: Values::Words(files.into_iter().map(Arc::from).collect()),
    })
}

fn collect(path: &Path, files: &mut Vec<String>) -> Result<()> {
    let fault = |e: std::io::Error| {
        Error::file(path, format!("cannot be read ({e})")).help("check the path")
    };
    let about = std::fs::metadata(path).map_err(fault)?;
    if about.is_file() {
        files.push(path.to_string_lossy().into_owned());
        return Ok(());
    }
    let mut inside = std::fs::read_dir(path)
        .map_err(fault)?
        .map(|entry| entry.map(|e| e.path()))
        .collect::<std::io::Result<Vec<PathBuf>>>()
        .map_err(fault)?;
    inside.sort();
    let hidden = |p: &Path| {
        p.file_name()
            .is_some_and(|n| n.to_string_lossy().starts_with('.'))
    };
    for path in inside.iter().filter(|p| !hidden(p)) {
        collect(path, files)?;
    }
    Ok(())
}

/// Reads the force curves that scenes name, each once while it is in use.
pub fn targets(folders: &[PathBuf]) -> impl Fn(usize, &Scene) -> Result<ForceCurve> + Sync {
    let kept: Mutex<HashMap<String, Result<ForceCurve>>> = Mutex::new(HashMap::new());
    move |index, scene| {
        let name = format!("{index} {:?}", scene.gait);
        if let Some(curve) = kept.lock().ok().and_then(|k| k.get(&name).cloned()) {
            return curve;
        }
        let folder = folders.get(index).map_or(Path::new("."), PathBuf::as_path);
        let curve = input::target(scene, folder).and_then(|curve| {
            curve.ok_or_else(|| {
                Error::new("there is no force curve").at(Place::Key("gait".to_string()))
            })
        });
        if let Ok(mut kept) = kept.lock() {
            if kept.len() >= KEPT_CURVES {
                kept.clear();
            }
            kept.insert(name, curve.clone());
        }
        curve
    }
}
