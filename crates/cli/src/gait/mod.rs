//! `gaitcam gait`: describes recordings and computes the mean cycle of each recording. Several recordings also have a joint mean cycle. The
//! submodule `cover` contains `gaitcam cover`.

mod against;
pub mod cover;
mod places;
mod plates;
mod reading;
mod several;

use std::path::{Path, PathBuf};

use clap::Args;
use serde_json::{Value, json};

use crate::console::error::CliError;
use crate::console::exit_code::{BAD_INPUT, BUILT};
use crate::console::language;
use crate::console::terminal::{print, print_json, report};
use crate::input;
use crate::input::recordings::recordings;
use gaitcam::error::{Placed, Result};
use gaitcam::force::{Feet, OpenQuestion, ReadOptions, Walker, steps_csv};
use gaitcam::units::Dimension;
use gaitcam_app::folder::write_whole;
use gaitcam_app::inputs;
use places::Places;
use reading::{Read, of_files, read, together, write_cycle, write_picture};

const EXAMPLES: &str = "Examples:
  gaitcam gait walk.c3d
  gaitcam gait walk.mot --out curve.csv
  gaitcam gait walk.c3d --out walk.mot
  gaitcam gait trials/ --out mean.csv
  gaitcam gait walk.c3d --stances
  gaitcam gait walk.c3d --stances stances.csv
  gaitcam gait left.csv right.csv --out curves/ --feet both --rate '1000 Hz'
  gaitcam gait press.csv --period '0.5 s' --out curve.csv
  gaitcam gait plate.csv --force Fz --unit kN --mass '72.6 kg' --json";

/// Arguments of `gaitcam gait`.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct GaitArgs {
    /// Recordings, or folders with recordings: text, OpenSim .mot/.sto, C3D, insole exports. Several recordings give
    /// a table and their joint mean
    #[arg(required = true, value_name = "FILE|FOLDER")]
    files: Vec<PathBuf>,
    /// Write the mean cycle, or the joint mean of several recordings, as csv or for OpenSim (.mot), with pictures
    /// (svg, png). In a folder, the cycle of each recording is also written
    #[arg(long, value_name = "CURVE.csv|CURVE.mot|DIR")]
    out: Option<PathBuf>,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
    /// Feet whose force is used: both, one, left, right; total if the column is the sum of both
    #[arg(long, default_value = "both")]
    feet: String,
    /// Name or number of the time column
    #[arg(long, value_name = "COLUMN")]
    time: Option<String>,
    /// Name or number of a vertical force column (may be repeated)
    #[arg(long, value_name = "COLUMN")]
    force: Vec<String>,
    /// Unit of the force columns: N, daN, kN, lbf, kgf, N/kg, BW, %BW
    #[arg(long)]
    unit: Option<String>,
    /// Sampling rate, if the file does not give it: "1000 Hz"
    #[arg(long)]
    rate: Option<String>,
    /// Mass of the walker: "72.6 kg"
    #[arg(long)]
    mass: Option<String>,
    /// Movement in the recording, if it is not recognised: walking, running
    #[arg(long)]
    kind: Option<String>,
    /// The file contains exactly one cycle of this duration, for any machine: "0.5 s"
    #[arg(long)]
    period: Option<String>,
    /// Part of the turn that the file covers; the force is zero in the rest: "256 deg"
    #[arg(long)]
    span: Option<String>,
    /// Include a recording in the joint mean in spite of these open questions: kind, clock, mass
    #[arg(long, value_name = "LIST", default_value = "")]
    accept: String,
    /// List every stance and every rejected contact of a recording, or write them as a table
    #[arg(long, value_name = "STANCES.csv", num_args = 0..=1)]
    stances: Option<Option<PathBuf>>,
    /// Assign a cam from an output folder of gaitcam cover to the walker, with the force error
    #[arg(long, value_name = "DIR")]
    against: Option<PathBuf>,
}

/// Describes every recording. The exit code is 2 if a recording named by the user contains no cycle, or if no recording contains a cycle.
pub fn run(args: &GaitArgs) -> Result<u8> {
    let feet: Feet = args.feet.parse().map_err(input::at_flag("--feet"))?;
    let accept = OpenQuestion::list(&args.accept).map_err(input::at_flag("--accept"))?;
    let options = options(args)?;
    let mut files = recordings(&args.files, "FOLDER")?.files;
    let named = |file: &str| args.files.iter().any(|f| f == Path::new(file));
    files.retain(|f| named(f) || !args.out.as_deref().is_some_and(|o| wrote(o, Path::new(f))));
    let files: Vec<PathBuf> = files.into_iter().map(PathBuf::from).collect();
    files.iter().for_each(|file| inputs::note(file));
    let trials = plates::by_trial(files);
    if let (Some(Some(table)), [_, _, ..]) = (&args.stances, &trials[..]) {
        let table = table.display().to_string();
        return Err(CliError::StancesOfSeveral { table }.at_argument("--stances"));
    }
    let is_one = trials.len() == 1 && trials[0] == args.files;
    let places = Places::of(args.out.as_deref(), &trials, !is_one)?;
    if is_one {
        return one(args, options, &trials[0], &places, feet);
    }
    let reads = trials.iter().map(|paths| {
        read(options.clone(), paths, feet, false).unwrap_or_else(|fault| Read::failed(paths, fault))
    });
    let is_named = |read: &Read| read.paths.iter().any(|p| args.files.contains(p));
    let against = args.against.as_deref();
    several::describe(
        reads.collect(),
        &places,
        &accept,
        args.json,
        &is_named,
        against,
    )
}

/// Whether `file` is a cycle that this command has written into `folder`.
fn wrote(folder: &Path, file: &Path) -> bool {
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    let inside = || {
        let parent = file.parent().and_then(|p| p.canonicalize().ok());
        parent.is_some() && parent == folder.canonicalize().ok()
    };
    let is_cycle = || std::fs::read(file).is_ok_and(|b| b.starts_with(b"# cycle"));
    (name.contains("_cycle") || name == places::JOINT_MEAN) && inside() && is_cycle()
}

fn one(
    args: &GaitArgs,
    options: ReadOptions,
    paths: &[PathBuf],
    places: &Places,
    feet: Feet,
) -> Result<u8> {
    let table = args.stances.as_ref().and_then(Option::as_deref);
    table.map_or(Ok(()), places::check_table)?;
    let listed = args.stances.is_some() && table.is_none();
    let mut read = read(options, paths, feet, listed)?;
    if let (Some(place), Some(understood)) = (table, &read.understood) {
        write_whole(place, steps_csv(&understood.stance_rows()).as_bytes())?;
    }
    if let Some(folder) = &args.against {
        let (text, object) = held_against(folder, std::slice::from_ref(&read))?;
        read.text = format!("{}\n{text}", read.text.trim_end());
        read.object["against"] = object;
    }
    if let Some(place) = places.each.first() {
        read.write(place)?;
    }
    if args.json {
        print_json(&read.object);
    } else {
        print(&read.text);
    }
    Ok(match read.fault {
        None => BUILT,
        Some(fault) => {
            report(fault.sentence(language::current()));
            BAD_INPUT
        }
    })
}

/// Best cam in an output folder of `gaitcam cover` for each recording with a cycle, as text and JSON.
fn held_against(folder: &Path, reads: &[Read]) -> Result<(String, Value)> {
    let walker = |read: &Read| {
        let name = read
            .paths
            .first()
            .and_then(|p| p.file_stem())
            .unwrap_or_default();
        Some(Walker::new(&name.to_string_lossy(), read.curve()?.clone()))
    };
    let walkers: Vec<Walker> = reads.iter().filter_map(walker).collect();
    if walkers.is_empty() {
        return Ok((String::new(), json!([])));
    }
    against::against(folder, walkers)
}

fn options(args: &GaitArgs) -> Result<ReadOptions> {
    Ok(ReadOptions {
        time: args.time.clone(),
        force: args.force.clone(),
        unit: input::parsed("--unit", args.unit.as_deref())?,
        rate_hz: input::positive("--rate", args.rate.as_deref(), Dimension::Frequency)?,
        mass_kg: input::positive("--mass", args.mass.as_deref(), Dimension::Mass)?,
        kind: input::parsed("--kind", args.kind.as_deref())?,
        period_s: input::positive("--period", args.period.as_deref(), Dimension::Time)?,
        span_rad: input::positive("--span", args.span.as_deref(), Dimension::Angle)?,
        noise_n: None,
        metadata: None,
    })
}
