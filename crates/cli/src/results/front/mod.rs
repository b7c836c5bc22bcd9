//! `gaitcam front`: computes the Pareto front of a sweep table, draws pictures, and writes the best design as a result of `synth`.

mod best;
mod kept;
mod objective;
mod page;
pub mod read;
mod shown;

use std::ops::Range;
use std::path::PathBuf;

use clap::Args;
use serde_json::json;

use crate::console::error::CliError;
use crate::console::exit_code::{BUILT, NO_SUCH_CAM};
use crate::console::terminal::{print, print_json, report};
use crate::console::words;
use crate::synth;
use best::open_best;
use gaitcam::error::{Placed, Result};
use gaitcam::sweep::{Admission, Front, Objective};
use gaitcam_app::blocks;
use gaitcam_app::folder::Folder;
use kept::FrontSample;
use read::Columns;
use shown::{csv, object, text};

const EXAMPLES: &str = "Examples:
  gaitcam front strokes.csv
  gaitcam front grid.csv --minimise force_error,prime_radius,jerk --out out/grid
  gaitcam front grid.csv --minimise torque_max --maximise liftoff_speed
  gaitcam front walks.csv --best";

/// Arguments of `gaitcam front`.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct FrontArgs {
    /// Table of gaitcam sweep, or the folder of its blocks
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
    /// Also write the best design as a result of synth, in DIR/best
    #[arg(long)]
    best: bool,
    /// Include unacceptable designs
    #[arg(long)]
    all: bool,
    /// Folder for front.csv, pictures and report.html (default out/NAME-front)
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
}

/// Maximum number of front rows in the console output and on the page.
const SHOWN: usize = 40;
/// Maximum number of listed ranges of missing rows.
const SHOWN_GAPS: usize = 6;

/// Result of reading a table: its front, the sample for the pictures, and the omitted and missing rows.
struct Evaluation {
    columns: Columns,
    objectives: Vec<Objective>,
    kept: FrontSample,
    /// Number of designs omitted because they are not suitable for high speed.
    left_out: u64,
    /// Rows that are missing in the folder of blocks.
    missing: Vec<Range<u64>>,
    front: Front,
}

/// Computes the front and writes its files. The exit code is 3 if no design of the table is admissible.
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

/// Reports the missing rows of a folder of blocks.
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

/// Reports the number of designs omitted because they are not suitable for high speed.
fn report_left_out(evaluated: &Evaluation) {
    if evaluated.left_out > 0 {
        let count = json!({"count": evaluated.left_out});
        report(words::fill("front-low-speed", &count));
    }
}

/// Reads the table once. Computes the front and collects a sample of the rows for the pictures.
fn gather(args: &FrontArgs) -> Result<Evaluation> {
    let mut front = Front::default();
    let mut objectives: Vec<Objective> = Vec::new();
    let mut kept = FrontSample::default();
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
