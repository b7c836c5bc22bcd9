//! Sensitivity of a design to each number of its scene, and trade-off front.

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
use gaitcam::synth::{Design, Figure, Figures, Search, synthesise, trade, traded};
use gaitcam::wording::people;

/// Whether the page can show a trade-off front between a key figure and the force error. The scene must have a limit for the key figure,
/// because each point of the front becomes a scene with a value of this limit.
pub fn is_traded(figure: &&Figure) -> bool {
    figure.trade.is_some() && figure.limit.is_some()
}

/// Number of points on a front.
const POINTS: usize = 16;
/// Maximum number of keys in the response to a sensitivity request.
const BARS: usize = 12;

/// Request for the sensitivity of one quantity to each number of the scene.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Vary {
    /// TOML text of the scene.
    pub scene: String,
    /// Column name of the quantity for which the sensitivity is computed.
    pub quantity: String,
    /// Relative change of each number, as a fraction of its value.
    pub share: f64,
}

/// Sensitivity of a quantity to each number of the scene. Each number is reduced and increased by a given fraction. The result contains at
/// most 12 numbers that affect the quantity, sorted by decreasing effect.
///
/// # Errors
///
/// The unchanged scene is invalid.
pub fn sensitivity(files: &Files, vary: &Vary) -> Result<Value> {
    let table = table(&vary.scene)?;
    let (scene, _) = files.scene(&table)?;
    let target = files.target(&scene)?.map(|t| t.0);
    let figure = Figure::of_column(&vary.quantity);
    let of = |design: &Design| value(design, figure?);
    let design = synthesise(&scene, target.as_ref())?;
    let measures = design.cam.follower.measures();
    let middle = of(&design);
    let shown = |x: f64| figure.map_or(String::new(), |f| f.text(x, measures, words::current()));
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
        "shown": shown(middle),
        "bars": bars.iter().map(|(key, ends)| json!({
            "key": key, "low": ends[0], "high": ends[1],
            "shown": ends.map(|x| x.map(shown)),
        })).collect::<Vec<_>>(),
    }))
}

/// Design of a changed scene; `None` if the design fails. The force is computed again if `key` is in the section `gait`.
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

fn value(design: &Design, figure: &Figure) -> Option<f64> {
    let value = figure.value(&Figures::of(design));
    (design.infeasible.is_none() && value.is_finite()).then_some(value)
}

/// Request for the trade-off between a quantity and the force error.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Trade {
    /// TOML text of the scene.
    pub scene: String,
    /// Column name of the quantity, which is the second objective.
    pub against: String,
}

/// Trade-off front: the minimum force error for each value of the other quantity. Each point contains a key and a value. If
/// the key is set to this value, the scene has the design of this point.
///
/// # Errors
///
/// The scene has no force, or the quantity cannot be traded against the force error.
pub fn front(files: &Files, asked: &Trade) -> Result<Value> {
    let name = Figure::of_column(&asked.against).and_then(|f| f.trade);
    let against = traded(&format!("force_error:{}", name.unwrap_or(&asked.against)))?;
    let (scene, _) = files.scene(&table(&asked.scene)?)?;
    let target = files.target(&scene)?.map(|t| t.0);
    let problem = Problem::resolve(&scene, target.as_ref())?;
    let front = trade(&problem, against, POINTS, &Search::default())?;
    let (unit, factor) = people(against.unit);
    let language = words::current();
    let points = front.iter().map(|point| {
        let figures = Figures::of(&point.design);
        let measures = point.design.cam.follower.measures();
        let shown = |f: &Figure| f.text(f.value(&figures), measures, language);
        let error = Figure::of_column("force_rms_error_n").map_or(String::new(), shown);
        let x = factor * against.value(&figures);
        let y = figures.force.rms_error_n;
        json!({
            "x": x, "y": y,
            "shown": [shown(against), error],
            "key": against.limit.map(|kind| format!("limits.{}", kind.name())),
            "value": format!("{} {unit}", factor * point.allowed),
            "verdict": point.design.verdict.name(),
        })
    });
    Ok(json!({"against": asked.against, "unit": unit, "points": points.collect::<Vec<_>>()}))
}
