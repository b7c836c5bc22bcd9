//! `gaitcam cover`: finds the number of cams for a population, assigns a cam to each walker, and estimates the force error for other
//! walkers.

mod files;
mod shown;

use std::path::{Path, PathBuf};

use clap::Args;
use serde_json::{Value, json};

use crate::console::error::CliError;
use crate::console::exit_code::{BUILT, NO_SUCH_CAM};
use crate::console::terminal::{print, print_json, report};
use crate::console::words;
use crate::input::searching::TimeLimit;
use crate::input::{self, SceneArgs};
use crate::synth::files_in;
use files::write_scenes;
use gaitcam::cover::{covers, folds};
use gaitcam::error::{Placed, Result, SynthError};
use gaitcam::force::{ForceCurve, population_csv, read_population};
use gaitcam::scene::set_value;
use gaitcam::synth::Search;
use gaitcam_app::design::{MOST_CAMS as MOST, OF_COVER, of_cover};
use gaitcam_app::{Input, ResultFolder, inputs};
use gaitcam_output::cover_tables;
use shown::{fold_object, object, picture, text};
pub use shown::{of_unit, reason};

const EXAMPLES: &str = "Examples:
  gaitcam cover recordings/ --cams 1:6 --out out/cover
  gaitcam cover walkers.csv --cams 3 --set law.robust=worst
  gaitcam cover --set 'gait.step_frequency=1.4 Hz:2.4 Hz:21' --out out/bridges
  gaitcam gait new.c3d --against out/cover";

/// Name of the file with the force cycles of all walkers. Every cam is designed from this file.
const CYCLES: &str = "cycles.csv";

/// Arguments of `gaitcam cover`.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct CoverArgs {
    /// Folder of recordings, or a table of walkers (default: the walkers of the scene)
    #[arg(value_name = "FOLDER|TABLE")]
    walkers: Option<PathBuf>,
    /// First and last number of cams, or one number; the search always starts at 1
    #[arg(long, value_name = "LIST", default_value = "1:6")]
    cams: String,
    /// Scene with the machine, its limits and law.robust; default footbridge
    #[arg(long, value_name = "SCENE")]
    scene: Option<PathBuf>,
    /// Change a value: --set 'limits.stroke=40 mm' (may be repeated)
    #[arg(long = "set", value_name = "KEY=VALUE")]
    set: Vec<String>,
    #[command(flatten)]
    time: TimeLimit,
    /// Folder for tables, pictures and the scenes of the cams (default out/NAME_cover)
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
}

/// Finds the cams and writes their scenes, tables and picture. The exit code is 3 if a cam violates its limits.
pub fn run(args: &CoverArgs) -> Result<u8> {
    let numbers = numbers(&args.cams)?;
    let mut input = scene(args)?;
    let place = input::result_folder(&input, args.out.as_deref(), "_cover")?;
    if let Some(walkers) = &args.walkers {
        refuse_inside(&place, walkers)?;
    }
    inputs::check_in(&place, of_cover())?;
    let read = input.target()?.and_then(|force| force.population);
    let read = read.ok_or_else(|| SynthError::OneWalker.at_key("gait.file"))?;
    let table = population_csv(&read.walkers);
    let folder = ResultFolder::open(&place, args.time.patience())?;
    folder.write(CYCLES, table.as_bytes())?;
    // The walkers are read back from the written table, so that the written scenes lead to the same designs.
    let walkers = read_population(&place.join(CYCLES), table.as_bytes())?;
    let force = ForceCurve::of_walkers(walkers.clone())?;
    let limit = args.time.of_design();
    let search = Search::until(limit.clone());
    let shown = args.time.shown();
    let mut found = covers(&input.scene, &force, numbers.1, &search)?;
    let mut other = folds(&input.scene, &force, numbers.1, &search)?;
    drop(shown);
    let is_whole = found.len() >= numbers.1.min(force.population.map_or(0, |p| p.count()));
    found.retain(|c| c.cams.len() >= numbers.0);
    other.retain(|f| f.cams >= numbers.0);
    for cover in &found {
        write_scenes(&folder, &mut input, cover, &walkers)?;
    }
    let error = input.scene.law.error;
    let tables = [
        ("cover.csv", cover_tables::cover(&found, error)),
        ("assignment.csv", cover_tables::assignment(&found, error)),
        ("folds.csv", cover_tables::folds(&other, error)),
    ];
    for (name, table) in tables {
        folder.write(name, table.csv().as_bytes())?;
    }
    let picture = picture(&input, &found, &other);
    folder.write("cover.svg", picture.svg().as_bytes())?;
    folder.write("cover.png", &picture.png())?;
    let earlier = |name: &&str| place.join(OF_COVER[0]).is_file() && place.join(name).exists();
    folder.commit(&of_cover().filter(earlier).collect::<Vec<_>>())?;
    if args.json {
        let covers: Vec<Value> = found.iter().map(|c| object(c, error)).collect();
        let folds: Vec<Value> = other.iter().map(|f| fold_object(f, error)).collect();
        print_json(&json!({"covers": covers, "folds": folds}));
    } else {
        print(&text(&input, &found, &other));
        print(&files_in(&place, "cover.png"));
    }
    let is_cut = limit.was_heard();
    if !is_whole {
        report(words::text("cover-stopped"));
    } else if is_cut {
        report(words::text("cover-cut"));
    }
    let is_built = found
        .iter()
        .flat_map(|c| &c.cams)
        .all(|d| d.infeasible.is_none());
    Ok(if is_built && !is_cut {
        BUILT
    } else {
        NO_SUCH_CAM
    })
}

/// Minimum and maximum number of cams from the value of `--cams`, such as `1:6`. A single number, such as `3`, is both minimum and maximum.
///
/// # Errors
///
/// The text is not one number or two ascending whole numbers from 1 to [`MOST`].
fn numbers(typed: &str) -> Result<(usize, usize)> {
    let (first, last) = typed.split_once(':').unwrap_or((typed, typed));
    let number = |text: &str| text.trim().parse::<usize>().ok();
    let both = number(first).zip(number(last));
    let both = both.filter(|(first, last)| 0 < *first && first <= last && *last <= MOST);
    both.ok_or_else(|| {
        let (typed, most) = (typed.to_string(), MOST);
        CliError::Cams { typed, most }.at_argument("--cams")
    })
}

/// Scene of the command, with the recordings of the walkers as its target and with the changes of `--set`.
fn scene(args: &CoverArgs) -> Result<Input> {
    let scene = SceneArgs {
        scene: args.scene.clone(),
        set: Vec::new(),
    };
    let (mut table, folder, file) = input::written(&scene)?;
    if let Some(walkers) = &args.walkers {
        let walkers = std::path::absolute(walkers).unwrap_or_else(|_| walkers.clone());
        let walkers = toml::Value::String(walkers.display().to_string());
        set_value(&mut table, "gait.file", walkers)?;
    }
    for change in &args.set {
        gaitcam::scene::set(&mut table, change).map_err(input::at_flag("--set"))?;
    }
    Input::new(table, folder, file)
}

/// Rejects a results folder inside the folder of recordings, because the next run would read the results as recordings. A results folder
/// whose file of cycles would replace the table of walkers is also rejected.
fn refuse_inside(out: &Path, walkers: &Path) -> Result<()> {
    // The results folder need not exist yet.
    let whole = |path: &Path| {
        let path = std::path::absolute(path).ok()?;
        let known = |a: &Path| Some(a.canonicalize().ok()?.join(path.strip_prefix(a).ok()?));
        path.ancestors().find_map(known)
    };
    let both = whole(out).zip(whole(walkers));
    let is_inside =
        both.is_some_and(|(out, walkers)| out.starts_with(&walkers) || walkers == out.join(CYCLES));
    if is_inside {
        let folder = walkers.display().to_string();
        return Err(CliError::AmongRecordings { folder }.at_argument("--out"));
    }
    Ok(())
}
