//! Recordings dropped on the page: contents, choice of contacts, and hand-drawn forces.

use std::collections::BTreeMap;
use std::path::Path;

use serde::Deserialize;
use serde_json::{Value, json};

use crate::page::fault::StudioError;
use crate::page::hash::Hash;
use crate::page::sources::Files;
use crate::page::words;
use gaitcam::error::Result;
use gaitcam::force::{self, Feet, Interpretation, ReadOptions, Stances};
use gaitcam::scene;
use gaitcam_output::gait as tables;
use gaitcam_output::recording;

/// A recording that the user dropped on the page.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Dropped {
    /// Name of the dropped file.
    pub file: String,
    /// Hash of its bytes.
    pub hash: Hash,
    /// Reading options: keys of `gait` with their values.
    #[serde(default)]
    pub options: BTreeMap<String, String>,
}

/// Contents of a recording.
///
/// # Errors
/// Files that are not recordings.
pub fn dropped(files: &Files, asked: &Dropped) -> Result<Value> {
    let contacts = Contacts {
        file: plain(&asked.file),
        hash: asked.hash.clone(),
        without: Vec::new(),
        feet: String::new(),
        options: asked.options.clone(),
    };
    self::contacts(files, &contacts)
}

/// Last component of a path, without characters that file names cannot contain.
fn plain(given: &str) -> String {
    let last = given.rsplit(['/', '\\']).next().unwrap_or("");
    let name: String = last
        .chars()
        .filter(|c| !c.is_control() && !":*?\"<>|".contains(*c))
        .collect();
    match name.trim_start_matches('.') {
        "" => "recording.csv".to_string(),
        name => name.to_string(),
    }
}

/// Excluded contacts of a recording.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Contacts {
    /// Name of the recording.
    pub file: String,
    /// Hash of its bytes.
    pub hash: Hash,
    /// Numbers of the excluded stances, from 0 on.
    #[serde(default)]
    pub without: Vec<usize>,
    /// Feet whose stances count.
    #[serde(default)]
    pub feet: String,
    /// Reading options: keys of `gait` with their values.
    #[serde(default)]
    pub options: BTreeMap<String, String>,
}

/// The recording with some contacts left out: its mean cycle becomes a file of its own, which the scene may
/// name.
///
/// # Errors
/// Missing recordings; nothing left to average.
pub fn contacts(files: &Files, asked: &Contacts) -> Result<Value> {
    let bytes = files.engine.kept(&asked.hash).unwrap_or_default();
    let mut found = described(&bytes, asked)?;
    found["hash"] = asked.hash.as_str().into();
    found["use_hash"] = asked.hash.as_str().into();
    if !asked.without.is_empty()
        && let Some(csv) = found.get("csv").and_then(Value::as_str)
    {
        let stem = Path::new(&asked.file)
            .file_stem()
            .unwrap_or_default()
            .to_string_lossy();
        let name = format!("{}_cycle.csv", plain(&stem));
        let hash = files.engine.keep(csv.as_bytes().to_vec());
        found["use"] = name.into();
        found["use_hash"] = hash.as_str().into();
    }
    Ok(found)
}

/// Reading options of a recording, as `gait` of a scene.
fn options(asked: &Contacts) -> Result<(ReadOptions, Feet)> {
    let mut table = toml::Table::new();
    scene::set(
        &mut table,
        &format!("gait.file={}", toml::Value::from(asked.file.as_str())),
    )?;
    for (key, value) in &asked.options {
        scene::set(&mut table, &format!("gait.{key}={value}"))?;
    }
    let read = scene::read(&table)?;
    let gait = read.gait.unwrap_or_default();
    let feet = asked.feet.parse().unwrap_or(gait.feet);
    Ok((gait.read_options(None)?, feet))
}

/// Contents of a recording, with its picture and the csv of its mean cycle.
fn described(bytes: &[u8], asked: &Contacts) -> Result<Value> {
    let (name, without) = (asked.file.as_str(), &asked.without);
    let (path, language) = (Path::new(name), words::current());
    let (options, feet) = options(asked)?;
    if let Some(curve) = force::one_cycle(path, bytes, &options, feet)? {
        let mut found = tables::cycle_json(&curve);
        found["file"] = name.into();
        found["use"] = name.into();
        found["table"] = tables::cycle_table(&curve, language).into();
        return Ok(found);
    }
    let recording = force::read(path, bytes, &options)?;
    let all = force::stances(&recording);
    let kept = all
        .used
        .iter()
        .enumerate()
        .filter(|(i, _)| !without.contains(i));
    let stances = Stances {
        used: kept.map(|(_, s)| s.clone()).collect(),
        ..all.clone()
    };
    let cycle = force::cycle(&recording, &stances, feet)?;
    let understood = Interpretation::of(name, &recording, &stances, Some(&cycle), feet);
    let mut found = tables::json(&understood, &recording, &all, Some(&cycle));
    found["file"] = name.into();
    found["use"] = name.into();
    found["table"] = tables::table(
        &understood,
        &recording,
        &stances,
        Ok(&cycle),
        false,
        language,
    )
    .into();
    found["without"] = json!(without);
    let picture = recording::recording(&understood, Some(&cycle.curve), language);
    found["picture"] = picture.svg().into();
    let source = cycle.source.to_string();
    found["csv"] = cycle.curve.to_csv(&[name, &source]).into();
    Ok(found)
}

/// A force drawn by hand: points of one cycle.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Points {
    /// Name of the force file in the scene.
    pub file: String,
    /// Duration of one cycle, s.
    pub period_s: f64,
    /// Time (s) and force (N) of each point.
    pub points: Vec<[f64; 2]>,
}

/// Keeps points as a file of one cycle; the curve goes through them, level at every peak and valley.
///
/// # Errors
/// Too few points, or times that do not increase.
pub fn points(files: &Files, drawn: &Points) -> Result<Value> {
    let name = plain(&drawn.file);
    let mut points = drawn.points.clone();
    points.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let finite = drawn.period_s.is_finite() && points.iter().flatten().all(|x| x.is_finite());
    if points.len() < 3 || points.len() > 400 || !finite {
        return Err(StudioError::FewPoints.into());
    }
    let mut csv = format!(
        "# critical points, period_s = {}\ntime_s,force_n\n",
        drawn.period_s
    );
    for [time, force] in &points {
        csv.push_str(&format!("{time},{force}\n"));
    }
    let curve = force::one_cycle(
        Path::new(&name),
        csv.as_bytes(),
        &ReadOptions::default(),
        Feet::Both,
    )?;
    let hash = files.engine.keep(csv.clone().into_bytes());
    Ok(json!({"use": name, "csv": csv, "hash": hash, "force_n": curve.map(|c| c.force_n)}))
}
