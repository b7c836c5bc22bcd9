//! `gaitcam doctor FILE`: lists all faults of a scene or a recording, with their corrections.

use std::path::PathBuf;

use clap::Args;
use gaitcam::error::{Placed, Result};
use gaitcam::scene;
use gaitcam::synth::{Search, sentences};
use serde_json::json;

use crate::console::error::CliError;
use crate::console::exit_code::{self, BAD_INPUT, BUILT, NO_SUCH_CAM};
use crate::console::language;
use crate::console::terminal::print;
use crate::console::words;
use crate::input::searching::TimeLimit;
use crate::input::{self, SceneArgs};
use gaitcam_app::doctor::{self, Finding, Mark};

const EXAMPLES: &str = "Examples:
  gaitcam doctor my.toml
  gaitcam doctor walk.c3d";

/// Arguments of `gaitcam doctor`.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct DoctorArgs {
    /// Scene file, name of a built-in scene, or recording
    file: PathBuf,
    /// Change a value of the scene: --set 'limits.stroke=40 mm' (may be repeated)
    #[arg(long = "set", value_name = "KEY=VALUE")]
    set: Vec<String>,
    #[command(flatten)]
    time: TimeLimit,
}

/// Examines the file. The exit code is the same as for `synth` or `gait`.
pub fn run(args: &DoctorArgs) -> Result<u8> {
    if doctor::is_recording(&args.file) {
        if !args.set.is_empty() {
            return Err(CliError::RecordingNotScene.at_argument("--set"));
        }
        return Ok(report(&doctor::recording_file(&args.file)?));
    }
    let (mut table, files, _) = input::written(&SceneArgs::of(args.file.clone()))?;
    for change in &args.set {
        scene::set(&mut table, change).map_err(input::at_flag("--set"))?;
    }
    let name = args.file.display().to_string();
    let (findings, input) = doctor::scene(&name, table, files)?;
    let code = report(&findings);
    let Some(input) = input else {
        return Ok(code);
    };
    let shown = args.time.shown();
    let found = doctor::design(&input, &Search::until(args.time.of_design()))?;
    drop(shown);
    Ok(report(&[found]))
}

/// Prints the findings and returns the exit code of the most serious finding.
fn report(findings: &[Finding]) -> u8 {
    for finding in findings {
        let mark = match finding.mark() {
            Mark::Good => "✓",
            Mark::Doubtful => "?",
            Mark::Bad => "✗",
        };
        print(&format!("{mark} {}", sentence(finding)));
        if let Finding::NoCycle(_) = finding {
            print(&words::text("doctor-recording-options"));
        }
    }
    let faults = findings.iter().filter(|f| matches!(f, Finding::Fault(_)));
    let faults = faults.count();
    if faults > 0 && findings.len() > 1 {
        print(&words::fill("doctor-faults", &json!({"count": faults})));
    }
    let codes = findings.iter().map(code);
    codes.max_by_key(|code| *code != BUILT).unwrap_or(BUILT)
}

/// Exit code for a finding.
fn code(finding: &Finding) -> u8 {
    match finding {
        Finding::Fault(fault) => exit_code::of_error(fault),
        Finding::NoCycle(_) => BAD_INPUT,
        Finding::Open(_) => NO_SUCH_CAM,
        Finding::Design(design) => exit_code::of(design.verdict),
        Finding::Good(..) | Finding::Note(_) => BUILT,
    }
}

fn sentence(finding: &Finding) -> String {
    let language = language::current();
    let catalogue = gaitcam::wording::catalogue(language);
    match finding {
        Finding::Good(key, data) => words::fill(&format!("doctor-{key}"), data),
        Finding::Fault(fault) | Finding::NoCycle(fault) => fault.sentence(language),
        Finding::Note(note) => catalogue.sentence("note", note),
        Finding::Open(doubt) => {
            let data = json!({"sentence": catalogue.sentence("open", doubt), "name": doubt.name()});
            let key = match doubt.is_acceptable() {
                true => "doctor-doubt",
                false => "doctor-unacceptable",
            };
            words::fill(key, &data)
        }
        Finding::Design(design) => {
            let text = sentences(&design.reasons, language);
            format!("{}: {text}", words::name(design.verdict.name()))
        }
    }
}
