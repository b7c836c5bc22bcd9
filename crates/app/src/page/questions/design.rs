//! Design of a scene, with all data about the design that the page shows.

use std::collections::BTreeMap;
use std::sync::Arc;

use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use toml::Table;

use super::relax::{Change, first_remedies};
use crate::files::{self, Group};
use crate::page::curves::{Colour, Curves, curves};
use crate::page::edit::{Edit, apply};
use crate::page::form::{Field, fields};
use crate::page::hash::Hash;
use crate::page::kept::CachedDesign;
use crate::page::sources::Files;
use crate::page::{lock, plain, remedies, table, words};
use gaitcam::Problem;
use gaitcam::cam::{Continuity, Verdict};
use gaitcam::error::Result;
use gaitcam::force::ForceCurve;
use gaitcam::halt::Halt;
use gaitcam::scene::{Minimise, Scene};
use gaitcam::synth::{self, Design, FIGURES, Reason, Search};
use gaitcam::wording::{Language, number};
use gaitcam_output::Timing;
use gaitcam_output::report::parts::{self, Checked, Figure, Motion};

/// Request to design a scene with changes.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Ask {
    /// TOML text of the scene.
    pub scene: String,
    /// Changes of the scene, applied in order.
    #[serde(default)]
    pub changes: Vec<Edit>,
    /// Quantity that colours the contour.
    #[serde(default)]
    pub colour: Colour,
    /// Prime radius and offset of the last design, m. They are given while the user drags a slider. In this case, any feasible law of about
    /// this size is sufficient.
    #[serde(default)]
    pub quick: Option<[f64; 2]>,
}

/// Sizes that a quick design tries, as multiples of the last prime radius. At the minimum size itself, few laws are feasible.
const NEAR: [f64; 2] = [1.08, 1.3];
/// Maximum number of checks of the stop condition in a quick search. Most feasible laws are found within 400 checks.
const LOOKS: usize = 500;

/// Data about a design for the page.
#[derive(Serialize)]
pub struct Answer {
    /// Hash of the scene and its files. `force_hash` is the hash of the target force only.
    design_hash: Hash,
    force_hash: Option<Hash>,
    name: String,
    scene: String,
    fields: BTreeMap<String, Field>,
    verdict: &'static str,
    reasons: String,
    notes: Vec<String>,
    infeasible: bool,
    conflict: Vec<String>,
    /// Suggested changes of keys that resolve the open questions about the recording.
    asks: Vec<remedies::Remedy>,
    relaxations: Vec<Change>,
    easing: Vec<Eased>,
    figures: Vec<Figure>,
    checks: Vec<Checked>,
    numbers: Value,
    continuity: Continuity,
    /// Verdict on the continuity of the law by the CAM-DAS rule, which requires one more continuous derivative than the verdict of this
    /// program.
    cam_das: &'static str,
    drawing: String,
    motion: Motion,
    /// Names of the available files of the design, by group.
    exports: Vec<(&'static str, Vec<&'static str>)>,
    /// Default radius of the cutter, as text with its unit.
    cutter: String,
    curves: Curves,
    names: BTreeMap<String, String>,
    idle: bool,
    needs_relaxing: bool,
    /// Whether the design is a quick one, which has a feasible law instead of the optimum. The page then requests the full design.
    quick: bool,
    server_ms: f64,
}

/// Improvement of the objective if an active limit is relaxed by one per cent.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct Eased {
    name: String,
    from: String,
    to: String,
    objective: String,
    before: String,
    after: String,
    /// Improvement as a fraction of the objective.
    gain: f64,
}

/// Designs a scene with changes.
///
/// # Errors
///
/// The changes, the scene or its force are invalid.
pub fn design(files: &Files, ask: &Ask) -> Result<Answer> {
    let start = files.host.seconds();
    let table = changed(files, &ask.scene, &ask.changes)?;
    let quick = match ask.quick {
        Some(size) => soon(files, &table, size)?,
        None => None,
    };
    let is_quick = quick.is_some();
    let made = match quick {
        Some(made) => Arc::new(made),
        None => made(files, table)?,
    };
    let mut answer = answer(&made, ask.colour, words::current());
    answer.quick = is_quick;
    answer.server_ms = 1e3 * (files.host.seconds() - start);
    Ok(answer)
}

/// Table of a scene with the changes applied.
///
/// # Errors
///
/// The scene or the changes are invalid.
pub fn changed(files: &Files, scene: &str, changes: &[Edit]) -> Result<Table> {
    let mut table = table(scene)?;
    for edit in changes {
        apply(&mut table, edit, &|table| Ok(files.scene(table)?.0))?;
    }
    Ok(table)
}

/// Form of a scene without a design. It is shown while the force of the scene is missing.
///
/// # Errors
///
/// The changes are invalid, or the scene is invalid after the changes.
pub fn read(files: &Files, ask: &Ask) -> Result<Value> {
    let table = changed(files, &ask.scene, &ask.changes)?;
    let scene = match files.scene(&table) {
        Ok((scene, _)) => scene,
        Err(fault) if !ask.changes.is_empty() => return Err(fault),
        // The fields are also shown for an invalid scene.
        Err(_) => Scene::default(),
    };
    let name = table.get("name").and_then(toml::Value::as_str);
    Ok(json!({
        "scene": toml::to_string(&table).unwrap_or_default(),
        "name": name.unwrap_or(&scene.name),
        "fields": fields(&table, &scene, None),
    }))
}

/// Design for a table. It is taken from the cache if all inputs are equal.
///
/// # Errors
///
/// The scene or its force is invalid.
pub fn made(files: &Files, table: Table) -> Result<Arc<CachedDesign>> {
    let input = Input::read(files, table)?;
    let known = lock(&files.engine.designs).get(&input.hash);
    if let Some(known) = known {
        return Ok(known);
    }
    let halt = files.host.halt();
    let made = Arc::new(input.design(files, &halt)?);
    // An interrupted search does not give the design of the scene, so its result is not cached.
    if !halt.is_asked() {
        lock(&files.engine.designs).put(made.hash.clone(), Arc::clone(&made));
    }
    Ok(made)
}

/// Parsed scene with its force, ready for the design.
pub struct Input {
    start: f64,
    table: Table,
    whole: Table,
    scene: Scene,
    target: Option<ForceCurve>,
    force: Option<Hash>,
    hash: Hash,
}

impl Input {
    /// Parses the scene of a table and reads its force.
    ///
    /// # Errors
    /// The scene or its force is invalid.
    pub fn read(files: &Files, table: Table) -> Result<Input> {
        let start = files.host.seconds();
        let (scene, whole) = files.scene(&table)?;
        let (target, force) = files.target(&scene)?.unzip();
        let hash = files.of_scene(&toml::to_string(&table).unwrap_or_default());
        Ok(Input {
            start,
            table,
            whole,
            scene,
            target,
            force,
            hash,
        })
    }

    /// Designs the scene. The search ends at the stop condition `halt`.
    ///
    /// # Errors
    ///
    /// The scene cannot be designed.
    pub fn design(self, files: &Files, halt: &Halt) -> Result<CachedDesign> {
        let solving = files.host.seconds();
        let search = Search::until(halt.clone());
        let design = synth::answer(&self.scene, self.target.as_ref(), &search)?.built()?;
        let end = files.host.seconds();
        let time = Timing {
            solve_s: end - solving,
            total_s: end - self.start,
        };
        Ok(CachedDesign {
            table: self.table,
            whole: self.whole,
            scene: self.scene,
            design,
            time,
            hash: self.hash,
            force: self.force,
        })
    }
}

/// Quick design while the user drags a slider: a feasible law instead of the optimum. If a short search finds no feasible law, the limits
/// are ignored.
///
/// `None` if the law does not exist without limits either. In this case, only the full design contains the reason.
fn soon(files: &Files, table: &Table, size: [f64; 2]) -> Result<Option<CachedDesign>> {
    let start = files.host.seconds();
    let (scene, whole) = files.scene(table)?;
    let (target, force) = files.target(&scene)?.unzip();
    let is_sought = scene.law.minimise == Some(Minimise::Size)
        && scene.cam.roller_radius > 0.0
        && scene.cam.given_radii().is_none();
    let tried = match is_sought {
        true => NEAR.map(|factor| of_size(&scene, factor, size)).to_vec(),
        false => vec![scene.clone()],
    };
    let passing = |scene: &Scene| {
        let search = Search::until(files.host.halt().or_after(LOOKS));
        let problem = Problem::resolve(scene, target.as_ref()).ok()?;
        synth::passing(&problem, &search).ok().flatten()
    };
    let at_once = || {
        let search = Search::until(Halt::when(|| true));
        let outcome = synth::answer(&scene, target.as_ref(), &search).ok()?;
        outcome.built().ok()
    };
    let found = tried.iter().find_map(passing).or_else(at_once);
    let Some(design) = found else {
        return Ok(None);
    };
    let total_s = files.host.seconds() - start;
    Ok(Some(CachedDesign {
        table: table.clone(),
        whole,
        scene,
        design,
        time: Timing {
            solve_s: total_s,
            total_s,
        },
        hash: files.of_scene(&toml::to_string(table).unwrap_or_default()),
        force,
    }))
}

/// Copy of the scene with a fixed size. The prime radius is `factor` times `prime`, m. The offset is `offset`, m, if the scene has none.
fn of_size(scene: &Scene, factor: f64, [prime, offset]: [f64; 2]) -> Scene {
    let mut sized = scene.clone();
    sized.cam.prime_radius = Some(factor * prime);
    sized.cam.offset = scene.cam.offset.or(Some(offset));
    sized
}

fn answer(kept: &CachedDesign, colour: Colour, language: Language) -> Answer {
    let (design, scene) = (&kept.design, &kept.scene);
    let name = |typed: &str| parts::name(typed, language);
    let conflict = design.infeasible.as_ref().map_or(&[][..], |i| &i.conflict);
    let curves = curves(design, colour);
    let limits = curves.places.iter().map(|p| p.limit.clone());
    let names = limits.map(|l| (l.clone(), name(&l))).collect();
    Answer {
        design_hash: kept.hash.clone(),
        force_hash: kept.force.clone(),
        name: design.problem.name.clone(),
        scene: toml::to_string(&kept.table).unwrap_or_default(),
        fields: fields(&kept.table, scene, Some(design)),
        verdict: design.verdict.name(),
        reasons: shown(&reasons(design, language), language),
        notes: (design.notes.iter())
            .map(|n| shown(&n.sentence(language), language))
            .collect(),
        infeasible: design.infeasible.is_some(),
        conflict: conflict
            .iter()
            .map(|limit| shown(&limit.sentence(language), language))
            .collect(),
        asks: remedies::of_open_questions(design),
        relaxations: first_remedies(design, scene),
        easing: easing(design, language),
        figures: parts::figures(design, language),
        checks: parts::checks(design, language),
        numbers: numbers(kept),
        continuity: Continuity::of(&design.cam),
        cam_das: design.cam.cam_das_class().name(),
        drawing: parts::drawing(design, language),
        motion: parts::motion(design),
        exports: exports(design),
        cutter: format!("{} mm", 1e3 * files::usual_cutter(design)),
        curves,
        names,
        idle: design.is_idle(),
        needs_relaxing: design.verdict == Verdict::Unacceptable,
        quick: false,
        server_ms: 0.0,
    }
}

/// Reasons for the verdict. Suggested changes are omitted, because the page shows them as buttons.
pub fn reasons(design: &Design, language: Language) -> String {
    let facts = design.reasons.iter().filter(|reason| {
        !matches!(
            reason,
            Reason::Relaxation { .. }
                | Reason::Relaxations { .. }
                | Reason::FarRelaxations { .. }
                | Reason::AllTogether { .. }
                | Reason::FarTogether { .. }
        )
    });
    let facts: Vec<String> = facts.map(|reason| reason.sentence(language)).collect();
    facts.join(" ")
}

/// Converts a message of the program to the form on the page: labels replace keys, and numbers have at most four significant digits.
pub fn shown(sentence: &str, language: Language) -> String {
    plain::short(&plain::plain(sentence, "", language))
}

/// Names of the files that the page offers for a design, by group. The scene is in the group of tables.
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

/// Key figures of a design (single numbers, such as the force error) by column name. Missing values are null.
fn numbers(kept: &CachedDesign) -> Value {
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
        let shown = |x: f64| format!("{} {unit}", number(language, factor * x));
        Eased {
            name: parts::name(e.limit.name(), language),
            from: parts::shown(design, e.limit, e.from, language),
            to: parts::shown(design, e.limit, e.to, language),
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

/// Request that contains only a scene.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Which {
    /// TOML text of the scene.
    pub scene: String,
}
