//! `gaitcam doctor FILE`: what is wrong with a scene or a recording, all of it at once, and what cures it.
//!
//! The same functions as in `synth` and `gait`, one step after another; a scene's faulty keys are set aside so that
//! those behind them are found too.

use std::path::{Path, PathBuf};

use clap::Args;
use gaitcam::cam::Verdict;
use gaitcam::error::{Error, Place, Result};
use gaitcam::force::{self, Feet, Interpretation, ReadOptions};
use gaitcam::scene::{self, Scene};
use gaitcam::synth::{Search, answer, sentences};
use serde_json::json;
use toml::Table;

use crate::console::exit_code::{self, BAD_INPUT, BUILT, NO_SUCH_CAM};
use crate::console::language;
use crate::console::terminal::print;
use crate::console::words;
use crate::input::searching::TimeLimit;
use crate::input::{self, SceneArgs};
use gaitcam_app::Input;
use gaitcam_app::disk::metadata;
use gaitcam_app::read::read_bytes;

const EXAMPLES: &str = "Examples:
  gaitcam doctor my.toml
  gaitcam doctor walk.c3d";

/// Maximum number of listed faults of one scene.
const MOST: usize = 25;

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
    let scene = ending.is_none_or(|e| e == "toml" || e == "json");
    if scene {
        examine_scene(args)
    } else {
        let options = ReadOptions {
            metadata: metadata(&args.file),
            ..ReadOptions::default()
        };
        examine_recording(&args.file, &read_bytes(&args.file)?, &options)
    }
}

fn good(text: &str) {
    print(&format!("✓ {text}"));
}

fn bad(text: &str) {
    print(&format!("✗ {text}"));
}

fn doubtful(text: &str) {
    print(&format!("? {text}"));
}

/// A message of this verb, by its key.
fn finding(key: &str, data: &serde_json::Value) -> String {
    words::fill(&format!("doctor-{key}"), data)
}

fn examine_scene(args: &DoctorArgs) -> Result<u8> {
    let (table, files, _) = input::written(&SceneArgs::of(args.file.clone()))?;
    let file = args.file.display().to_string();
    good(&finding(
        "toml",
        &json!({"file": file, "keys": leaves(&table)}),
    ));
    let whole = files.with_motions(&table)?;
    let (scene, faults) = read_what_is_right(&whole);
    for fault in &faults {
        bad(&fault.sentence(language::current()));
    }
    let Some(scene) = scene.filter(|_| faults.is_empty()) else {
        print(&finding("faults", &json!({"count": faults.len()})));
        return Ok(BAD_INPUT);
    };
    good(&words::text("doctor-keys-right"));
    let input = Input {
        scene,
        table,
        whole,
        files,
        file: None,
    };
    if let Some(gait) = &input.scene.gait
        && let Some((place, bytes, options)) = gait.recording(&input.files)?
    {
        let code = examine_recording(&place, &bytes, &options)?;
        if code != BUILT {
            return Ok(code);
        }
    }
    examine_design(&input, args.time)
}

/// Number of values in a table.
fn leaves(table: &Table) -> usize {
    let count = |value: &toml::Value| match value {
        toml::Value::Table(table) => leaves(table),
        toml::Value::Array(list) => list
            .iter()
            .filter_map(toml::Value::as_table)
            .map(leaves)
            .sum::<usize>()
            .max(1),
        _ => 1,
    };
    table.values().map(count).sum()
}

/// The scene without its invalid keys, and the fault of each.
fn read_what_is_right(table: &Table) -> (Option<Scene>, Vec<Error>) {
    let mut left = table.clone();
    let mut faults: Vec<Error> = Vec::new();
    while faults.len() < MOST {
        let fault = match scene::read(&left) {
            Ok(scene) => return (Some(scene), faults),
            Err(fault) => fault,
        };
        // A key that is missing because it was removed above is not reported again.
        if faults.iter().any(|known| known.place == fault.place) {
            break;
        }
        let key = match &fault.place {
            Place::Key(key) => key.clone(),
            _ => String::new(),
        };
        faults.push(fault);
        if !scene::unset(&mut left, &key) {
            break;
        }
    }
    (None, faults)
}

fn examine_recording(path: &Path, bytes: &[u8], options: &ReadOptions) -> Result<u8> {
    let file = path.display().to_string();
    if let Some(curve) = force::one_cycle(path, bytes, options)? {
        good(&finding(
            "one-cycle",
            &json!({"file": file, "period": words::fixed(curve.period_s, 3)}),
        ));
        return Ok(BUILT);
    }
    let recording = match force::read(path, bytes, options) {
        Ok(recording) => recording,
        Err(fault) => {
            bad(&fault.sentence(language::current()));
            print(&words::text("doctor-recording-options"));
            return Ok(BAD_INPUT);
        }
    };
    let stances = force::stances(&recording);
    let cycle = force::cycle(&recording, &stances, Feet::Both);
    let understood =
        Interpretation::of(&file, &recording, &stances, cycle.as_ref().ok(), Feet::Both);
    let (used, left_out) = understood.counts();
    good(&finding(
        "recording",
        &json!({"file": file, "columns": understood.columns.len(), "used": used, "rejected": left_out}),
    ));
    let sentences = gaitcam::wording::catalogue(language::current());
    for warning in &understood.warnings {
        doubtful(&sentences.sentence("note", warning));
    }
    if let Err(fault) = cycle {
        bad(&fault.sentence(language::current()));
        print(&words::text("doctor-recording-options"));
        return Ok(BAD_INPUT);
    }
    let doubts = understood.doubts();
    for doubt in &doubts {
        let sentence = sentences.sentence("open", doubt);
        bad(&finding(
            if doubt.is_acceptable() {
                "doubt"
            } else {
                "unacceptable"
            },
            &json!({"sentence": sentence, "name": doubt.name()}),
        ));
    }
    Ok(if doubts.is_empty() {
        BUILT
    } else {
        NO_SUCH_CAM
    })
}

fn examine_design(input: &Input, time: TimeLimit) -> Result<u8> {
    let target = input.target()?;
    let shown = time.shown();
    let search = Search::until(time.of_design());
    let outcome = answer(&input.scene, target.as_ref(), &search);
    let design = match outcome.and_then(|outcome| outcome.relaxed_with(&search).built()) {
        Ok(design) => design,
        Err(fault) => {
            bad(&fault.sentence(language::current()));
            return Ok(exit_code::of_error(&fault));
        }
    };
    drop(shown);
    let text = sentences(&design.reasons, language::current());
    let verdict = words::name(design.verdict.name());
    let line = format!("{verdict}: {text}");
    match design.verdict {
        Verdict::Acceptable => good(&line),
        Verdict::NotForHighSpeed => doubtful(&line),
        Verdict::Unacceptable => bad(&line),
    }
    Ok(exit_code::of(design.verdict))
}
