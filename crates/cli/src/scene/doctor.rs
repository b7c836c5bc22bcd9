//! `gaitcam doctor FILE`: what is wrong with a scene or a recording, all of it at once, and what cures it.

use std::path::{Path, PathBuf};

use clap::Args;
use gaitcam::error::Result;
use gaitcam::synth::{Search, sentences};
use serde_json::json;

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

/// Which file.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct DoctorArgs {
    /// Scene file, name of a built-in scene, or recording
    file: PathBuf,
    #[command(flatten)]
    time: TimeLimit,
}

/// Examines the file; the exit code is that of `synth` or `gait`.
pub fn run(args: &DoctorArgs) -> Result<u8> {
    let ending = args.file.extension().map(|e| e.to_ascii_lowercase());
    if ending.is_some_and(|e| e != "toml" && e != "json") {
        return Ok(report(&args.file, &doctor::recording_file(&args.file)?));
    }
    let (table, files, _) = input::written(&SceneArgs::of(args.file.clone()))?;
    let (findings, input) = doctor::scene(table, files)?;
    let code = report(&args.file, &findings);
    let Some(input) = input else {
        return Ok(code);
    };
    let shown = args.time.shown();
    let found = doctor::design(&input, &Search::until(args.time.of_design()))?;
    drop(shown);
    Ok(report(&args.file, &[found]))
}

/// Prints findings on a file and returns the exit code of the most serious one.
fn report(file: &Path, findings: &[Finding]) -> u8 {
    for finding in findings {
        let mark = match finding.mark() {
            Mark::Good => "✓",
            Mark::Doubtful => "?",
            Mark::Bad => "✗",
        };
        print(&format!("{mark} {}", sentence(file, finding)));
        if let Finding::NoCycle(_) = finding {
            print(&words::text("doctor-recording-options"));
        }
    }
    let faults = findings.iter().filter(|f| matches!(f, Finding::Fault(_)));
    let faults = faults.count();
    if faults > 0 && matches!(findings[0], Finding::Table(_)) {
        print(&words::fill("doctor-faults", &json!({"count": faults})));
    }
    let codes = findings.iter().map(code);
    codes.max_by_key(|code| *code != BUILT).unwrap_or(BUILT)
}

/// The exit code of a finding.
fn code(finding: &Finding) -> u8 {
    match finding {
        Finding::Fault(fault) => exit_code::of_error(fault),
        Finding::NoCycle(_) => BAD_INPUT,
        Finding::Open(_) => NO_SUCH_CAM,
        Finding::Design(design) => exit_code::of(design.verdict),
        _ => BUILT,
    }
}

fn sentence(file: &Path, finding: &Finding) -> String {
    let language = language::current();
    let catalogue = gaitcam::wording::catalogue(language);
    let shown = |path: &Path| path.display().to_string();
    match finding {
        Finding::Fault(fault) | Finding::NoCycle(fault) => fault.sentence(language),
        Finding::Table(keys) => {
            let data = json!({"file": shown(file), "keys": keys});
            words::fill("doctor-toml", &data)
        }
        Finding::KeysRight => words::text("doctor-keys-right"),
        Finding::OneCycle(file, period) => {
            let data = json!({"file": shown(file), "period": words::fixed(*period, 3)});
            words::fill("doctor-one-cycle", &data)
        }
        Finding::Recording(file, columns, used, rejected) => words::fill(
            "doctor-recording",
            &json!({"file": shown(file), "columns": columns, "used": used, "rejected": rejected}),
        ),
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
