//! Recordings that the user drops on the page: their contents, the selection of contacts, and forces drawn by hand.

use std::collections::BTreeMap;
use std::path::Path;

use serde::Deserialize;
use serde_json::{Value, json};

use crate::page::fault::StudioError;
use crate::page::hash::Hash;
use crate::page::sources::Files;
use crate::page::{self, words};
use gaitcam::Problem;
use gaitcam::error::Result;
use gaitcam::force::{
    self, Feet, ForceCurve, Interpretation, Note, OpenQuestion, ReadOptions, Stances,
};
use gaitcam::scene::{self, Source};
use gaitcam::units::G;
use gaitcam_output::gait as tables;
use gaitcam_output::recording;

/// Request for the contents of a recording that the user dropped on the page.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Dropped {
    /// Name of the dropped file.
    pub file: String,
    /// Hash of the bytes of the file.
    pub hash: Hash,
    /// Options for reading the recording: keys of `gait` with their values.
    #[serde(default)]
    pub options: BTreeMap<String, String>,
}

/// Contents of a dropped recording.
///
/// # Errors
///
/// The file is not a recording.
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

/// Last component of a path, without the characters that are not allowed in file names.
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

/// Request for a recording without some of its contacts.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Contacts {
    /// File name of the recording.
    pub file: String,
    /// Hash of the bytes of the file.
    pub hash: Hash,
    /// Numbers of the excluded stances, counted from 0.
    #[serde(default)]
    pub without: Vec<usize>,
    /// Feet from which stances are used, as text (see the key `gait.feet`).
    #[serde(default)]
    pub feet: String,
    /// Options for reading the recording: keys of `gait` with their values.
    #[serde(default)]
    pub options: BTreeMap<String, String>,
}

/// Contents of a recording without the excluded contacts. If contacts are excluded, the mean cycle of the remaining contacts is stored as a
/// file for the scene.
///
/// # Errors
///
/// The recording is missing, or no stances remain.
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

/// Options for reading a recording, parsed in the same way as the keys of `gait` in a scene.
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

/// Contents of a recording, with a figure and with the mean cycle as CSV.
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
    let mut said = vec![name.to_string(), cycle.source.to_string()];
    said.extend(open_line(understood.doubts()));
    said.push("steps_per_turn = 2".to_string());
    let said: Vec<&str> = said.iter().map(String::as_str).collect();
    found["csv"] = cycle.curve.to_csv(&said).into();
    Ok(found)
}

/// Keys of `gait` for reading a recording. They do not apply to the file with the mean cycle.
const READER: [&str; 9] = [
    "time", "force", "unit", "rate", "mass", "kind", "period", "span", "noise",
];

/// Comment line of a mean-cycle file that lists the acceptable open questions about the recording; `None` without such questions.
fn open_line(mut open: Vec<OpenQuestion>) -> Option<String> {
    open.retain(|question| question.is_acceptable());
    let names: Vec<&str> = open.into_iter().map(OpenQuestion::name).collect();
    (!names.is_empty()).then(|| format!("open = {}", names.join(" ")))
}

/// Request to replace the recording of a scene by its mean cycle.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Whole {
    /// TOML text of the scene.
    pub scene: String,
}

/// Scene in which a small file with the mean cycle replaces the recording. The design of the scene does not change.
///
/// # Errors
///
/// The scene or its recording is invalid. The scene has no force file or has several walkers. An open question about the recording cannot
/// be accepted.
pub fn mean_cycle(files: &Files, asked: &Whole) -> Result<Value> {
    let mut table = page::table(&asked.scene)?;
    let (scene, _) = files.scene(&table)?;
    let target = files.target(&scene)?;
    let (Some((curve, _)), Some(gait)) = (target, &scene.gait) else {
        return Err(StudioError::NoCycle.into());
    };
    let Source::File(file) = &gait.source else {
        return Err(StudioError::NoCycle.into());
    };
    if curve.population.is_some() {
        return Err(StudioError::NoCycle.into());
    }
    let notes = curve
        .recording
        .as_ref()
        .map_or(&curve.notes, |r| &r.warnings);
    let problem = Problem::resolve(&scene, Some(&curve)).ok();
    let is_open = |question: &OpenQuestion| {
        let left = problem.iter().flat_map(|p| &p.open_questions);
        let mut left = left.map(|(question, _)| question).chain(&gait.accept);
        problem.is_none() || left.any(|other| other == question)
    };
    let open: Vec<OpenQuestion> = Note::doubts(notes).into_iter().filter(is_open).collect();
    if open.iter().any(|question| !question.is_acceptable()) {
        return Err(StudioError::NoCycle.into());
    }
    let is_open = !open.is_empty();
    let mut said = vec![format!("file: {}", file.display())];
    said.extend(open_line(open));
    let steps = curve.recording.as_ref().map_or(curve.steps, |_| Some(2));
    said.extend(steps.map(|steps| format!("steps_per_turn = {steps}")));
    // The body weight of the walker is taken from the recording.
    let weighed = match gait.period {
        Some(_) => None,
        None if curve.recording.is_some() => curve
            .mass_kg
            .or(Some(curve.mean_n() / gait.feet.share() / G)),
        None => curve.mass_kg,
    };
    let curve = ForceCurve {
        mass_kg: weighed,
        ..curve
    };
    let said: Vec<&str> = said.iter().map(String::as_str).collect();
    let csv = curve.to_csv(&said);
    let stem = file.file_stem().unwrap_or_default().to_string_lossy();
    let name = format!("{}_cycle.csv", plain(stem.trim_end_matches("_cycle")));
    scene::set(
        &mut table,
        &format!("gait.file={}", toml::Value::from(name.as_str())),
    )?;
    for key in READER {
        scene::unset(&mut table, &format!("gait.{key}"));
    }
    if !is_open {
        scene::unset(&mut table, "gait.accept");
    }
    let hash = files.engine.keep(csv.clone().into_bytes());
    Ok(json!({
        "scene": toml::to_string(&table).unwrap_or_default(),
        "file": file, "use": name, "hash": hash, "csv": csv,
    }))
}

/// Request to store a force that the user drew by hand, as points of one cycle.
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

/// Stores points as a file with one cycle. The force curve passes through the points, with a horizontal tangent at each maximum and minimum.
///
/// # Errors
///
/// There are fewer than 3 or more than 400 points, a number is not finite, or the points do not define a valid cycle.
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

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::page::kept::{Engine, Host, Start};
    use crate::page::sources::Named;
    use gaitcam::error::Placed;
    use gaitcam::halt::Halt;

    /// Host of a page without a folder.
    struct Page;

    impl Host for Page {
        fn read(&self, path: &Path) -> Result<(Hash, Arc<Vec<u8>>)> {
            Err(StudioError::NotDropped.in_file(path))
        }

        fn seconds(&self) -> f64 {
            0.0
        }

        fn halt(&self) -> Halt {
            Halt::never()
        }

        fn start(&self) -> Start {
            Start::default()
        }
    }

    const WALK: &str = include_str!("../../../../../data/recordings/made_walk.csv");

    /// Problem of a scene, and problem of the same scene with the mean cycle as its only file.
    fn packed(recording: &str, gait: &str) -> [Problem; 2] {
        let engine = Engine::default();
        let mut scene = format!(
            "[gait]\nfile = \"walk.csv\"\n{gait}\n[drive]\nmass = \"auto\"\nspeed = \"auto\"\n[law]\nfamily = \"spline\"\n"
        );
        let mut named = Named {
            name: "walk.csv".to_string(),
            hash: engine.keep(recording.as_bytes().to_vec()),
        };
        let problem = |scene: &str, named: &Named| {
            let files = Files::new(&engine, &Page, vec![named.clone()]);
            let scene = files.scene(&page::table(scene).unwrap()).unwrap().0;
            let target = files.target(&scene).unwrap().unwrap().0;
            Problem::resolve(&scene, Some(&target)).unwrap()
        };
        let whole = problem(&scene, &named);
        let files = Files::new(&engine, &Page, vec![named.clone()]);
        let asked = Whole { scene };
        let made = mean_cycle(&files, &asked).unwrap();
        scene = made["scene"].as_str().unwrap().to_string();
        named = Named {
            name: made["use"].as_str().unwrap().to_string(),
            hash: engine.keep(made["csv"].as_str().unwrap().as_bytes().to_vec()),
        };
        [whole, problem(&scene, &named)]
    }

    #[test]
    fn the_mean_cycle_is_the_same_problem_as_its_recording() {
        for gait in [
            "",
            "feet = \"one\"",
            "mass = \"71 kg\"\nkind = \"walking\"",
            "force = \"Left Fz\"\nfeet = \"one\"",
            "noise = \"3 N\"",
        ] {
            let [whole, cycle] = packed(WALK, gait);
            assert_eq!(
                whole.target.as_ref().unwrap().curve().force_n,
                cycle.target.as_ref().unwrap().curve().force_n,
                "{gait}"
            );
            assert_eq!(whole.drive.mass, cycle.drive.mass, "{gait}");
            assert_eq!(whole.drive.speed, cycle.drive.speed, "{gait}");
            assert_eq!(whole.accuracy, cycle.accuracy, "{gait}");
            assert_eq!(whole.steps_per_turn, cycle.steps_per_turn, "{gait}");
            let [one, other] = [&whole, &cycle].map(|p| p.weight_n.unwrap());
            assert!((one / other - 1.0).abs() < 1e-12, "{gait}: {one} {other}");
        }
    }

    #[test]
    fn what_is_open_about_a_recording_stays_open_for_its_mean_cycle() {
        // Without a unit the forces could be those of a child, so the mass is an open question.
        let rows = WALK.lines().filter(|l| !l.starts_with('#'));
        let light = rows.map(|row| {
            let fields = row.split(',').map(|x| {
                x.parse()
                    .map_or(x.to_string(), |f: f64| (0.2 * f).to_string())
            });
            let mut fields: Vec<String> = fields.collect();
            if let Some(time) = row.split(',').next() {
                fields[0] = time.to_string();
            }
            fields.join(",") + "\n"
        });
        let light: String = light.collect();
        let open = |problem: &Problem| {
            problem
                .open_questions
                .iter()
                .map(|(q, _)| *q)
                .collect::<Vec<_>>()
        };
        let [whole, cycle] = packed(&light, "");
        assert_eq!(open(&whole), [OpenQuestion::Mass]);
        assert_eq!(open(&cycle), open(&whole));
        let [whole, cycle] = packed(&light, "accept = \"mass\"");
        assert!(open(&whole).is_empty() && open(&cycle).is_empty());
    }
}
