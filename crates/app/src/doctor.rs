//! Diagnosis of a scene or a recording: a list of all errors, with suggested changes.
//!
//! The diagnosis performs the steps of the commands `synth` and `gait` one by one. Invalid keys are removed from the scene, so that errors in other
//! keys are also reported.

use std::path::Path;

use gaitcam::cam::Verdict;
use gaitcam::error::{Error, Place, Result};
use gaitcam::force::{self, Feet, Interpretation, Note, OpenQuestion, ReadOptions};
use gaitcam::scene::{self, Scene};
use gaitcam::synth::{Design, Search, answer};
use serde_json::{Value, json};
use toml::Table;

use crate::disk::{Disk, metadata};
use crate::read::read_bytes;
use crate::scene::Input;

/// Maximum number of errors that are listed for one scene.
const MOST: usize = 25;

/// Result of the diagnosis of one part of a scene or recording.
#[derive(Debug, Clone)]
pub enum Finding {
    /// A valid part: the key of its message and the data of the message.
    Good(&'static str, Value),
    /// An error in a key or in a file.
    Fault(Error),
    /// Reason why a recording has no usable cycle.
    NoCycle(Error),
    /// An assumption, an exclusion or an implausible value.
    Note(Note),
    /// An open question that only the user can answer.
    Open(OpenQuestion),
    /// The design for the scene, with its verdict.
    Design(Box<Design>),
}

/// Severity of a finding: no action, a check by the user, or an error.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mark {
    /// The finding needs no action.
    Good,
    /// The user should check the finding.
    Doubtful,
    /// The finding is an error, an open question, or an unacceptable design.
    Bad,
}

impl Finding {
    /// Severity of the finding. For a design, it follows from the verdict.
    pub fn mark(&self) -> Mark {
        match self {
            Finding::Fault(_) | Finding::NoCycle(_) | Finding::Open(_) => Mark::Bad,
            Finding::Note(_) => Mark::Doubtful,
            Finding::Design(design) => match design.verdict {
                Verdict::Acceptable => Mark::Good,
                Verdict::NotForHighSpeed => Mark::Doubtful,
                Verdict::Unacceptable => Mark::Bad,
            },
            Finding::Good(..) => Mark::Good,
        }
    }
}

/// Whether the path is examined as a recording. Paths with the extension `toml` (scene) or `json` (summary), and paths without an extension
/// (built-in scenes), are examined as scenes.
pub fn is_recording(path: &Path) -> bool {
    let ending = path.extension().map(|e| e.to_ascii_lowercase());
    ending.is_some_and(|e| e != "toml" && e != "json")
}

/// Findings about a recording on the disk.
///
/// # Errors
///
/// The file cannot be read, or its cycle is invalid.
pub fn recording_file(path: &Path) -> Result<Vec<Finding>> {
    let options = ReadOptions {
        metadata: metadata(path),
        ..ReadOptions::default()
    };
    recording(path, &read_bytes(path)?, &options)
}

/// Findings about a recording in memory.
///
/// # Errors
///
/// The cycle is invalid.
pub fn recording(path: &Path, bytes: &[u8], options: &ReadOptions) -> Result<Vec<Finding>> {
    let file = path.display().to_string();
    if let Some(curve) = force::one_cycle(path, bytes, options, Feet::Both)? {
        let data = json!({"file": file, "period": (1e3 * curve.period_s).round() / 1e3});
        return Ok(vec![Finding::Good("one-cycle", data)]);
    }
    let recording = match force::read(path, bytes, options) {
        Ok(recording) => recording,
        Err(fault) => return Ok(vec![Finding::NoCycle(fault)]),
    };
    let stances = force::stances(&recording);
    let cycle = force::cycle(&recording, &stances, Feet::Both);
    let mean = cycle.as_ref().ok();
    let understood = Interpretation::of(&file, &recording, &stances, mean, Feet::Both);
    let (used, left_out) = understood.counts();
    let columns = understood.columns.len();
    let data = json!({"file": file, "columns": columns, "used": used, "rejected": left_out});
    let mut out = vec![Finding::Good("recording", data)];
    out.extend(understood.warnings.iter().cloned().map(Finding::Note));
    match cycle {
        Ok(_) => out.extend(understood.doubts().into_iter().map(Finding::Open)),
        Err(fault) => out.push(Finding::NoCycle(fault)),
    }
    Ok(out)
}

/// Findings about a scene and its recording. The scene is also returned if none of the findings is an error or an open question. `name` is
/// the name of the scene in messages.
///
/// # Errors
///
/// A motion or a recording cannot be read.
pub fn scene(name: &str, table: Table, files: Disk) -> Result<(Vec<Finding>, Option<Input>)> {
    let data = json!({"file": name, "keys": leaves(&table)});
    let mut out = vec![Finding::Good("toml", data)];
    let whole = files.with_motions(&table)?;
    let (scene, faults) = read_what_is_right(&whole);
    let is_right = faults.is_empty();
    out.extend(faults.into_iter().map(Finding::Fault));
    let Some(scene) = scene.filter(|_| is_right) else {
        return Ok((out, None));
    };
    out.push(Finding::Good("keys-right", Value::Null));
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
        out.extend(recording(&place, &bytes, &options)?);
    }
    let is_bad = out.iter().any(|f| f.mark() == Mark::Bad);
    Ok((out, (!is_bad).then_some(input)))
}

/// Designs the scene, with suggested changes if the design is unacceptable. The finding is the design or an error.
///
/// # Errors
///
/// The load model, the force file or the recording of the scene is invalid.
pub fn design(input: &Input, search: &Search) -> Result<Finding> {
    let target = input.target()?;
    let outcome = answer(&input.scene, target.as_ref(), search);
    let design = outcome.and_then(|outcome| outcome.relaxed_with(search).built());
    Ok(match design {
        Ok(design) => Finding::Design(Box::new(design)),
        Err(fault) => Finding::Fault(fault),
    })
}

/// Number of values in a table, including those in nested tables.
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

/// The scene without its invalid keys, and the error of each removed key. The scene is `None` if it remains invalid after the removal.
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
