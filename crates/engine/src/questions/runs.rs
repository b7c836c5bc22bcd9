//! The finished cam in motion, and a grid of designs.

use std::thread::available_parallelism;

use serde::Deserialize;
use serde_json::{Value, json};

use crate::fault::StudioError;
use crate::questions::design::{Which, made};
use crate::sources::Files;
use crate::{table, words};
use gaitcam::dynamics::{self, Model};
use gaitcam::error::Result;
use gaitcam::sweep::{Axis, NamedScene, Plan, Sampling, Study, Subject};
use gaitcam_output::{plots, simulation};

/// Most designs of a sweep.
const MOST: u64 = 900;

/// Runs the emitted cam of a scene: the numbers of `gaitcam simulate --json`, its table and its picture; `why` alone
/// where there is no cam.
///
/// # Errors
/// Faults of the scene and of its machine.
pub fn simulate(files: &Files, which: &Which) -> Result<Value> {
    let made = made(files, table(&which.scene)?)?;
    let (design, language) = (&made.design, words::current());
    if let Some(why) = design.no_cam(language) {
        return Ok(json!({"why": why}));
    }
    let run = design.emitted(&made.scene.machine, design.drive)?;
    let outcome = dynamics::simulate(&run, Model::Auto)?;
    let measures = design.cam.follower.measures();
    Ok(json!({
        "simulation": simulation::json(&outcome),
        "table": simulation::table(&outcome, measures, language),
        "picture": plots::run(design, &outcome, language).svg(),
    }))
}

/// Designs over one or two keys of a scene.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Grid {
    /// The scene file.
    pub scene: String,
    /// Keys with their values, as `gaitcam sweep --vary` takes them: `limits.stroke=50 mm:70 mm:9`.
    pub vary: Vec<String>,
    /// Column of the figure that is asked for.
    pub column: String,
}

/// Verdict and one figure of each design of a grid, row by row, the last key fastest; none where time ran out.
///
/// # Errors
/// Keys or values that cannot be varied, more than 900 designs, recordings that are not there.
pub fn sweep(files: &Files, asked: &Grid) -> Result<Value> {
    let (scene, table) = files.scene(&table(&asked.scene)?)?;
    let name = scene.name;
    let axes: Result<Vec<Axis>> = asked.vary.iter().map(|v| Axis::parse(v, false)).collect();
    let plan = Plan {
        scenes: vec![NamedScene { name, table }],
        list: None,
        axes: axes?,
        sampling: Sampling::Grid,
    };
    let columns = plan
        .keys()
        .iter()
        .map(|key| key.column())
        .collect::<Vec<_>>();
    let read = |_: usize, path: &std::path::Path| Ok(files.bytes(path)?.1.to_vec());
    let study = Study::new(Subject::Designs(plan), read)?;
    let rows = study.rows()?;
    if rows > MOST {
        let fault = format!("{rows} > {MOST}");
        return Err(StudioError::BadRequest { fault }.into());
    }
    let halt = files.host.halt();
    let jobs = available_parallelism().map_or(1, usize::from);
    let records = study.run(0..rows, jobs, &|| halt.clone(), &|| halt.is_asked())?;
    let records = records.unwrap_or_default();
    let numbers = |column: &String| json!(records.numbers(column));
    let verdicts = records.words("verdict");
    let verdicts = verdicts.map(|v| (0..records.len()).map(|i| v.at(i)).collect::<Vec<_>>());
    Ok(json!({
        "keys": columns.iter().map(numbers).collect::<Vec<_>>(),
        "values": numbers(&asked.column),
        "verdicts": verdicts,
    }))
}
