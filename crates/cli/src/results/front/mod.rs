//! `gaitcam front`: the best designs of a sweep's table, pictures of it, and the winner as a normal result.

mod objective;
mod page;
pub mod read;

use std::ops::Range;
use std::path::{Path, PathBuf};

use clap::Args;
use serde_json::{Value, json};
use toml::Table;

use crate::console::error::CliError;
use crate::console::exit_code::{BUILT, NO_SUCH_CAM};
use crate::console::table::{Side, table};
use crate::console::terminal::{print, print_json, report};
use crate::console::words;
use crate::input::SceneArgs;
use crate::sweep::with_ending;
use crate::synth::{self, SynthArgs};
use gaitcam::error::{FileError, Placed, Result};
use gaitcam::sweep::table::text_cell;
use gaitcam::sweep::{Admission, Front, Key, Objective, Point};
use gaitcam_app::blocks::{self, PLAN};
use gaitcam_app::folder::Folder;
use gaitcam_app::{read::read_bytes, scene::not_json};
use read::{Columns, Kept};

const EXAMPLES: &str = "Examples:
  gaitcam front strokes.csv
  gaitcam front grid.csv --minimise force_error,prime_radius,jerk --out out/grid
  gaitcam front grid.csv --minimise torque_max --maximise liftoff_speed
  gaitcam front walks.csv --best";

/// Which table, which objectives.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct FrontArgs {
    /// The table that `gaitcam sweep` wrote, or the folder of its blocks
    file: PathBuf,
    /// Columns to minimise, separated by commas: force_error,torque_max (default force_error,prime_radius)
    #[arg(long, value_name = "COLUMNS")]
    minimise: Option<String>,
    /// Columns to maximise, separated by commas: liftoff_speed
    #[arg(long, value_name = "COLUMNS")]
    maximise: Option<String>,
    /// Include designs that are not for high speed
    #[arg(long)]
    low_speed: bool,
    /// Also write the best design as a normal synth result, in DIR/best
    #[arg(long)]
    best: bool,
    /// Include every design, also those that are unacceptable
    #[arg(long)]
    all: bool,
    /// Folder for front.csv, pictures and report.html (default out/NAME-front)
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
}

/// Rows of the front that are printed and shown on the page.
const SHOWN: usize = 40;
/// Ranges of missing rows that are named.
const SHOWN_GAPS: usize = 6;

/// The designs of a table, judged by the objectives.
struct Evaluation {
    columns: Columns,
    objectives: Vec<Objective>,
    kept: Kept,
    /// Designs that are built, not for high speed, and left out for it.
    left_out: u64,
    /// Rows that the folder of blocks lacks.
    missing: Vec<Range<u64>>,
    front: Front,
}

/// Finds the front and writes its files; exit code 3 when no design of the table will do.
pub fn run(args: &FrontArgs) -> Result<u8> {
    let evaluated = gather(args)?;
    report_missing(&evaluated.missing);
    let Some(best) = evaluated.front.best().cloned() else {
        let key = if args.all {
            "front-none-built"
        } else {
            "front-none-feasible"
        };
        let file = args.file.display().to_string();
        report(words::fill(key, &json!({"file": file})));
        report_left_out(&evaluated);
        return Ok(NO_SUCH_CAM);
    };
    let sorted = evaluated.front.sorted();
    let folder = args.out.clone().unwrap_or_else(|| {
        let name = args
            .file
            .file_stem()
            .map(|s| s.to_string_lossy().into_owned());
        PathBuf::from("out").join(format!("{}-front", name.unwrap_or_default()))
    });
    let folder = Folder::open(&folder)?;
    folder.write("front.csv", csv(&evaluated.columns, &sorted).as_bytes())?;
    page::write(&args.file, &folder, &evaluated, &sorted, &best)?;
    if args.json && !args.best {
        print_json(&object(args, &evaluated, &sorted, &best));
    } else if !args.json {
        print(&text(args, &evaluated, &sorted, &best));
        report_left_out(&evaluated);
        print(&synth::files_in(folder.path(), "report.html"));
    }
    if args.best {
        return open_best(args, &folder, &evaluated.columns, &best);
    }
    Ok(BUILT)
}

/// Says which rows of a folder of blocks are not there.
fn report_missing(missing: &[Range<u64>]) {
    if missing.is_empty() {
        return;
    }
    let shown = missing.iter().take(SHOWN_GAPS);
    let mut list: Vec<String> = shown
        .map(|rows| match rows.end - rows.start {
            1 => rows.start.to_string(),
            _ => format!("{}–{}", rows.start, rows.end - 1),
        })
        .collect();
    if missing.len() > SHOWN_GAPS {
        list.push("…".to_string());
    }
    let count: u64 = missing.iter().map(|rows| rows.end - rows.start).sum();
    report(words::fill(
        "front-missing",
        &json!({"count": count, "list": list.join(", ")}),
    ));
}

/// Says how many designs do not count because they are not for high speed.
fn report_left_out(evaluated: &Evaluation) {
    if evaluated.left_out > 0 {
        let count = json!({"count": evaluated.left_out});
        report(words::fill("front-low-speed", &count));
    }
}

/// Reads the table once: the front, and enough rows for pictures.
fn gather(args: &FrontArgs) -> Result<Evaluation> {
    let mut front = Front::default();
    let mut objectives: Vec<Objective> = Vec::new();
    let mut kept = Kept::default();
    let mut left_out = 0;
    let admission = Admission {
        low_speed: args.low_speed,
        all: args.all,
    };
    let mut values = Vec::new();
    let columns = read::each_row(&args.file, |columns, row| {
        if objectives.is_empty() {
            objectives = objective::of_flags(
                args.minimise.as_deref(),
                args.maximise.as_deref(),
                &columns.names,
            )?;
        }
        values.clear();
        values.extend(objectives.iter().map(|o| o.cost(row.number(o.column))));
        let (outcome, verdict) = (row.word(columns.outcome), row.word(columns.verdict));
        left_out += u64::from(admission.leaves_out(&outcome, &verdict));
        let good = admission.takes(&outcome, &verdict);
        kept.take(columns, &objectives, &row, good);
        if good {
            front.offer(row.number(0) as u64, &values, || {
                (0..columns.names.len()).map(|c| row.word(c)).collect()
            });
        }
        Ok(())
    })?;
    if objectives.is_empty() {
        return Err(CliError::EmptyTable.in_file(&args.file));
    }
    let missing = match args.file.is_dir() {
        true => blocks::missing_rows(&args.file)?,
        false => Vec::new(),
    };
    Ok(Evaluation {
        columns,
        objectives,
        kept,
        left_out,
        missing,
        front,
    })
}

fn csv(columns: &Columns, front: &[&Point]) -> String {
    let mut writer = csv::Writer::from_writer(Vec::new());
    // Writing to memory cannot fail.
    let _ = writer.write_record(&columns.names);
    for p in front {
        let _ = writer.write_record(p.cells.iter().map(|c| text_cell(c).into_owned()));
    }
    writer
        .into_inner()
        .ok()
        .and_then(|b| String::from_utf8(b).ok())
        .unwrap_or_default()
}

/// The answer as JSON, SI.
fn object(args: &FrontArgs, evaluated: &Evaluation, front: &[&Point], best: &Point) -> Value {
    let named = |maximised: bool| -> Vec<&str> {
        let all = evaluated.objectives.iter();
        all.filter(|o| o.maximised == maximised)
            .map(|o| o.name.as_str())
            .collect()
    };
    let point = |p: &Point| {
        let mut out = json!({"row": p.row});
        for (objective, cost) in evaluated.objectives.iter().zip(&p.values) {
            out[&objective.name] = json!(objective.value(*cost));
        }
        out
    };
    let points: Vec<Value> = front.iter().map(|p| point(p)).collect();
    let missing = evaluated
        .missing
        .iter()
        .map(|rows| [rows.start, rows.end - 1]);
    json!({"file": args.file.display().to_string(), "rows": evaluated.kept.seen,
        "missing_rows": missing.collect::<Vec<_>>(),
        "candidates": evaluated.kept.candidates, "not_for_high_speed_left_out": evaluated.left_out,
        "minimise": named(false), "maximise": named(true), "front": points, "best": point(best)})
}

/// What a row is called: its recording where recordings vary, else its number.
fn row_name(columns: &Columns, point: &Point) -> String {
    let recording = columns.names.iter().position(|n| n == "gait.file");
    let file = recording.map(|c| Path::new(&point.cells[c]));
    match file.and_then(Path::file_name) {
        Some(name) => name.to_string_lossy().into_owned(),
        None => point.row.to_string(),
    }
}

fn text(args: &FrontArgs, evaluated: &Evaluation, front: &[&Point], best: &Point) -> String {
    let kept = &evaluated.kept;
    let mut out = vec![words::fill(
        "front-counts",
        &json!({"file": args.file.display().to_string(), "candidates": kept.candidates.to_string(),
            "seen": kept.seen.to_string(), "front": front.len().to_string()}),
    )];
    let labels = evaluated.objectives.iter().map(objective::label);
    let head = std::iter::once(words::text("front-row")).chain(labels);
    let mut rows = vec![head.chain([String::new()]).collect()];
    for p in front.iter().take(SHOWN) {
        let both = evaluated.objectives.iter().zip(&p.values);
        let values = both.map(|(o, cost)| objective::shown(o, *cost));
        let mark = match p.row == best.row {
            true => words::text("front-best"),
            false => String::new(),
        };
        let name = std::iter::once(row_name(&evaluated.columns, p));
        rows.push(name.chain(values).chain([mark]).collect());
    }
    out.push(table(&rows, &[Side::Right]));
    if front.len() > SHOWN {
        let more = json!({"count": front.len() - SHOWN, "row": best.row.to_string()});
        out.push(words::fill("front-more", &more));
    }
    out.join("\n")
}

/// Rebuilds the scene of a row from the sweep's description and the row's own cells, and designs it.
fn open_best(args: &FrontArgs, folder: &Folder, columns: &Columns, best: &Point) -> Result<u8> {
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
    absolute_file(
        &mut table,
        Path::new(scene["folder"].as_str().unwrap_or(".")),
    );
    let path = folder.path().join("best.toml");
    folder.write("best.toml", table.to_string().as_bytes())?;
    synth::run(&SynthArgs {
        scene: SceneArgs::of(path),
        out: Some(folder.path().join("best")),
        json: args.json,
        ..SynthArgs::default()
    })
}

/// Makes the recording's path absolute, since the new scene is in another folder.
fn absolute_file(table: &mut Table, folder: &Path) {
    let file = table.get_mut("gait").and_then(|g| g.get_mut("file"));
    if let Some(toml::Value::String(file)) = file {
        let in_folder = folder.join(&*file);
        let path = if in_folder.exists() {
            in_folder
        } else {
            PathBuf::from(&*file)
        };
        if let Ok(path) = path.canonicalize() {
            *file = path.to_string_lossy().into_owned();
        }
    }
}
