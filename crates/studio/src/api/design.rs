//! A design for one state of the scene: everything that the page shows of it.

use std::collections::BTreeMap;
use std::sync::Arc;
use std::time::Instant;

use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use toml::Table;

use super::table;
use crate::curves::{Colour, Curves, curves};
use crate::edit::{Edit, apply};
use crate::fault::StudioError;
use crate::form::{Field, fields};
use crate::state::{Kept, Studio};
use crate::words;
use gaitcam::Problem;
use gaitcam::cam::Continuity;
use gaitcam::error::Result;
use gaitcam::halt::Halt;
use gaitcam::scene::{Scene, keys};
use gaitcam::synth::{self, Design, FIGURES, Relaxation, Search};
use gaitcam::wording::Language;
use gaitcam_files::files::{self, Group};
use gaitcam_output::Timing;
use gaitcam_output::report::parts::{self, Figure, Motion, Tables};

/// A scene with changes.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Ask {
    /// The scene file.
    pub scene: String,
    /// What is to be changed in it.
    #[serde(default)]
    pub changes: Vec<Edit>,
    /// Which page asks.
    #[serde(default)]
    pub page: String,
    /// Its questions counted: one that is overtaken need not be answered.
    #[serde(default)]
    pub number: u64,
    /// By what the contour is coloured.
    #[serde(default)]
    pub colour: Colour,
}

/// Everything that the page shows of a design.
#[derive(Serialize)]
pub struct Answer {
    id: String,
    number: u64,
    name: String,
    scene: String,
    fields: BTreeMap<String, Field>,
    verdict: &'static str,
    reasons: String,
    notes: Vec<String>,
    infeasible: bool,
    conflict: Vec<String>,
    relaxations: Vec<Remedy>,
    easing: Vec<Eased>,
    active: Vec<String>,
    figures: Vec<Figure>,
    tables: Tables,
    numbers: Value,
    continuity: Continuity,
    drawing: String,
    motion: Motion,
    /// Names of the files that it has, by group.
    exports: Vec<(&'static str, Vec<&'static str>)>,
    /// Radius of the cutter that its path is made for at first.
    cutter: String,
    curves: Curves,
    names: BTreeMap<String, String>,
    idle: bool,
    needs_relaxing: bool,
    server_ms: f64,
}

/// A change that would make a scene pass.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct Remedy {
    key: &'static str,
    name: String,
    from: String,
    /// As shown; none where no value of this key alone helps.
    to: Option<String>,
    /// As a scene file takes it.
    value: Option<String>,
}

/// What one per cent more of an active limit would buy.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct Eased {
    name: String,
    from: String,
    to: String,
    objective: String,
    before: String,
    after: String,
    /// Gain as a share of the objective.
    gain: f64,
}

/// What a page hears: its design, or that it has asked again meanwhile.
#[derive(Serialize)]
#[serde(untagged)]
pub enum Reply {
    /// The design.
    Answer(Box<Answer>),
    /// Nothing: a newer question is on its way.
    Overtaken {
        /// Always true.
        superseded: bool,
        /// The number of the question.
        number: u64,
    },
}

/// Designs the scene.
///
/// # Errors
/// Faults of the changes, of the scene and of its force.
pub fn design(studio: &Studio, ask: &Ask) -> Result<Reply> {
    let start = Instant::now();
    let number = ask.number;
    let overtaken = || {
        Ok(Reply::Overtaken {
            superseded: true,
            number,
        })
    };
    let ticket = studio.scheduler.register(&ask.page, ask.number);
    let Some(slot) = studio.scheduler.acquire(&ticket) else {
        return overtaken();
    };
    let mut table = table(&ask.scene)?;
    for edit in &ask.changes {
        apply(&mut table, edit, &|table| Ok(studio.scene(table)?.0))?;
    }
    let kept = made(studio, &table, slot.ticket().halt())?;
    if ticket.is_outdated() {
        return overtaken();
    }
    let language = words::current();
    let id = studio.keep(Arc::clone(&kept));
    let mut answer = answer(&kept, id, ask.colour, language);
    answer.number = ask.number;
    answer.server_ms = 1e3 * start.elapsed().as_secs_f64();
    Ok(Reply::Answer(Box::new(answer)))
}

/// The design of a table.
///
/// # Errors
/// Faults of the scene and of its force.
fn made(studio: &Studio, table: &Table, halt: Halt) -> Result<Arc<Kept>> {
    let start = Instant::now();
    let (scene, whole) = studio.scene(table)?;
    let target = studio.sources.target(&studio.folder, &scene)?;
    let solving = Instant::now();
    let problem = Problem::resolve(&scene, target.as_ref())?;
    let design = synth::design(&problem, &Search::until(halt))?;
    let time = Timing {
        solve_s: solving.elapsed().as_secs_f64(),
        total_s: start.elapsed().as_secs_f64(),
    };
    let table = table.clone();
    Ok(Arc::new(Kept {
        table,
        whole,
        scene,
        design,
        time,
    }))
}

fn answer(kept: &Kept, id: String, colour: Colour, language: Language) -> Answer {
    let (design, scene) = (&kept.design, &kept.scene);
    let name = |typed: &str| parts::name(typed, language);
    let conflict = design.infeasible.as_ref().map_or(&[][..], |i| &i.conflict);
    let mut active: Vec<String> = Vec::new();
    for binding in &design.binding {
        let name = name(binding.limit.name());
        if !active.contains(&name) {
            active.push(name);
        }
    }
    let curves = curves(design, colour);
    let limits = curves.places.iter().map(|p| p.limit.clone());
    let names = limits.map(|l| (l.clone(), name(&l))).collect();
    Answer {
        id,
        number: 0,
        name: design.name.clone(),
        scene: toml::to_string(&kept.table).unwrap_or_default(),
        fields: fields(&kept.table, scene, Some(design)),
        verdict: design.verdict.name(),
        reasons: design.reason(language),
        notes: design.notes.iter().map(|n| n.sentence(language)).collect(),
        infeasible: design.infeasible.is_some(),
        conflict: conflict
            .iter()
            .map(|limit| limit.sentence(language))
            .collect(),
        relaxations: first_remedies(design, scene, language),
        easing: easing(design, language),
        active,
        figures: parts::figures(design, language),
        tables: parts::tables(design, kept.time, language),
        numbers: numbers(kept),
        continuity: Continuity::of(&design.cam),
        drawing: parts::drawing(design, language),
        motion: parts::motion(design),
        exports: exports(design),
        cutter: format!("{} mm", 1e3 * files::usual_cutter(design)),
        curves,
        names,
        idle: design.is_idle(),
        needs_relaxing: design.verdict == gaitcam::cam::Verdict::Unacceptable,
        server_ms: 0.0,
    }
}

/// The files of a design by group, its scene among the tables.
fn exports(design: &Design) -> Vec<(&'static str, Vec<&'static str>)> {
    let names = |group: Group| -> Vec<&'static str> {
        let scene = (group == Group::Tables).then_some("scene.toml");
        let own = files::of(design).filter(|file| file.group == group);
        own.map(|file| file.name).chain(scene).collect()
    };
    let groups = Group::ALL.map(|group| (group.name(), names(group)));
    groups
        .into_iter()
        .filter(|group| !group.1.is_empty())
        .collect()
}

/// The figures that the slate compares.
/// The figures of a design by their columns; null where it has none.
fn numbers(kept: &Kept) -> Value {
    let row = gaitcam::sweep::Row::of(&kept.design);
    let pairs = FIGURES.iter().zip(row.numbers);
    pairs
        .map(|(figure, x)| (figure.column, x.is_finite().then_some(x)))
        .collect()
}

fn easing(design: &Design, language: Language) -> Vec<Eased> {
    let measures = design.cam.follower.measures();
    let all = design.easing.iter();
    all.map(|e| {
        let (objective, unit, factor) = e.in_words(measures, language);
        let shown = |x: f64| {
            format!(
                "{} {unit}",
                gaitcam::wording::number(language, round(factor * x))
            )
        };
        Eased {
            name: parts::name(e.limit.name(), language),
            from: parts::shown(design, e.limit, e.from),
            to: parts::shown(design, e.limit, e.to),
            objective,
            before: shown(e.before),
            after: shown(e.after),
            gain: if e.before == 0.0 {
                0.0
            } else {
                (e.before - e.after) / e.before.abs()
            },
        }
    })
    .collect()
}

/// Five digits show what 1 % does.
fn round(x: f64) -> f64 {
    format!("{x:.4e}").parse().unwrap_or(x)
}

/// What the conflict alone says, before the whole design is tried with each value.
fn first_remedies(design: &Design, scene: &Scene, language: Language) -> Vec<Remedy> {
    let own = match &design.infeasible {
        Some(infeasible) if design.relaxations.is_empty() => &infeasible.relaxations,
        _ => &design.relaxations,
    };
    remedies(design, scene, own, language)
}

fn remedies(
    design: &Design,
    scene: &Scene,
    list: &[Relaxation],
    language: Language,
) -> Vec<Remedy> {
    let shown = |r: &Relaxation, x: f64| parts::shown(design, r.limit, x);
    list.iter()
        .map(|r| Remedy {
            key: r.key,
            name: parts::name(r.limit.name(), language),
            from: shown(r, r.from),
            to: r.to.map(|to| shown(r, to)),
            value: r.to.and_then(|to| value(r.key, scene, to)),
        })
        .collect()
}

/// A number as a scene file takes it under a key.
fn value(key: &str, scene: &Scene, x: f64) -> Option<String> {
    let row = keys::find(key)?;
    let written = keys::Value::Number(x).to_toml(row.dimension(scene));
    Some(written.as_str().map_or(written.to_string(), str::to_string))
}

/// Which design is meant.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Which {
    /// Its number.
    pub id: String,
    /// Which page asks.
    #[serde(default)]
    pub page: String,
    /// The number of the question that the design answered.
    #[serde(default)]
    pub number: u64,
}

/// The changes that would make a design pass, each tried on the whole design.
pub fn relax(studio: &Studio, which: &Which) -> Result<Value> {
    let kept = studio.kept(&which.id).ok_or(StudioError::Forgotten)?;
    let language = words::current();
    let ticket = studio.scheduler.register(&which.page, which.number);
    let overtaken = || Ok(json!({"superseded": true, "id": which.id}));
    let Some(slot) = studio.scheduler.acquire(&ticket) else {
        return overtaken();
    };
    let search = Search::until(slot.ticket().halt());
    let tried = kept.design.clone().relaxed_with(&search);
    if ticket.is_outdated() {
        return overtaken();
    }
    let list = |list: &[Relaxation]| remedies(&tried, &kept.scene, list, language);
    Ok(json!({
        "id": which.id,
        "reasons": tried.reason(language),
        "relaxations": list(&tried.relaxations),
        "together": list(&tried.together),
    }))
}

/// Ends what a page has asked before this question.
pub fn cancel(studio: &Studio, which: &Cancel) -> Result<Value> {
    studio.scheduler.register(&which.page, which.number);
    Ok(json!({"cancelled": true}))
}

/// Which questions are to end.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cancel {
    /// The page.
    pub page: String,
    /// All before this number.
    pub number: u64,
}
