//! From arguments to a plan: scenes, lists, recordings, and the force curves that rows name.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use serde_json::{Value, json};

use super::SweepArgs;
use crate::console::error::CliError;
use crate::console::language;
use crate::input::recordings::{Recordings, recordings};
use crate::input::{self, SceneArgs};
use gaitcam::error::{Error, Place, Placed, Result};
use gaitcam::force::ForceCurve;
use gaitcam::scene::{self, Scene};
use gaitcam::sweep::table::cell_text;
use gaitcam::sweep::{Axis, Key, List, NamedScene, Plan, Sampling, Values};
use gaitcam_app::read::read_bytes;
use gaitcam_app::{Disk, inputs};

/// A plan with the files of its scenes.
pub struct Sweep {
    /// The plan.
    pub plan: Plan,
    /// The files of each base scene.
    pub files: Vec<Disk>,
    /// Files in the folders of recordings that are none.
    pub skipped: Vec<String>,
}

/// Reads scenes, list and axes.
pub fn plan(args: &SweepArgs) -> Result<Sweep> {
    let files: Vec<Option<&PathBuf>> = match &args.scenes[..] {
        [] => vec![None],
        scenes => scenes.iter().map(Some).collect(),
    };
    let mut scenes = Vec::new();
    let mut disks = Vec::new();
    let Recordings {
        files: records,
        skipped,
    } = recordings(&args.recordings, "--recordings")?;
    records.iter().for_each(|file| inputs::note(file.as_ref()));
    let mut set = args.set.clone();
    if let Some(first) = records.first() {
        // A scene that leaves its recording to the command line is whole with any of them.
        set.push(format!("gait.file={}", toml::Value::from(first.as_str())));
    }
    for file in files {
        let input = input::scene(&SceneArgs {
            scene: file.cloned(),
            set: set.clone(),
        })?;
        scenes.push(NamedScene {
            name: file.map_or(input.scene.name.clone(), |f| f.display().to_string()),
            table: input.whole,
        });
        disks.push(input.files);
    }
    let mut axes = Vec::new();
    if !records.is_empty() {
        axes.push(Axis {
            key: Key::words("gait.file"),
            values: Values::Words(records.into_iter().map(Arc::from).collect()),
        });
    }
    for text in &args.vary {
        axes.push(Axis::parse(text, args.sample.is_some()).map_err(input::at_flag("--vary"))?);
    }
    let sampling = match args.sample {
        None => Sampling::Grid,
        Some(count) => Sampling::Sample {
            method: args.method(),
            count,
            seed: args.seed,
        },
    };
    let list = args.list.as_deref().map(list).transpose()?;
    if axes.is_empty() && list.is_none() && scenes.len() == 1 {
        return Err(CliError::NothingVaries.at_argument("--vary"));
    }
    Ok(Sweep {
        plan: Plan {
            scenes,
            list,
            axes,
            sampling,
        },
        files: disks,
        skipped,
    })
}

/// What a sweep that is resumed must agree with: the plan, and the program, since another version may design otherwise.
pub fn description(sweep: &Sweep) -> Value {
    let mut description = sweep.plan.description();
    for (i, files) in sweep.files.iter().enumerate() {
        let folder = files.folder.as_deref().unwrap_or(Path::new("."));
        description["scenes"][i]["folder"] = json!(folder.display().to_string());
    }
    description["version"] = json!(env!("CARGO_PKG_VERSION"));
    description
}

/// Rows of a csv whose header names keys.
fn list(path: &Path) -> Result<List> {
    let bytes = read_bytes(path)?;
    let mut reader = csv::ReaderBuilder::new()
        .trim(csv::Trim::All)
        .from_reader(&bytes[..]);
    let fault = input::not_csv(path);
    let names = reader.headers().map_err(&fault)?.clone();
    let mut columns: Vec<Vec<String>> = vec![Vec::new(); names.len()];
    for record in reader.records() {
        let record = record.map_err(&fault)?;
        for (column, cell) in columns.iter_mut().zip(&record) {
            if cell.is_empty() {
                let line = record.position().map_or(1, |p| p.line() as usize);
                return Err(CliError::ListCell.at_line(path, line));
            }
            column.push(cell_text(cell).to_string());
        }
    }
    if columns.first().is_none_or(Vec::is_empty) {
        return Err(CliError::EmptyList.in_file(path));
    }
    let columns = names
        .iter()
        .zip(&columns)
        .map(|(name, values)| of_list(path, name, values))
        .collect::<Result<Vec<Axis>>>()?;
    Ok(List { columns })
}

/// A column of a list; the error of an invalid value names its line.
fn of_list(path: &Path, name: &str, values: &[String]) -> Result<Axis> {
    let read = |values: &[String]| Axis::list(name, values.iter().map(String::as_str));
    read(values).map_err(|fault| {
        // The first row that makes the rows above it wrong.
        let bad = (0..values.len()).find(|&row| read(&values[..=row]).is_err());
        list_fault(path, bad.unwrap_or(0), name, &fault)
    })
}

/// A fault of a row of a list, counted from 0 below the header.
fn list_fault(path: &Path, row: usize, name: &str, fault: &Error) -> Error {
    let what = fault.what(language::current());
    let fault = format!("{name}: {what}");
    CliError::ListValue { fault }.at_line(path, row + 2)
}

/// A fault of the plan, at the line of the list that has it where one has.
pub fn in_list(fault: Error, plan: &Plan, path: Option<&Path>) -> Error {
    let place_in_list = || {
        let Place::Key(name) = &fault.place else {
            return None;
        };
        let columns = &plan.list.as_ref()?.columns;
        let axis = columns.iter().find(|a| a.key.name() == name)?;
        let Values::Words(words) = &axis.values else {
            return None;
        };
        let bad = |word: &Arc<str>| {
            let mut table = plan.scenes[0].table.clone();
            let written = axis.key.write_words(&mut table, word);
            let read = written.and_then(|()| scene::read(&table));
            read.is_err_and(|e| e.placed(fault.place.clone()) == fault)
        };
        Some((path?, words.iter().position(bad)?, name))
    };
    match place_in_list() {
        Some((path, row, name)) => list_fault(path, row, name, &fault),
        None => fault,
    }
}

/// Reads the force curves that scenes name.
pub fn targets(files: &[Disk]) -> impl Fn(usize, &Scene) -> Result<ForceCurve> + Sync {
    |index, scene| {
        let gait = scene.gait.as_ref();
        let curve = gait.map(|gait| gait.force(&files[index])).transpose()?;
        curve
            .flatten()
            .ok_or_else(|| CliError::NoCurve.at_key("gait"))
    }
}
