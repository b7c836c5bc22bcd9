//! The command `gaitcam`: arguments, files, progress and exit codes.
//!
//! Each verb has a module with its arguments. [`run`] parses the command line, calls the function of the verb and returns the exit code.
#![forbid(unsafe_code)]
#![cfg_attr(not(test), deny(clippy::disallowed_methods))]
#![cfg_attr(not(test), warn(unused_crate_dependencies))]

mod console;
mod ecam;
mod gait;
mod identify;
mod input;
mod inspect;
mod points;
mod reference;
mod results;
mod scene;
mod simulate;
mod studio;
mod sweep;
mod synth;
mod walk;

use std::ffi::OsString;

use clap::{FromArgMatches, Parser, Subcommand};

pub use console::exit_code;
use console::terminal::{final_exit_code, print_json, record_write_error, report};
use console::{help, internal, language, usage, words};
use exit_code::BUILT;
use gaitcam::error::{Error, Result};
use gaitcam_app::inputs;
use reference::{completions, keys, laws};
use results::{compare, front};
use scene::{doctor, init};
use serde_json::{Value, json};

/// Version, commit and solver of this build.
const VERSION: &str = concat!(env!("CARGO_PKG_VERSION"), " (", env!("GAITCAM_BUILD"), ")");

/// Design cams that reproduce a given force.
#[derive(Parser, Debug)]
#[command(name = "gaitcam", version = VERSION, about, max_term_width = 100)]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(Subcommand, Debug)]
enum Command {
    /// Design a cam: force curve or programme → law → cam → checks → files
    Synth(synth::SynthArgs),
    /// Read a recording: format, channels, stances, mean cycle
    Gait(gait::GaitArgs),
    /// Find the number of cams for a population of walkers, and assign a cam to each walker
    Cover(gait::cover::CoverArgs),
    /// Simulate the finished cam: force, torque, lift-off, vibration, with the simplest sufficient model
    Simulate(simulate::SimulateArgs),
    /// Compute the speed programme that gives a cam the step times of a recorded walk
    Walk(walk::WalkArgs),
    /// Fit measured points of a manufactured cam to its design: deviations and force of this cam
    Inspect(inspect::InspectArgs),
    /// Identify the machine from logs of its runs: mass, stiffness, damping, friction, with intervals
    Identify(identify::IdentifyArgs),
    /// Design the next cam, which corrects the repeatable force errors in logs of the machine
    Recut(identify::RecutArgs),
    /// Write a design as an electronic cam for a motion controller, and compute the force error with this controller
    Ecam(ecam::EcamArgs),
    /// Write the profile as points for "curve through points" of a CAD program
    Points(points::PointsArgs),
    /// Design thousands of scenes (a grid, a list or a sample of values) and write one table
    Sweep(sweep::SweepArgs),
    /// Compute the Pareto front of a sweep: table, pictures and the best design
    Front(front::FrontArgs),
    /// Compare several results: table and overlaid diagrams
    Compare(compare::CompareArgs),
    /// Open the studio, a page in the browser that updates the cam after every change
    Studio(studio::StudioArgs),
    /// Write a commented scene for a machine
    Init(init::InitArgs),
    /// Explain the faults of a scene or a recording, and how to correct them
    Doctor(doctor::DoctorArgs),
    /// List the keys of a scene file: values, default and meaning
    Keys(keys::KeysArgs),
    /// List the built-in scenes, or print one
    Scenes(keys::ScenesArgs),
    /// List the catalogue of rise laws with their peak factors
    Laws(laws::LawsArgs),
    /// Print the completion script of a shell
    Completions(completions::CompletionsArgs),
}

/// Runs the command with its arguments and returns the exit code. The first argument is the name of the program.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> u8 {
    let arguments = usage::with_negative_values(arguments);
    language::set(&arguments);
    let parsed = help::parser(language::current())
        .try_get_matches_from(&arguments)
        .and_then(|matches| Cli::from_arg_matches(&matches));
    let cli = match parsed {
        Ok(cli) => cli,
        // Clap reports help and version as errors. They are printed to standard output.
        Err(e) if !e.use_stderr() => {
            record_write_error(e.print());
            return final_exit_code(BUILT);
        }
        Err(e) => return refused(&usage::fault(&e), arguments.iter().any(|a| a == "--json")),
    };
    let json = cli.command.as_ref().is_some_and(Command::json);
    match internal::caught(json, || dispatch(cli)) {
        Ok(Ok(code)) => final_exit_code(code),
        Ok(Err(error)) => refused(&error, json),
        Err(code) => code,
    }
}

/// Catches the signal that is sent when a write exceeds the file size limit (`ulimit -f`). The write then fails with an error, and the
/// process is not ended.
#[cfg(unix)]
fn fail_on_large_files() {
    let noticed = std::sync::Arc::default();
    let _ = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, noticed);
}

#[cfg(not(unix))]
fn fail_on_large_files() {}

fn dispatch(cli: Cli) -> Result<u8> {
    fail_on_large_files();
    if !matches!(cli.command, Some(Command::Studio(_))) {
        inputs::protect();
    }
    let Some(command) = cli.command else {
        report(words::text("run-no-command"));
        return synth::run(&synth::SynthArgs::default());
    };
    match command {
        Command::Synth(args) => synth::run(&args),
        Command::Simulate(args) => simulate::run(&args),
        Command::Gait(args) => gait::run(&args),
        Command::Cover(args) => gait::cover::run(&args),
        Command::Walk(args) => walk::run(&args),
        Command::Inspect(args) => inspect::run(&args),
        Command::Identify(args) => identify::identify(&args),
        Command::Recut(args) => identify::recut(&args),
        Command::Ecam(args) => ecam::run(&args),
        Command::Points(args) => points::run(&args),
        Command::Sweep(args) => sweep::run(&args),
        Command::Front(args) => front::run(&args),
        Command::Compare(args) => compare::run(&args),
        Command::Studio(args) => studio::run(&args),
        Command::Keys(args) => keys::keys(&args),
        Command::Scenes(args) => keys::scenes(&args),
        Command::Laws(args) => laws::run(&args),
        Command::Completions(args) => completions::run(&args),
        Command::Init(args) => init::run(&args),
        Command::Doctor(args) => doctor::run(&args),
    }
}

/// Prints an error, as JSON if requested, and returns its exit code.
pub(crate) fn refused(error: &Error, json: bool) -> u8 {
    report(error.sentence(language::current()));
    if json {
        print_json(&error_json(error));
    }
    final_exit_code(exit_code::of_error(error))
}

/// Converts an error to JSON. The message is the same as on standard error.
fn error_json(error: &Error) -> Value {
    let language = language::current();
    let place = error.place.to_string();
    json!({"error": {
        "code": error.code(),
        "place": place.trim_end_matches(": "),
        "message": error.what(language),
        "help": error.help(language),
    }})
}

impl Command {
    /// Whether the user requested JSON output.
    fn json(&self) -> bool {
        match self {
            Command::Synth(args) => args.json,
            Command::Simulate(args) => args.json,
            Command::Gait(args) => args.json,
            Command::Cover(args) => args.json,
            Command::Walk(args) => args.json,
            Command::Inspect(args) => args.json,
            Command::Identify(args) => args.json,
            Command::Recut(args) => args.json,
            Command::Ecam(args) => args.json,
            Command::Sweep(args) => args.json,
            Command::Front(args) => args.json,
            Command::Compare(args) => args.json,
            Command::Laws(args) => args.json,
            Command::Keys(args) => args.json || args.schema,
            Command::Scenes(args) => args.json,
            Command::Studio(_)
            | Command::Points(_)
            | Command::Completions(_)
            | Command::Init(_)
            | Command::Doctor(_) => false,
        }
    }
}
