//! `gaitcam gait`: what recordings hold, their mean cycles, and the joint mean of several; `gaitcam cover`.

mod against;
pub mod cover;
mod places;
mod plates;
mod several;

use std::path::{Path, PathBuf};

use clap::Args;
use serde_json::{Value, json};

use crate::console::error::CliError;
use crate::console::exit_code::{BAD_INPUT, BUILT};
use crate::console::language;
use crate::console::terminal::{print, print_json, report};
use crate::console::words;
use crate::input;
use crate::input::recordings::recordings;
use gaitcam::error::{Error, Place, Placed, Result};
use gaitcam::force::{
    self, Cycle, Feet, ForceCurve, Interpretation, OpenQuestion, ReadOptions, Walker,
};
use gaitcam::scene::{BETWEEN_PLATES, content};
use gaitcam::units::Dimension;
use gaitcam_app::disk::metadata;
use gaitcam_app::folder::write_whole;
use gaitcam_app::{Disk, inputs};
use gaitcam_output as output;
use gaitcam_output::gait as tables;
use places::Places;

const EXAMPLES: &str = "Examples:
  gaitcam gait walk.c3d
  gaitcam gait walk.mot --out curve.csv
  gaitcam gait trials/ --out mean.csv
  gaitcam gait walk.c3d --stances
  gaitcam gait left.csv right.csv --out curves/ --feet both --rate '1000 Hz'
  gaitcam gait press.csv --period '0.5 s' --out curve.csv
  gaitcam gait plate.csv --force Fz --unit kN --mass '72.6 kg' --json";

/// Which recordings, and how to read them.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct GaitArgs {
    /// Recordings, or folders of them: text, OpenSim .mot/.sto, C3D, insole exports; of several a table and their
    /// joint mean
    #[arg(required = true, value_name = "FILE|FOLDER")]
    files: Vec<PathBuf>,
    /// Write the mean cycle (of several recordings the joint mean) as csv, with pictures (svg, png); in a folder,
    /// the cycle of each recording too
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
    /// Unit of the force columns: N, daN, kN, lbf, kgf, N/kg, BW, %BW
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
    /// The file is exactly one cycle of this duration, of any machine: "0.5 s"
    #[arg(long)]
    period: Option<String>,
    /// The file covers this part of a turn, the force is zero in the rest: "256 deg"
    #[arg(long)]
    span: Option<String>,
    /// Take a recording into the joint mean although this is open about it: kind, clock, mass
    #[arg(long, value_name = "LIST", default_value = "")]
    accept: String,
    /// List every stance and every rejected contact of a recording
    #[arg(long)]
    stances: bool,
    /// Which cam of a folder that gaitcam cover wrote serves the walker, and how well
    #[arg(long, value_name = "DIR")]
    against: Option<PathBuf>,
}

/// One recording as it was read.
#[derive(Default)]
struct Read {
    /// Its file, or those of its plates.
    paths: Vec<PathBuf>,
    /// Its interpretation; `None` for a file that is one cycle.
    understood: Option<Interpretation>,
    /// Its mean cycle.
    cycle: Option<Cycle>,
    /// The cycle that the file is.
    given: Option<ForceCurve>,
    /// Why it gives no cycle.
    fault: Option<Error>,
    /// Its own table.
    text: String,
    object: Value,
}

/// Describes every recording; the exit code is 2 where one that was named holds no cycle, or where there is none at
/// all.
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

/// Whether a file is a cycle that this command wrote into a folder.
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
    let mut read = read(options, paths, feet, args.stances)?;
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

/// The cams of a cover for those who have a cycle.
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

/// Reads one recording: a file, or the files of its plates; its table lists every stance if `all` is set.
fn read(options: ReadOptions, paths: &[PathBuf], feet: Feet, all: bool) -> Result<Read> {
    let path = paths[0].as_path();
    if path.extension().is_some_and(|e| e == "toml") {
        return Err(CliError::SceneNotRecording.in_file(path));
    }
    let options = ReadOptions {
        metadata: metadata(path),
        ..options
    };
    let shown = |path: &Path| path.display().to_string();
    let bytes = content(&Disk::default(), Path::new(&together(paths, shown)))?;
    let place = || Place::File(path.to_path_buf());
    let heading = together(paths, shown);
    if let Some(curve) = force::one_cycle(path, &bytes, &options)? {
        let table = tables::cycle_table(&curve, language::current());
        return Ok(Read {
            paths: paths.to_vec(),
            text: format!("{heading}\n{table}"),
            object: tables::cycle_json(&curve),
            given: Some(curve),
            ..Read::default()
        });
    }
    let recording = force::read(path, &bytes, &options)?;
    drop(bytes);
    let stances = force::stances(&recording);
    let cycle = force::cycle(&recording, &stances, feet).map_err(|e| e.at(place()));
    let name = together(paths, |path: &Path| {
        let name = path.file_name().unwrap_or_default();
        name.to_string_lossy().into_owned()
    });
    let mean = cycle.as_ref().ok();
    let understood = Interpretation::of(&name, &recording, &stances, mean, feet);
    // A refusal is printed once, on standard error.
    let table = tables::table(
        &understood,
        &recording,
        &stances,
        cycle.as_ref().map_err(|_| ""),
        all,
        language::current(),
    );
    let table = table.trim_end();
    let object = tables::json(&understood, &recording, &stances, mean);
    let (cycle, fault) = match cycle {
        Ok(cycle) => (Some(cycle), None),
        Err(fault) => (None, Some(fault)),
    };
    Ok(Read {
        paths: paths.to_vec(),
        understood: Some(understood),
        cycle,
        fault,
        text: format!("{heading}\n{table}"),
        object,
        ..Read::default()
    })
}

/// The files of a recording, named one by one.
fn together(paths: &[PathBuf], name: impl Fn(&Path) -> String) -> String {
    let names = paths.iter().map(|path| name(path));
    names.collect::<Vec<_>>().join(BETWEEN_PLATES)
}

impl Read {
    /// A recording that could not be read.
    fn failed(paths: &[PathBuf], fault: Error) -> Read {
        Read {
            paths: paths.to_vec(),
            fault: Some(fault),
            object: json!({"kind": null, "cycle": null}),
            ..Read::default()
        }
    }

    /// Its paths.
    fn shown(&self) -> String {
        together(&self.paths, |path| path.display().to_string())
    }

    /// Its cycle, mean or as given.
    fn curve(&self) -> Option<&ForceCurve> {
        let mean = self.cycle.as_ref().map(|c| &c.curve);
        mean.or(self.given.as_ref())
    }

    /// Writes the cycle; for a mean cycle, and for a recording that was refused, also a picture of the recording.
    fn write(&self, place: &Path) -> Result<()> {
        if let Some(curve) = &self.given {
            let from = of_files("gait-cycle-of", &self.shown());
            write_whole(place, curve.to_csv(&[&from]).as_bytes())?;
        }
        if let Some(cycle) = &self.cycle {
            let from = of_files("gait-mean-cycle-of", &self.shown());
            let csv = cycle.curve.to_csv(&[&from, &cycle.source.to_string()]);
            write_whole(place, csv.as_bytes())?;
        }
        let Some(understood) = &self.understood else {
            return Ok(());
        };
        let curve = self.cycle.as_ref().map(|c| &c.curve);
        let picture = output::recording::recording(understood, curve, language::current());
        write_picture(place, &picture)
    }
}

/// The path of a picture: that of the csv with `.svg` or `.png` for `.csv`.
fn write_picture(place: &Path, picture: &output::Picture) -> Result<()> {
    write_whole(&place.with_extension("svg"), picture.svg().as_bytes())?;
    write_whole(&place.with_extension("png"), &picture.png())
}

/// A heading with the names of files.
fn of_files(key: &str, files: &str) -> String {
    words::fill(key, &json!({"file": files}))
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
        metadata: None,
    })
}
