//! Requests that need longer computations: simulation of the cam, identification from a machine log, and a grid of designs.

use std::path::Path;
use std::thread::available_parallelism;

use serde::Deserialize;
use serde_json::{Value, json};

use crate::page::fault::StudioError;
use crate::page::hash::Hash;
use crate::page::kept::CachedDesign;
use crate::page::questions::design::{Which, made};
use crate::page::sources::Files;
use crate::page::{table, words};
use crate::{SweepQuestion, Varied};
use gaitcam::dynamics::{self, Model};
use gaitcam::error::Result;
use gaitcam::identify::{self, Log, LogOptions};
use gaitcam::scene::set_value;
use gaitcam::sweep::{NamedScene, Records};
use gaitcam::synth::Search;
use gaitcam::wording::{Language, number};
use gaitcam_output::report::parts;
use gaitcam_output::{facts, identification, identified, plots, simulation};

/// Maximum number of designs in a grid.
const MOST: u64 = 900;

/// Simulates the cam of a scene. The lift is recovered from the points of the exported profile instead of the exact law. The response contains the
/// data of `gaitcam simulate --json`, a table and a figure. If there is no cam, it contains only the reason, `why`.
///
/// # Errors
///
/// The scene or its machine is invalid.
pub fn simulate(files: &Files, which: &Which) -> Result<Value> {
    let made = made(files, table(&which.scene)?)?;
    let (design, language) = (&made.design, words::current());
    if let Some(why) = design.no_cam(language) {
        return Ok(json!({"why": why}));
    }
    let run = design.emitted(&made.scene.machine, design.problem.drive)?;
    let outcome = dynamics::simulate(&run, Model::Auto)?;
    let measures = design.cam.follower.measures();
    Ok(json!({
        "simulation": simulation::json(&outcome),
        "rows": simulation::rows(&outcome, measures, language),
        "picture": plots::run(design, &outcome, language).svg(),
    }))
}

/// Comparison of two responses of a lightly damped mode. The first is the response to the cam, whose excitation is exactly periodic. The
/// second is the response to the recorded walk. The result contains a sentence, a table and a figure. It is empty if fewer than eight
/// consecutive strides are recorded.
///
/// # Errors
///
/// The scene is invalid.
pub fn resonance(files: &Files, which: &Which) -> Result<Value> {
    let made = made(files, table(&which.scene)?)?;
    let (design, language) = (&made.design, words::current());
    let Some(walker) = design.walker() else {
        return Ok(json!({}));
    };
    let (columns, rows) = facts::at_resonance(&walker, language);
    Ok(json!({
        "sentence": facts::resonance(design, language),
        "columns": columns,
        "rows": rows,
        "picture": plots::resonance(design, language).svg(),
    }))
}

/// Request to identify a machine from its log.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Logged {
    /// TOML text of the scene for which the running cam was designed.
    pub scene: String,
    /// Name of the log file.
    pub log: String,
    /// Hash of the bytes of the log.
    pub hash: Hash,
}

/// Machine identified from a log, as text and figure, and the scene of the next cam. Without a cam, the response contains only the reason,
/// `why`.
///
/// # Errors
///
/// The scene or the log is invalid.
pub fn identify(files: &Files, asked: &Logged) -> Result<Value> {
    let log = Log::read(
        Path::new(&asked.log),
        &files.engine.kept(&asked.hash).unwrap_or_default(),
        &LogOptions::default(),
    )?;
    let logs = [log];
    let made = made(files, table(&asked.scene)?)?;
    let (design, language) = (&made.design, words::current());
    if let Some(why) = design.no_cam(language) {
        return Ok(json!({"why": why}));
    }
    let found = identify::identify(design, &made.scene, &logs)?;
    let next = next(files, &made, &logs);
    Ok(json!({
        "lines": identified::lines(&made.scene, &found, language),
        "picture": identification(design, &found, language).svg(),
        "next": next.unwrap_or_else(|e| json!({"why": e.what(language)})),
    }))
}

/// Scene of the next cam, with the measured force error before the correction and the predicted force error after it, N.
fn next(files: &Files, made: &CachedDesign, logs: &[Log]) -> Result<Value> {
    let force = files.target(&made.scene)?.map(|(force, _)| force);
    let search = Search::until(files.host.halt());
    let (scene, figures, _) =
        identify::recut(&made.design, &made.scene, force.as_ref(), logs, &search)?;
    let mut table = made.table.clone();
    let learned = scene.to_table()["machine"]["learned_force"].clone();
    set_value(&mut table, "machine.learned_force", learned)?;
    let number = |x: f64| number(words::current(), x);
    Ok(json!({
        "scene": toml::to_string(&table).unwrap_or_default(),
        "before": number(figures.before_rms_n),
        "after": number(figures.predicted_rms_n),
    }))
}

/// Request for a grid of designs over one or two keys of a scene.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Grid {
    /// TOML text of the scene.
    pub scene: String,
    /// Keys with their values in the syntax of `gaitcam sweep --vary`: `limits.stroke=50 mm:70 mm:9`.
    pub vary: Vec<String>,
    /// Column name of the requested key figure.
    pub column: String,
}

/// Verdict and requested key figure of each design of a grid, row by row. The last key varies fastest. The values of a design are null if
/// the time limit ended its computation.
///
/// # Errors
///
/// A key or a value cannot be varied, there are more than 900 designs, or a recording is missing.
pub fn sweep(files: &Files, asked: &Grid) -> Result<Value> {
    let (_, table) = files.scene(&table(&asked.scene)?)?;
    let question = SweepQuestion {
        scenes: vec![NamedScene::of(table)],
        vary: asked.vary.iter().cloned().map(Varied::Text).collect(),
        ..SweepQuestion::default()
    };
    let sweep = question.sweep(|_| files)?;
    let keys = sweep.keys();
    let rows = sweep.rows()?;
    if rows > MOST {
        let fault = format!("{rows} > {MOST}");
        return Err(StudioError::BadRequest { fault }.into());
    }
    let halt = files.host.halt();
    let jobs = available_parallelism().map_or(1, usize::from);
    let records = sweep.run(0..rows, jobs, &|| halt.clone(), &|| halt.is_asked())?;
    let records = records.unwrap_or_default();
    let numbers = |column: &String| json!(records.numbers(column));
    let texts = |column: &str| {
        let all = records.words(column);
        all.map(|words| (0..records.len()).map(|i| words.at(i)).collect::<Vec<_>>())
    };
    Ok(json!({
        "keys": keys.iter().map(|key| numbers(&key.column())).collect::<Vec<_>>(),
        "values": numbers(&asked.column),
        "verdicts": texts("verdict"),
        "why": why(&records, words::current()),
    }))
}

/// Reasons why designs of a grid are not acceptable, row by row. A reason is the error of the scene, or a list of the violated or
/// conflicting limits.
fn why(records: &Records, language: Language) -> Vec<String> {
    let at = |column: &str, i: usize| {
        let words = records.words(column);
        words.and_then(|w| w.at(i)).unwrap_or_default().to_string()
    };
    let limits = |i: usize| {
        let list = match at("failed", i) {
            failed if failed.is_empty() && at("verdict", i).is_empty() => at("binding", i),
            failed => failed,
        };
        let names = list.split('+').filter(|name| !name.is_empty());
        let names: Vec<String> = names.map(|name| parts::name(name, language)).collect();
        names.join(", ")
    };
    let of = |i: usize| match at("error", i) {
        error if error.is_empty() => limits(i),
        error => error,
    };
    (0..records.len()).map(of).collect()
}
