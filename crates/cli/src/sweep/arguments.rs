//! Defines a sweep from the arguments: scenes, lists, recordings and varied keys.

use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use super::SweepArgs;
use crate::console::error::CliError;
use crate::console::{language, terminal, words};
use crate::input::recordings::recordings;
use crate::input::{self, SceneArgs};
use gaitcam::error::{Error, Place, Placed, Result, SweepError};
use gaitcam::scene;
use gaitcam::sweep::table::cell_text;
use gaitcam::sweep::{Axis, Key, NamedScene, Subject, Sweep};
use gaitcam_app::read::read_bytes;
use gaitcam_app::{Disk, SweepQuestion, Varied, completed, inputs};

/// Number of rows above which the user must confirm the sweep.
const MANY: u64 = 100_000_000;

/// Definition of a sweep, and the input files of its scenes.
pub struct SweepRequest {
    /// Scenes of the sweep, and varied keys with their values.
    pub question: SweepQuestion,
    /// Input files of each base scene.
    pub files: Vec<Disk>,
}

/// Reads the scenes, the list and the names of the recordings, and returns the definition of the sweep.
pub fn question(args: &SweepArgs) -> Result<SweepRequest> {
    let named: Vec<Option<&PathBuf>> = match &args.scenes[..] {
        [] => vec![None],
        scenes => scenes.iter().map(Some).collect(),
    };
    let given = recordings(&args.recordings, "--recordings")?;
    (given.files.iter()).for_each(|file| inputs::note(file.as_ref()));
    if let [first, ..] = &given.skipped[..] {
        let skipped = json!({"count": given.skipped.len(), "first": first});
        terminal::report(words::fill("sweep-skipped", &skipped));
    }
    let mut set = args.set.clone();
    if let Some(first) = given.files.first() {
        // The first recording completes scenes without a recording. In the rows, each recording in turn replaces it.
        set.push(format!("gait.file={}", toml::Value::from(first.as_str())));
    }
    let list = args.list.as_deref().map(list).transpose()?;
    let list = list.unwrap_or_default();
    let vary: Vec<Varied> = args.vary.iter().cloned().map(Varied::Text).collect();
    let varied = [&list[..], &vary].concat();
    let (mut scenes, mut files) = (Vec::new(), Vec::new());
    for file in named {
        let asked = SceneArgs {
            scene: file.cloned(),
            set: set.clone(),
        };
        let input = input::completed(&asked, |table| {
            completed(table, &varied, args.sample.is_some())
        })?;
        let mut scene = NamedScene::of(input.whole);
        // The shares of a sweep need names that are the same on every machine.
        if let (Some(file), None) = (file, args.shard) {
            scene.name = file.display().to_string();
        }
        scenes.push(scene);
        files.push(input.files);
    }
    let question = SweepQuestion {
        scenes,
        list,
        recordings: given.files,
        vary,
        sample: args.sample,
        method: args.method(),
        seed: args.seed,
        tolerances: args.tolerance.clone(),
    };
    Ok(SweepRequest { question, files })
}

/// Builds the sweep from the arguments. Also returns the input files of each base scene.
pub fn sweep(args: &SweepArgs) -> Result<(Sweep, Vec<Disk>)> {
    let SweepRequest { question, files } = question(args)?;
    let varies = [&question.vary, &question.list]
        .iter()
        .any(|v| !v.is_empty());
    if !varies && question.recordings.is_empty() && question.scenes.len() == 1 {
        return Err(CliError::NothingVaries.at_argument("--vary"));
    }
    let subject = question.subject().map_err(input::at_flag("--vary"))?;
    check_size(args, &subject)?;
    let fault = |e: Error| {
        let e = in_list(e, &question, args.list.as_deref());
        input::at_flag(flag_of(&e))(e)
    };
    let sweep = Sweep::new(subject, |index| &files[index]).map_err(fault)?;
    Ok((sweep, files))
}

/// Description of a sweep, including the folders of its scenes. An interrupted sweep can be continued only if the description is
/// unchanged.
pub fn description(sweep: &Sweep, files: &[Disk]) -> Value {
    let mut description = sweep.description();
    for (i, files) in files.iter().enumerate() {
        let folder = files.folder.as_deref().unwrap_or(Path::new("."));
        description["scenes"][i]["folder"] = json!(folder.display().to_string());
    }
    description
}

/// Rejects a number of rows that is impossible, or that is very large and not confirmed.
fn check_size(args: &SweepArgs, subject: &Subject) -> Result<()> {
    let rows = subject.rows().map_err(input::at_flag("--vary"))?;
    if rows > MANY && !args.yes && !args.estimate {
        let rows = rows.to_string();
        return Err(CliError::ManyRows { rows }.at_argument("--vary"));
    }
    Ok(())
}

/// Flag that caused an error of the whole sweep.
fn flag_of(e: &Error) -> &'static str {
    match e.fault() {
        Some(SweepError::NothingToSample) => "--sample",
        Some(SweepError::SobolAxes { .. }) => "--design",
        _ => "--vary",
    }
}

/// Varied keys from a CSV file, in which the header contains the keys and each line one combination of values.
fn list(path: &Path) -> Result<Vec<Varied>> {
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
    let columns = names.iter().zip(columns);
    columns
        .map(|(name, values)| of_list(path, name, values))
        .collect()
}

/// Varied key from one column of a list file. The error for an invalid value contains its line number.
fn of_list(path: &Path, name: &str, values: Vec<String>) -> Result<Varied> {
    let read = |values: &[String]| Axis::list(name, values.iter().map(String::as_str));
    if let Err(fault) = read(&values) {
        // First row whose value makes the list invalid.
        let bad = (0..values.len()).find(|&row| read(&values[..=row]).is_err());
        return Err(list_fault(path, bad.unwrap_or(0), name, &fault));
    }
    Ok(Varied::Listed(name.to_string(), values))
}

/// Error for an invalid row of a list file. Row 0 is the first row below the header.
fn list_fault(path: &Path, row: usize, name: &str, fault: &Error) -> Error {
    let what = fault.what(language::current());
    let fault = format!("{name}: {what}");
    CliError::ListValue { fault }.at_line(path, row + 2)
}

/// Adds the line number of the list file to an error of the sweep, if a value of the list causes the error.
fn in_list(fault: Error, question: &SweepQuestion, path: Option<&Path>) -> Error {
    let place_in_list = || {
        let Place::Key(name) = &fault.place else {
            return None;
        };
        let words = question.list.iter().find_map(|column| match column {
            Varied::Listed(key, words) if key == name => Some(words),
            _ => None,
        })?;
        let key = Key::words(name);
        let bad = |word: &String| {
            let mut table = question.scenes[0].table.clone();
            let written = key.write_words(&mut table, word);
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
