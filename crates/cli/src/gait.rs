//! `gaitcam gait`: what a recording holds, and its mean cycle.

use std::path::{Path, PathBuf};

use clap::Args;
use serde_json::{Value, json};

use crate::error::CliError;
use crate::exit_code::{BAD_INPUT, BUILT};
use crate::input;
use crate::language;
use crate::terminal::{print, print_json, report};
use crate::words;
use gaitcam::error::{Error, Place, Result};
use gaitcam::force::{self, Cycle, Feet, Interpretation, ReadOptions};
use gaitcam::units::Dimension;
use gaitcam_files::{read::read_bytes, target::metadata};
use gaitcam_output as output;
use gaitcam_output::folder::{Folder, write_whole};

const EXAMPLES: &str = "Examples:
  gaitcam gait walk.c3d
  gaitcam gait walk.mot --out curve.csv
  gaitcam gait left.csv right.csv --out curves/ --feet both --rate '1000 Hz'
  gaitcam gait plate.csv --force Fz --unit kN --mass '72.6 kg' --json";

/// Which recordings, and how to read them.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct GaitArgs {
    /// Recordings: text, OpenSim .mot/.sto, C3D, insole exports
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// Write the mean cycle as csv and a picture of the stances with their mean (svg, png);
    /// in a folder, one of each per recording
    #[arg(long, value_name = "CURVE.csv|DIR")]
    out: Option<PathBuf>,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
    /// Feet whose force the cycle contains: both, one, left, right; total: the column is the sum of both
    #[arg(long, default_value = "both")]
    feet: String,
    /// Name or number of the time column
    #[arg(long, value_name = "COLUMN")]
    time: Option<String>,
    /// Name or number of a vertical force column (may be repeated)
    #[arg(long, value_name = "COLUMN")]
    force: Vec<String>,
    /// Unit of the force columns: N, kN, lbf, kgf, N/kg, BW, %BW
    #[arg(long)]
    unit: Option<String>,
    /// Sampling rate, if the file does not give it: "1000 Hz"
    #[arg(long)]
    rate: Option<String>,
    /// Mass of the walker: "72.6 kg"
    #[arg(long)]
    mass: Option<String>,
    /// What was recorded, if it is not recognised: walking, running
    #[arg(long)]
    kind: Option<String>,
}

/// What is said of one recording.
struct Described {
    text: String,
    object: Value,
    fault: Option<Error>,
}

/// Describes every file; the exit code is 2 when one of them holds no cycle.
pub fn run(args: &GaitArgs) -> Result<u8> {
    let places = args
        .out
        .as_deref()
        .map(|out| places(out, &args.files))
        .transpose()?;
    let feet: Feet = args.feet.parse().map_err(input::at_flag("--feet"))?;
    let mut code = BUILT;
    let mut objects = Vec::new();
    for (i, path) in args.files.iter().enumerate() {
        let place = places.as_ref().map(|p| p[i].as_path());
        let fault = match describe(args, path, place, feet) {
            Ok(described) => {
                if !args.json {
                    print(&described.text);
                }
                objects.push(described.object);
                described.fault
            }
            Err(e) => Some(e),
        };
        if let Some(fault) = fault {
            report(fault.sentence(language::current()));
            code = BAD_INPUT;
        }
    }
    if args.json && !objects.is_empty() {
        let one = objects.len() == 1;
        print_json(&if one {
            objects.remove(0)
        } else {
            Value::Array(objects)
        });
    }
    Ok(code)
}

fn describe(args: &GaitArgs, path: &Path, place: Option<&Path>, feet: Feet) -> Result<Described> {
    let options = options(args, path)?;
    let bytes = read_bytes(path)?;
    if let Some(curve) = force::one_cycle(path, &bytes, &options)? {
        if let Some(place) = place {
            let from = named("gait-cycle-of", path);
            write_whole(place, force::csv(&curve, &[&from]).as_bytes())?;
        }
        return Ok(Described {
            text: format!(
                "{}\n{}",
                path.display(),
                force::cycle_table(&curve, language::current())
            ),
            object: force::cycle_json(&curve),
            fault: None,
        });
    }
    let recording = force::read(path, &bytes, &options)?;
    drop(bytes);
    let stances = force::stances(&recording);
    let cycle =
        force::cycle(&recording, &stances, feet).map_err(|e| e.at(Place::File(path.to_path_buf())));
    let name = path
        .file_name()
        .map_or_else(String::new, |n| n.to_string_lossy().into());
    let found = cycle.as_ref().ok();
    let understood = Interpretation::of(&name, &recording, &stances, found, feet);
    // A refusal is printed once, on standard error.
    let table = force::table(
        &understood,
        &recording,
        &stances,
        cycle.as_ref().map_err(|_| ""),
        language::current(),
    );
    let table = table.trim_end().trim_end_matches(':');
    let text = format!("{}\n{table}", path.display());
    let object = force::json(&understood, &recording, &stances, found);
    if let Some(place) = place {
        write_cycle(path, place, &understood, found)?;
    }
    Ok(Described {
        text,
        object,
        fault: cycle.err(),
    })
}

/// A heading with a file's name.
fn named(key: &str, path: &Path) -> String {
    words::fill(key, &json!({"file": path.display().to_string()}))
}

fn options(args: &GaitArgs, path: &Path) -> Result<ReadOptions> {
    let unit = args
        .unit
        .as_deref()
        .map(|u| u.parse().map_err(input::at_flag("--unit")));
    Ok(ReadOptions {
        time: args.time.clone(),
        force: args.force.clone(),
        unit: unit.transpose()?,
        rate_hz: input::quantity("--rate", args.rate.as_deref(), Dimension::Frequency)?,
        mass_kg: input::quantity("--mass", args.mass.as_deref(), Dimension::Mass)?,
        kind: (args.kind.as_deref())
            .map(|k| k.parse().map_err(input::at_flag("--kind")))
            .transpose()?,
        metadata: metadata(path),
        ..ReadOptions::default()
    })
}

/// The mean cycle, and beside it a picture of the recording, which a refused one has too.
fn write_cycle(
    path: &Path,
    place: &Path,
    understood: &Interpretation,
    cycle: Option<&Cycle>,
) -> Result<()> {
    if let Some(cycle) = cycle {
        let from = named("gait-mean-cycle-of", path);
        let csv = force::csv(&cycle.curve, &[&from, &cycle.source.to_string()]);
        write_whole(place, csv.as_bytes())?;
    }
    let curve = cycle.map(|c| &c.curve);
    let picture = output::recording::recording(understood, curve, language::current());
    write_whole(&place.with_extension("svg"), picture.svg().as_bytes())?;
    write_whole(&place.with_extension("png"), &picture.png())
}

/// Where each recording's mean cycle goes: the one file named, or `NAME_cycle.csv` in a folder.
///
/// The pictures stand beside it, with `.svg` and `.png` for `.csv`.
fn places(out: &Path, recordings: &[PathBuf]) -> Result<Vec<PathBuf>> {
    let csv = out
        .extension()
        .is_some_and(|e| e.eq_ignore_ascii_case("csv"));
    if !csv && !out.is_dir() && out.extension().is_some() {
        let file = out.display().to_string();
        return Err(CliError::CycleEnding { file }.flag("--out"));
    }
    if !csv || out.is_dir() {
        let folder = Folder::open(out)?;
        let mut places: Vec<PathBuf> = Vec::new();
        for recording in recordings {
            let stem = recording.file_stem().unwrap_or_default().to_string_lossy();
            // Recordings of one name from two folders are numbered.
            let numbered = (1..).map(|k| match k {
                1 => format!("{stem}_cycle.csv"),
                k => format!("{stem}_cycle_{k}.csv"),
            });
            let mut free = numbered.map(|name| folder.path().join(name));
            places.extend(free.find(|p| !places.contains(p)));
        }
        return Ok(places);
    }
    if recordings.len() > 1 {
        return Err(CliError::OneCurve.flag("--out"));
    }
    let same =
        |p: &PathBuf| matches!((p.canonicalize(), out.canonicalize()), (Ok(a), Ok(b)) if a == b);
    if recordings.iter().any(same) {
        return Err(CliError::CycleOverRecording.flag("--out"));
    }
    // As synth does: a folder that is not there yet is made.
    if let Some(folder) = out.parent().filter(|f| !f.as_os_str().is_empty()) {
        Folder::open(folder)?;
    }
    Ok(vec![out.to_path_buf()])
}
