//! The command `gaitcam`: arguments, files, progress, exit codes.
#![forbid(unsafe_code)]

pub mod choices;
mod compare;
mod explain;
mod front;
mod gait;
mod hand_over;
mod input;
mod laws;
mod simulate;
mod sweep;
mod synth;

use std::ffi::OsString;
use std::io::Write;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};

use clap::{Args, Parser, Subcommand};

use gaitcam::error::Error;

/// From a vertical walking force to the cam that reproduces it.
#[derive(Parser, Debug)]
#[command(name = "gaitcam", version, about, max_term_width = 100)]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(Subcommand, Debug)]
enum Command {
    /// Design a cam: force curve or programme → law → cam → checks → files
    Synth(SynthArgs),
    /// Read a recording, say what it holds, give its mean cycle
    Gait(GaitArgs),
    /// Run the emitted cam: force, torque, lift-off, vibration, with the least model that is enough
    Simulate(simulate::SimulateArgs),
    /// Design thousands of scenes: a grid, a list or a sample of values, into one table
    Sweep(sweep::SweepArgs),
    /// The best designs of a sweep: Pareto set, pictures, the winner as a normal result
    Front(front::FrontArgs),
    /// Compute the source papers' numbers again: stated, recomputed, agrees or not
    Reproduce {
        /// Folder for the report
        #[arg(long, value_name = "DIR", default_value = "reports")]
        out: PathBuf,
    },
    /// Put several results side by side: table and overlaid diagrams
    Compare(CompareArgs),
    /// Measure speed against accuracy on this machine and draw the charts
    Chart(ChartArgs),
    /// List the catalogue of rise laws with their peak factors
    Laws {
        /// Print JSON
        #[arg(long)]
        json: bool,
    },
}

/// A scene with changes.
#[derive(Args, Debug, Default)]
struct SceneArgs {
    /// Scene file; without one, the built-in footbridge
    scene: Option<PathBuf>,
    /// Change a value: --set 'limits.stroke=40 mm' (may be repeated)
    #[arg(long = "set", value_name = "KEY=VALUE")]
    set: Vec<String>,
}

#[derive(Args, Debug, Default)]
struct SynthArgs {
    #[command(flatten)]
    scene: SceneArgs,
    /// Folder for the files (default out/NAME)
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Print summary.json instead of the summary for people
    #[arg(long)]
    json: bool,
    /// Print every step of a sequence of convex programs with its merit
    #[arg(short, long)]
    verbose: bool,
    /// Say what decided every choice of model, and what the next richer one would cost and change
    #[arg(long)]
    explain: bool,
    /// Rows of law.csv and profile.csv (default 1440), or points of the front (default 20)
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(2..=1_000_000))]
    points: Option<u32>,
    /// The trade-off instead of one cam: force_error:prime_radius, or :jerk, :acceleration, :velocity, :stroke
    #[arg(long, value_name = "A:B")]
    front: Option<String>,
    /// Also write what a workshop takes: solid (STL, 3MF), arcs (DXF), workbook (XLSX)
    #[arg(long)]
    solid: bool,
    /// Also write the path of a cutter of this radius: --tool '6 mm'
    #[arg(long, value_name = "RADIUS")]
    tool: Option<String>,
}

impl SynthArgs {
    /// What the command line gives when nothing is said.
    fn standard() -> Self {
        SynthArgs::default()
    }
}

#[derive(Args, Debug)]
struct CompareArgs {
    /// Folders that gaitcam synth wrote
    #[arg(required = true, num_args = 2..)]
    folders: Vec<PathBuf>,
    /// Folder for the table and the diagrams
    #[arg(long, value_name = "DIR", default_value = "out/compare")]
    out: PathBuf,
    /// Print the summaries as JSON
    #[arg(long)]
    json: bool,
}

#[derive(Args, Debug)]
struct ChartArgs {
    /// Fewer repetitions and sizes: under a minute
    #[arg(long)]
    quick: bool,
    /// Folder for tables and pictures
    #[arg(long, value_name = "DIR", default_value = "reports")]
    out: PathBuf,
}

#[derive(Args, Debug)]
struct GaitArgs {
    /// Recordings: text, OpenSim .mot/.sto, C3D, insole exports
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// Write the mean cycle as csv, and beside it a picture of the stances over their mean (svg, png);
    /// a folder takes one of each per recording
    #[arg(long, value_name = "CURVE.csv|DIR")]
    out: Option<PathBuf>,
    /// Print JSON
    #[arg(long)]
    json: bool,
    /// Whose force the cycle is: both, one, left, right
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
    /// Samples per second where the file does not say: "1000 Hz"
    #[arg(long)]
    rate: Option<String>,
    /// Mass of the walker: "72.6 kg"
    #[arg(long)]
    mass: Option<String>,
}

/// Everything went well and every check passes.
pub const BUILT: u8 = 0;
/// Our own fault.
pub const OUR_FAULT: u8 = 1;
/// Bad input.
pub const BAD_INPUT: u8 = 2;
/// No such cam: the limits leave none, or a check fails.
pub const NO_SUCH_CAM: u8 = 3;

/// Runs the command with its arguments (the first is the program's name) and returns the exit code.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> u8 {
    let cli = match Cli::try_parse_from(arguments) {
        Ok(cli) => cli,
        Err(e) => {
            // Help and version are answers, not faults.
            let code = if e.use_stderr() { BAD_INPUT } else { BUILT };
            heard(e.print());
            return spoken(code);
        }
    };
    let outcome = std::panic::catch_unwind(|| dispatch(cli));
    match outcome {
        Ok(Ok(code)) => spoken(code),
        Ok(Err(error)) => {
            eprintln!("gaitcam: {error}");
            BAD_INPUT
        }
        Err(_) => {
            eprintln!(
                "gaitcam: this is a fault of gaitcam itself, not of your input; please report it with the scene"
            );
            OUR_FAULT
        }
    }
}

/// The exit code, unless the answer never reached its reader.
fn spoken(code: u8) -> u8 {
    if UNSAID.load(Ordering::Relaxed) {
        OUR_FAULT
    } else {
        code
    }
}

fn dispatch(cli: Cli) -> Result<u8, Error> {
    match cli.command {
        None => synth::run(&SynthArgs::standard()),
        Some(Command::Synth(args)) => synth::run(&args),
        Some(Command::Simulate(args)) => simulate::run(&args),
        Some(Command::Gait(args)) => gait::run(&args),
        Some(Command::Sweep(args)) => sweep::run(&args),
        Some(Command::Front(args)) => front::run(&args),
        Some(Command::Reproduce { out }) => {
            gaitcam_evidence::reproduce::write(&out, &mut |line| say(line)).map(|()| BUILT)
        }
        Some(Command::Compare(args)) => compare::run(&args),
        Some(Command::Chart(args)) => {
            gaitcam_evidence::measure::write(args.quick, &args.out, &mut |line| say(line))
                .map(|()| BUILT)
        }
        Some(Command::Laws { json }) => laws::run(json),
    }
}

/// Whether an answer could not be written to standard output.
static UNSAID: AtomicBool = AtomicBool::new(false);

/// Prints a line, or stops quietly when nobody reads any more (`gaitcam … | head`).
fn say(text: &str) {
    let mut out = std::io::stdout().lock();
    heard(writeln!(out, "{text}").and_then(|()| out.flush()));
}

/// Remembers a failure to write, so that the exit code tells it: a full disk must not look like success.
fn heard(written: std::io::Result<()>) {
    if let Err(e) = written
        && e.kind() != std::io::ErrorKind::BrokenPipe
        && !UNSAID.swap(true, Ordering::Relaxed)
    {
        eprintln!("gaitcam: the answer cannot be written to standard output ({e})");
    }
}
