//! `gaitcam cover`: how many cams serve a population, which of them serves whom, and how well they serve others.

use std::path::{Path, PathBuf};

use clap::Args;
use serde_json::{Value, json};

use crate::console::error::CliError;
use crate::console::exit_code::{BUILT, NO_SUCH_CAM};
use crate::console::language;
use crate::console::table::{
    Side::{Left, Right},
    table,
};
use crate::console::terminal::{print, print_json, report};
use crate::console::words::{self, number};
use crate::input::searching::TimeLimit;
use crate::input::{self, SceneArgs};
use crate::synth::files_in;
use gaitcam::cover::{Assigned, Cover, Fold, covers, folds};
use gaitcam::error::{Placed, Result, SynthError};
use gaitcam::force::{ForceCurve, Walker, population_csv, read_population};
use gaitcam::scene::{ErrorMeasure, Family, Robust, set_value};
use gaitcam::sweep::{Field, Records};
use gaitcam::synth::Search;
use gaitcam_app::design::{MOST_CAMS as MOST, OF_COVER, of_cover, scene_of_cover};
use gaitcam_app::{Input, ResultFolder, inputs};
use gaitcam_output::Picture;
use gaitcam_output::cover::{CoverWords, Curve, cover as cover_picture};

const EXAMPLES: &str = "Examples:
  gaitcam cover recordings/ --cams 1:6 --out out/cover
  gaitcam cover walkers.csv --cams 3 --set law.robust=worst
  gaitcam cover --set 'gait.step_frequency=1.4 Hz:2.4 Hz:21' --out out/bridges
  gaitcam gait new.c3d --against out/cover";

/// The cycles of all walkers, from which every cam is designed.
const CYCLES: &str = "cycles.csv";
/// What an error consists of.
const PARTS: [&str; 3] = ["weight", "speed", "shape"];

/// Which walkers, how many cams.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct CoverArgs {
    /// Folder of recordings, or a table of walkers (default: those of the scene)
    #[arg(value_name = "FOLDER|TABLE")]
    walkers: Option<PathBuf>,
    /// Numbers of cams, first and last, or one number: all from 1 on are sought
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

/// Seeks the cams and writes them; exit code 3 where a cam cannot keep its limits.
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
    // What is designed here is what the scenes that are written give.
    let walkers = read_population(&place.join(CYCLES), table.as_bytes())?;
    let force = ForceCurve::of_walkers(walkers.clone())?;
    let search = Search::until(args.time.of_design());
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
    folder.write("cover.csv", cover_csv(&found, error).as_bytes())?;
    folder.write("assignment.csv", assignment_csv(&found, error).as_bytes())?;
    folder.write("folds.csv", folds_csv(&other, error).as_bytes())?;
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
    if !is_whole {
        report(words::text("cover-stopped"));
    }
    let is_built = found
        .iter()
        .flat_map(|c| &c.cams)
        .all(|d| d.infeasible.is_none());
    Ok(if is_built { BUILT } else { NO_SUCH_CAM })
}

/// `1:6` or `3`.
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

/// The scene with the walkers as its target.
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

/// Refuses a folder for results among the recordings, where the next run would read them.
fn refuse_inside(out: &Path, walkers: &Path) -> Result<()> {
    // The folder for results need not be there yet.
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

/// The scene of each cam: the walkers whom it does not serve are left out.
fn write_scenes(
    folder: &ResultFolder,
    input: &mut Input,
    cover: &Cover,
    walkers: &[Walker],
) -> Result<()> {
    let law = &cover.scene.law;
    for (cam, design) in cover.cams.iter().enumerate() {
        let objective = design.population.as_ref().map(|p| p.robust.clone());
        let mut table = input.whole.clone();
        let served = |w: &&Walker| {
            cover
                .each
                .iter()
                .any(|a| a.cam == cam && a.error.walker == w.name)
        };
        let mut out: Vec<String> = walkers
            .iter()
            .filter(|w| !served(w))
            .map(|w| w.name.clone())
            .collect();
        out.dedup();
        let name = format!("{}_{}_{}", input.scene.name, cover.cams.len(), cam + 1);
        let size = |of: Family, x: Option<usize>| {
            let x = x.filter(|_| law.family == of);
            x.map(|x| toml::Value::Integer(x as i64))
        };
        let values = [
            ("name", Some(name.into())),
            ("gait.file", Some(format!("../{CYCLES}").into())),
            ("gait.leave_out", Some(out.into())),
            ("law.robust", objective.map(Into::into)),
            ("law.family", Some(law.family.name().into())),
            ("law.spans", size(Family::Spline, law.spans)),
            ("law.harmonics", size(Family::Harmonic, law.harmonics)),
        ];
        for (key, value) in values {
            if let Some(value) = value {
                set_value(&mut table, key, value)?;
            }
        }
        let text = toml::to_string(&table).unwrap_or_default();
        folder.write(&scene_of_cover(cover.cams.len(), cam + 1), text.as_bytes())?;
    }
    Ok(())
}

/// A column of errors, named with their unit.
fn column(name: &str, error: ErrorMeasure, values: impl Iterator<Item = f64>) -> Field {
    Field::numbers(&format!("{name}_{}", error.suffix()), values.collect())
}

/// A column of counts.
fn counts(name: &str, values: impl Iterator<Item = usize>) -> Field {
    Field::numbers(name, values.map(|count| count as f64).collect())
}

fn cover_csv(covers: &[Cover], error: ErrorMeasure) -> String {
    let all = || covers.iter();
    let fields = vec![
        counts("cams", all().map(|c| c.cams.len())),
        column("mean", error, all().map(|c| c.mean)),
        column("worst", error, all().map(|c| c.worst)),
        column("bound", error, all().map(|c| c.bound.unwrap_or(f64::NAN))),
    ];
    Records { fields }.csv()
}

fn assignment_csv(covers: &[Cover], error: ErrorMeasure) -> String {
    let all = || {
        covers
            .iter()
            .flat_map(|c| c.each.iter().map(|a| (c.cams.len(), a)))
    };
    let mut fields = vec![
        counts("cams", all().map(|(cams, _)| cams)),
        Field::words("walker", all().map(|(_, a)| a.error.walker.as_str())),
        counts("cam", all().map(|(_, a)| a.cam + 1)),
        column(
            "rms_error",
            error,
            all().map(|(_, a)| a.error.measured(error)),
        ),
    ];
    for (k, part) in PARTS.iter().enumerate() {
        let share = |a: &Assigned| {
            let whole = a.error.rms_error_percent.max(f64::MIN_POSITIVE);
            a.parts_percent[k] * a.error.measured(error) / whole
        };
        fields.push(column(part, error, all().map(|(_, a)| share(a))));
    }
    Records { fields }.csv()
}

fn folds_csv(folds: &[Fold], error: ErrorMeasure) -> String {
    let all = || folds.iter();
    let fields = vec![
        counts("cams", all().map(|f| f.cams)),
        counts("walkers", all().map(|f| f.walkers)),
        column("in_mean", error, all().map(|f| f.in_mean)),
        column("in_worst", error, all().map(|f| f.in_worst)),
        column("out_mean", error, all().map(|f| f.out_mean)),
        column("out_worst", error, all().map(|f| f.out_worst)),
    ];
    Records { fields }.csv()
}

fn object(cover: &Cover, error: ErrorMeasure) -> Value {
    let out = json!({"cams": cover.cams.len(), "assignment": cover.each});
    let values = [
        ("mean", Some(cover.mean)),
        ("worst", Some(cover.worst)),
        ("bound", cover.bound),
        ("objective", Some(cover.objective)),
    ];
    in_unit(out, &values, error)
}

fn fold_object(fold: &Fold, error: ErrorMeasure) -> Value {
    let out = json!({"cams": fold.cams, "walkers": fold.walkers});
    let values = [
        ("in_mean", Some(fold.in_mean)),
        ("in_worst", Some(fold.in_worst)),
        ("out_mean", Some(fold.out_mean)),
        ("out_worst", Some(fold.out_worst)),
    ];
    in_unit(out, &values, error)
}

/// An object with errors under names that end with their unit.
fn in_unit(mut object: Value, values: &[(&str, Option<f64>)], error: ErrorMeasure) -> Value {
    for (name, value) in values {
        object[format!("{name}_{}", error.suffix())] = json!(value);
    }
    object
}

/// The largest part of an error, in words.
pub fn reason(of: &Assigned) -> String {
    let largest =
        (0..PARTS.len()).max_by(|i, j| of.parts_percent[*i].total_cmp(&of.parts_percent[*j]));
    words::text(&format!("cover-{}", PARTS[largest.unwrap_or_default()]))
}

/// Error against number of cams, with whom they serve worst and how they serve others.
fn text(input: &Input, covers: &[Cover], folds: &[Fold]) -> String {
    let mut rows = vec![
        [
            "cams",
            "mean",
            "worst",
            "objective",
            "bound",
            "others-mean",
            "others-worst",
            "who",
        ]
        .map(|c| words::text(&format!("cover-{c}")))
        .to_vec(),
    ];
    let error = input.scene.law.error;
    let shown = |x: Option<f64>| x.map_or("–".to_string(), number);
    for cover in covers {
        let worst = cover
            .each
            .iter()
            .max_by(|a, b| a.error.measured(error).total_cmp(&b.error.measured(error)));
        let most = folds.iter().rfind(|f| f.cams == cover.cams.len());
        rows.push(vec![
            cover.cams.len().to_string(),
            number(cover.mean),
            number(cover.worst),
            number(cover.objective),
            shown(cover.bound),
            shown(most.map(|f| f.out_mean)),
            shown(most.map(|f| f.out_worst)),
            worst.map_or(String::new(), |w| {
                format!("{} ({})", w.error.walker, reason(w))
            }),
        ]);
    }
    let of = match input.scene.law.robust {
        Robust::Worst => "cover-bound-worst",
        Robust::Mean => "cover-bound-mean",
        Robust::Tail(_) => "cover-bound-tail",
    };
    let walkers = covers.first().map_or(0, |c| c.each.len());
    let head = words::fill(
        &of_unit("cover-head", error),
        &json!({"name": input.scene.name, "cycles": walkers}),
    );
    let sides = [&[Right; 7][..], &[Left]].concat();
    format!("{head}\n{}\n{}", table(&rows, &sides), words::text(of))
}

/// The message of a measure of errors.
pub fn of_unit(message: &str, error: ErrorMeasure) -> String {
    match error {
        ErrorMeasure::Relative => message.to_string(),
        ErrorMeasure::Absolute => format!("{message}-n"),
    }
}

/// Error against the number of cams, of the walkers of the cams and of others.
fn picture(input: &Input, covers: &[Cover], folds: &[Fold]) -> Picture {
    let of = |value: fn(&Cover) -> Option<f64>| -> Vec<(f64, f64)> {
        let point = |c: &Cover| Some((c.cams.len() as f64, value(c)?));
        covers.iter().filter_map(point).collect()
    };
    let most = folds.iter().map(|f| f.walkers).max();
    let others = |value: fn(&Fold) -> f64| -> Vec<(f64, f64)> {
        let whole = folds.iter().filter(|f| Some(f.walkers) == most);
        whole.map(|f| (f.cams as f64, value(f))).collect()
    };
    let curve = |name: &str, points| Curve {
        name: words::text(&format!("cover-{name}")),
        points,
    };
    // The worst error has a curve of its own.
    let objective = match input.scene.law.robust {
        Robust::Worst => Vec::new(),
        Robust::Mean | Robust::Tail(_) => of(|c| Some(c.objective)),
    };
    let curves = [
        curve("bound", of(|c| c.bound)),
        curve("objective", objective),
        curve("others-mean", others(|f| f.out_mean)),
        curve("others-worst", others(|f| f.out_worst)),
        curve("mean", of(|c| Some(c.mean))),
        curve("worst", of(|c| Some(c.worst))),
    ];
    let [number, what] = ["number", "what"].map(|name| words::text(&format!("cover-{name}")));
    let error = words::text(&of_unit("cover-error", input.scene.law.error));
    let words = CoverWords {
        name: &input.scene.name,
        what: &what,
        error: &error,
        number: &number,
    };
    cover_picture(&words, &curves, language::current())
}
