//! `gaitcam front`: the best designs of a sweep's table, pictures of it, and the winner as a normal result.

mod read;

use std::path::{Path, PathBuf};

use clap::Args;
use serde_json::{Value, json};
use toml::Table;

use crate::error::CliError;
use crate::exit_code::{BUILT, NO_SUCH_CAM};
use crate::input::{SceneArgs, at_flag, files::read_bytes, not_json};
use crate::sweep::beside;
use crate::synth::{self, SynthArgs};
use crate::terminal::{print, print_json, report};
use crate::words;
use gaitcam::error::Result;
use gaitcam::sweep::table::label;
use gaitcam::sweep::{Front, Key, Point, objective};
use gaitcam_output::folder::Folder;
use gaitcam_output::sweep_plots::{self, Quantity};
use gaitcam_output::sweep_report;
use read::{Columns, Kept};

const EXAMPLES: &str = "Examples:
  gaitcam front strokes.csv
  gaitcam front grid.csv --minimise force_error,prime_radius,jerk --out out/grid
  gaitcam front walks.csv --best";

/// Which table, which objectives.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct FrontArgs {
    /// The table that `gaitcam sweep` wrote
    file: PathBuf,
    /// Columns to minimise, separated by commas: force_error,prime_radius[,jerk]
    #[arg(
        long,
        value_name = "COLUMNS",
        default_value = "force_error,prime_radius"
    )]
    minimise: String,
    /// Also write the best design as a normal synth result, in DIR/best
    #[arg(long)]
    best: bool,
    /// Include cams that fail a check
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

/// Finds the front and writes its files; exit code 3 when no design of the table will do.
pub fn run(args: &FrontArgs) -> Result<u8> {
    let mut front = Front::default();
    let (columns, objectives, kept) = gather(args, &mut front)?;
    let names: Vec<String> = objectives
        .iter()
        .map(|&o| columns.names[o].clone())
        .collect();
    let Some(best) = front.best().cloned() else {
        let key = if args.all {
            "front-none-built"
        } else {
            "front-none-feasible"
        };
        let file = args.file.display().to_string();
        report(words::fill(key, &json!({"file": file})));
        return Ok(NO_SUCH_CAM);
    };
    let sorted = front.sorted();
    let folder = args.out.clone().unwrap_or_else(|| {
        let name = args
            .file
            .file_stem()
            .map(|s| s.to_string_lossy().into_owned());
        PathBuf::from("out").join(format!("{}-front", name.unwrap_or_default()))
    });
    let folder = Folder::open(&folder)?;
    folder.write("front.csv", csv(&columns, &sorted).as_bytes())?;
    pictures(args, &folder, &columns, &objectives, &kept, &sorted, &best)?;
    if args.json && !args.best {
        let points: Vec<Value> = sorted.iter().map(|p| point_json(&names, p)).collect();
        let object = json!({"file": args.file.display().to_string(), "rows": kept.seen, "candidates": kept.candidates,
            "minimise": names, "front": points, "best": point_json(&names, &best)});
        print_json(&object);
    } else if !args.json {
        print(&text(args, &kept, &columns, &names, &sorted, &best));
        print(&synth::files_in(folder.path(), "report.html"));
    }
    if args.best {
        return open_best(args, &folder, &columns, &best);
    }
    Ok(BUILT)
}

/// Reads the table once: the front, and enough rows for pictures.
fn gather(args: &FrontArgs, front: &mut Front) -> Result<(Columns, Vec<usize>, Kept)> {
    let mut objectives: Vec<usize> = Vec::new();
    let mut kept = Kept::default();
    let mut values = Vec::new();
    let columns = read::each_row(&args.file, |columns, row| {
        if objectives.is_empty() {
            objectives = args
                .minimise
                .split(',')
                .map(|name| objective(name, &columns.names).map_err(at_flag("--minimise")))
                .collect::<Result<_>>()?;
        }
        values.clear();
        values.extend(objectives.iter().map(|&o| row.number(o)));
        let good = row.word(columns.outcome) == "built"
            && (args.all
                || row.word(columns.failed).is_empty()
                    && row.word(columns.verdict) != "unacceptable");
        kept.take(columns, &objectives, &row, good);
        if good {
            front.offer(row.number(0) as u64, &values, || {
                (0..columns.names.len()).map(|c| row.word(c)).collect()
            });
        }
        Ok(())
    })?;
    if objectives.is_empty() {
        return Err(CliError::EmptyTable.file(&args.file));
    }
    Ok((columns, objectives, kept))
}

fn csv(columns: &Columns, front: &[&Point]) -> String {
    let mut writer = csv::Writer::from_writer(Vec::new());
    // Writing to memory cannot fail.
    let _ = writer.write_record(&columns.names);
    for p in front {
        let _ = writer.write_record(&p.cells);
    }
    writer
        .into_inner()
        .ok()
        .and_then(|b| String::from_utf8(b).ok())
        .unwrap_or_default()
}

fn point_json(names: &[String], p: &Point) -> Value {
    let mut out = json!({"row": p.row});
    for (name, value) in names.iter().zip(&p.values) {
        out[name] = json!(value);
    }
    out
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

fn text(
    args: &FrontArgs,
    kept: &Kept,
    columns: &Columns,
    names: &[String],
    front: &[&Point],
    best: &Point,
) -> String {
    let mut out = vec![words::fill(
        "front-counts",
        &json!({"file": args.file.display().to_string(), "candidates": kept.candidates.to_string(),
            "seen": kept.seen.to_string(), "front": front.len().to_string()}),
    )];
    let head: Vec<String> = names.iter().map(|n| format!("{n:>24}")).collect();
    let called: Vec<String> = front.iter().map(|p| row_name(columns, p)).collect();
    let shown = called.iter().take(SHOWN);
    let wide = shown.map(|n| n.chars().count()).max().unwrap_or(0).max(12);
    out.push(format!(
        "{:>wide$} {}",
        words::text("front-row"),
        head.join(" ")
    ));
    for (p, name) in front.iter().zip(&called).take(SHOWN) {
        let values: Vec<String> = p.values.iter().map(|v| format!("{v:>24.6}")).collect();
        let mark = if p.row == best.row {
            format!("  {}", words::text("front-best"))
        } else {
            String::new()
        };
        out.push(format!("{name:>wide$} {}{mark}", values.join(" ")));
    }
    if front.len() > SHOWN {
        let more = json!({"count": front.len() - SHOWN, "row": best.row.to_string()});
        out.push(words::fill("front-more", &more));
    }
    out.join("\n")
}

/// Lines and dots that a picture can show apart.
const DRAWN: usize = 3000;

/// Every k-th value, so that a picture stays light.
fn fewer(mut q: Quantity) -> Quantity {
    let step = q.values.len().div_ceil(DRAWN).max(1);
    q.values = q.values.into_iter().step_by(step).collect();
    q
}

/// Heat map for two parameters, parallel coordinates for more, the front for two objectives, and the page.
fn pictures(
    args: &FrontArgs,
    folder: &Folder,
    columns: &Columns,
    objectives: &[usize],
    kept: &Kept,
    front: &[&Point],
    best: &Point,
) -> Result<()> {
    let name = args
        .file
        .file_name()
        .map_or_else(String::new, |n| n.to_string_lossy().into_owned());
    let mut drawn = Vec::new();
    let varied: Vec<usize> = (0..kept.inputs.len())
        .filter(|&k| kept.inputs[k].varies())
        .collect();
    let inputs: Vec<Quantity> = varied.iter().map(|&k| kept.inputs[k].quantity()).collect();
    let goals: Vec<Quantity> = kept
        .goals
        .iter()
        .zip(objectives)
        .map(|(v, &o)| Quantity {
            label: label(&columns.names[o]),
            values: v.clone(),
            words: Vec::new(),
        })
        .collect();
    if goals.len() > 1 {
        let points: Vec<(f64, f64)> = front.iter().map(|p| (p.values[0], p.values[1])).collect();
        let at = Some((best.values[0], best.values[1]));
        drawn.push((
            "front",
            "Front",
            sweep_plots::front(
                &format!("{name}: front"),
                &fewer(goals[0].clone()),
                &fewer(goals[1].clone()),
                &points,
                at,
            ),
        ));
    }
    if let ([x, y], Some(z)) = (&inputs[..], goals.first()) {
        drawn.push((
            "heat",
            "Heat map",
            sweep_plots::heat_map(&format!("{name}: least {}", z.label), x, y, z),
        ));
    }
    if inputs.len() + goals.len() > 1 {
        let mut all: Vec<Quantity> = inputs.into_iter().chain(goals).map(fewer).collect();
        // The front goes last, so that every point of it has its line.
        let start = all[0].values.len();
        for p in front {
            for (k, q) in varied.iter().zip(&mut all) {
                q.values
                    .push(kept.inputs[*k].place(&p.cells[kept.inputs[*k].column]));
            }
            for (v, q) in p.values.iter().zip(&mut all[varied.len()..]) {
                q.values.push(*v);
            }
        }
        let lines: Vec<usize> = (start..start + front.len()).collect();
        let winner = front
            .iter()
            .position(|p| p.row == best.row)
            .map(|i| start + i);
        drawn.push((
            "parallel",
            "Parallel coordinates",
            sweep_plots::parallel(
                &format!("{name}: designs, front in blue"),
                &all,
                &lines,
                winner,
            ),
        ));
    }
    for (file, _, picture) in &drawn {
        folder.write(&format!("{file}.svg"), picture.svg().as_bytes())?;
        folder.write(&format!("{file}.png"), &picture.png())?;
    }
    let short = |p: &Point| {
        p.values
            .iter()
            .map(|v| format!("{v:.6}"))
            .collect::<Vec<_>>()
    };
    let head = |first: &str| -> Vec<String> {
        std::iter::once(first.to_string())
            .chain(objectives.iter().map(|&o| label(&columns.names[o])))
            .collect()
    };
    let rows = front.iter().take(SHOWN).map(|p| {
        std::iter::once(row_name(columns, p))
            .chain(short(p))
            .collect()
    });
    let page = sweep_report::Page {
        title: format!("Sweep {name}"),
        words: format!(
            "{} designs, {} of them feasible; {} are non-dominated in {}. The best compromise is row {}.",
            kept.seen,
            kept.candidates,
            front.len(),
            objectives
                .iter()
                .map(|&o| label(&columns.names[o]))
                .collect::<Vec<_>>()
                .join(" and "),
            best.row
        ),
        cards: objectives
            .iter()
            .zip(&best.values)
            .map(|(&o, v)| {
                (
                    label(&columns.names[o]),
                    format!("{v:.6}"),
                    "best compromise".to_string(),
                )
            })
            .collect(),
        pictures: drawn
            .iter()
            .map(|(_, heading, picture)| (*heading, picture))
            .collect(),
        tables: vec![
            (
                "The front",
                sweep_report::Table {
                    head: head("row"),
                    rows: rows.collect(),
                },
            ),
            (
                "The best compromise",
                sweep_report::Table {
                    head: vec!["column".to_string(), "value".to_string()],
                    rows: columns
                        .names
                        .iter()
                        .zip(&best.cells)
                        .map(|(a, b)| vec![a.clone(), b.clone()])
                        .collect(),
                },
            ),
        ],
    };
    folder.write(
        "report.html",
        sweep_report::html(&page, crate::language::current()).as_bytes(),
    )
}

/// Rebuilds the scene of a row from the sweep's description and the row's own cells, and designs it.
fn open_best(args: &FrontArgs, folder: &Folder, columns: &Columns, best: &Point) -> Result<u8> {
    let described = beside(&args.file, ".sweep.json");
    let bytes = read_bytes(&described)?;
    let sweep: Value = serde_json::from_slice(&bytes).map_err(|e| not_json(&described, &e))?;
    let scenes = sweep["scenes"].as_array().cloned().unwrap_or_default();
    let column = |name: &str| columns.names.iter().position(|n| n == name);
    let named = column("scene").map(|c| best.cells[c].clone());
    let scene = scenes
        .iter()
        .find(|s| named.as_deref().is_none_or(|n| s["name"] == n));
    let scene = scene.ok_or_else(|| CliError::NoBaseScene.file(&described))?;
    let mut table: Table =
        scene["text"]
            .as_str()
            .unwrap_or("")
            .parse()
            .map_err(|e: toml::de::Error| {
                let fault = e.message().to_string();
                CliError::NotToml { fault }.file(&described)
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
            CliError::RowNotNumber { row, cell }.file(&args.file)
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
        scene: SceneArgs {
            scene: Some(path),
            set: Vec::new(),
        },
        out: Some(folder.path().join("best")),
        json: args.json,
        ..SynthArgs::default()
    })
}

/// The recording's path as it is found from here, since the new scene stands elsewhere.
fn absolute_file(table: &mut Table, folder: &Path) {
    let file = table.get_mut("gait").and_then(|g| g.get_mut("file"));
    if let Some(toml::Value::String(file)) = file {
        let beside = folder.join(&*file);
        let found = if beside.exists() {
            beside
        } else {
            PathBuf::from(&*file)
        };
        if let Ok(path) = found.canonicalize() {
            *file = path.to_string_lossy().into_owned();
        }
    }
}
