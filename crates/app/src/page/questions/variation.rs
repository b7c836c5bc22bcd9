//! How a design answers to its numbers: sensitivity and the trade-off front.

use serde::Deserialize;
use serde_json::{Value, json};

use crate::page::form::typed;
use crate::page::sources::Files;
use crate::page::{table, words};
use gaitcam::Problem;
use gaitcam::error::Result;
use gaitcam::force::ForceCurve;
use gaitcam::scene::Scene;
use gaitcam::scene::keys::{KEYS, Key};
use gaitcam::synth::{Design, Figure, Figures, synthesise, trade, traded};
use gaitcam::wording::{number, people, quantity};

/// Quantities whose sensitivity may be asked, with the column of their figure.
pub const QUANTITIES: [(&str, &str); 7] = [
    ("force_error", "force_rms_error_n"),
    ("prime_radius", "prime_radius_m"),
    ("stroke", "stroke_m"),
    ("acceleration", "acceleration_max_m_per_s2"),
    ("jerk", "jerk_max_m_per_s3"),
    ("torque", "torque_max_n_m"),
    ("smallest_radius", "rho_min_m"),
];
/// Quantities that the force error may be traded against.
pub const TRADES: [&str; 5] = ["prime_radius", "jerk", "acceleration", "velocity", "stroke"];
/// Points of a front.
const POINTS: usize = 16;
/// Most bars.
const BARS: usize = 12;

/// Which quantity is watched while every number is varied.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Vary {
    /// The scene file.
    pub scene: String,
    /// The quantity.
    pub quantity: String,
    /// By which share each number is varied.
    pub share: f64,
}

/// One bar for every number of the scene: the quantity with the number reduced and raised by a share, the longest bar
/// first.
///
/// # Errors
/// Faults of the scene as it stands.
pub fn sensitivity(files: &Files, vary: &Vary) -> Result<Value> {
    let table = table(&vary.scene)?;
    let (scene, _) = files.scene(&table)?;
    let target = files.target(&scene)?.map(|t| t.0);
    let of = |design: &Design| value(design, &vary.quantity);
    let middle = of(&synthesise(&scene, target.as_ref())?);
    let share = vary.share.clamp(1e-4, 0.5);
    let mut bars: Vec<(String, [Option<f64>; 2])> = Vec::new();
    for key in KEYS
        .iter()
        .filter(|k| k.exists(&scene) && k.measure().is_some())
    {
        for index in 0..entries(&scene, key) {
            if typed(&table, &key.path_at(index)).is_empty() {
                continue;
            }
            let Some(x) = key
                .get(&scene, index)
                .and_then(gaitcam::scene::keys::Value::number)
            else {
                continue;
            };
            let varied = |factor: f64| {
                let mut scene = scene.clone();
                let took = x != 0.0 && key.set_number(&mut scene, index, factor * x);
                let design = took.then(|| varied(files, &scene, target.as_ref(), key));
                design.flatten().and_then(|d| of(&d))
            };
            let ends = [varied(1.0 - share), varied(1.0 + share)];
            bars.push((key.path_at(index), ends));
        }
    }
    let middle = middle.unwrap_or(f64::NAN);
    let length = |ends: &[Option<f64>; 2]| {
        ends.iter()
            .flatten()
            .map(|x| (x - middle).abs())
            .fold(0.0, f64::max)
    };
    bars.retain(|b| length(&b.1) > 1e-9 * middle.abs());
    bars.sort_by(|a, b| length(&b.1).total_cmp(&length(&a.1)));
    bars.truncate(BARS);
    Ok(json!({
        "quantity": vary.quantity,
        "middle": middle,
        "shown": shown(&vary.quantity, middle),
        "bars": bars.iter().map(|(key, ends)| json!({
            "key": key, "low": ends[0], "high": ends[1],
            "shown": ends.map(|x| x.map(|x| shown(&vary.quantity, x))),
        })).collect::<Vec<_>>(),
    }))
}

/// The design of a varied scene; a load model is read again where its own numbers change.
fn varied(files: &Files, scene: &Scene, target: Option<&ForceCurve>, key: &Key) -> Option<Design> {
    let own = match key.section() {
        "gait" => files.target(scene).ok()?.map(|t| t.0),
        _ => target.cloned(),
    };
    synthesise(scene, own.as_ref()).ok()
}

fn entries(scene: &Scene, key: &Key) -> usize {
    match key.list() {
        None => 1,
        Some(_) => (0..64).take_while(|i| key.get(scene, *i).is_some()).count(),
    }
}

/// The figure of one of [`QUANTITIES`].
fn figure(name: &str) -> Option<&'static Figure> {
    let (_, column) = QUANTITIES.into_iter().find(|q| q.0 == name)?;
    Figure::of_column(column)
}

fn value(design: &Design, name: &str) -> Option<f64> {
    let value = figure(name)?.value(&Figures::of(design));
    (design.infeasible.is_none() && value.is_finite()).then_some(value)
}

fn shown(name: &str, value: f64) -> String {
    let unit = figure(name).map_or("", |f| f.unit);
    quantity(words::current(), round(value), unit)
}

fn round(x: f64) -> f64 {
    format!("{x:.3e}").parse().unwrap_or(x)
}

/// What the force error is traded against.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Trade {
    /// The scene file.
    pub scene: String,
    /// The other quantity.
    pub against: String,
}

/// The front: the least force error at each value of the other quantity, each point with the change that makes
/// its scene.
///
/// # Errors
/// Scenes without a force; quantities that cannot be traded.
pub fn front(files: &Files, asked: &Trade) -> Result<Value> {
    let against = traded(&format!("force_error:{}", asked.against))?;
    let (scene, _) = files.scene(&table(&asked.scene)?)?;
    let target = files.target(&scene)?.map(|t| t.0);
    let problem = Problem::resolve(&scene, target.as_ref())?;
    let front = trade(&problem, against, POINTS)?;
    let (unit, factor) = people(against.unit);
    let language = words::current();
    let points = front.iter().map(|point| {
        let x = factor * against.value(&Figures::of(&point.design));
        let y = point.design.problem.drive.newtons(point.design.force.rms_error_n);
        json!({
            "x": x, "y": y,
            "shown": [format!("{} {unit}", number(language, round(x))), format!("{} N", number(language, round(y)))],
            "key": against.limit.map(|kind| format!("limits.{}", kind.name())),
            "value": format!("{} {unit}", factor * point.allowed),
            "verdict": point.design.verdict.name(),
        })
    });
    Ok(json!({"against": asked.against, "unit": unit, "points": points.collect::<Vec<_>>()}))
}
