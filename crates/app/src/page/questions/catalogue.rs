//! Contents of the program: texts, keys, built-in scenes, laws.

use serde::Deserialize;
use serde_json::{Value, json};

use crate::page::kept::Start;
use crate::page::questions::variation::is_traded;
use crate::page::sources::Files;
use crate::page::{table, words};
use gaitcam::error::Result;
use gaitcam::law::Rise;
use gaitcam::scene::{self, SCENES, built_in, keys};
use gaitcam::synth::{Design, FIGURES, synthesise};
use gaitcam::wording::{Language, people, scene_doc};
use gaitcam_output::report::parts;
use gaitcam_output::{laws_report, palette};

/// Number of points of a law's thumbnail curve.
const POINTS: usize = 60;

/// Data that the page needs once.
pub fn start(start: &Start) -> Value {
    let scenes = SCENES.iter().map(|s| {
        json!({
            "name": s.name,
            "toml": s.toml,
            "doc": {"en": scene_doc(Language::En, s.name), "es": scene_doc(Language::Es, s.name)},
        })
    });
    json!({
        "scene": start.scene,
        "file": start.file,
        "folder": start.folder,
        "words": {"en": words::page(Language::En), "es": words::page(Language::Es)},
        "keys": keys::json(),
        "scenes": scenes.collect::<Vec<_>>(),
        "trades": FIGURES.iter().filter(is_traded).map(|f| f.column).collect::<Vec<_>>(),
        "figures": FIGURES.each_ref().map(|f| (f.column, people(f.unit))),
        "longest_s": crate::page::LONGEST,
    })
}

/// Name of a built-in scene.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Picture {
    /// Name of the picture.
    pub name: String,
}

/// The picture of a built-in scene's cam.
///
/// # Errors
/// Unknown names of scenes.
pub fn picture(files: &Files, asked: &Picture) -> Result<Value> {
    let mut table = table(built_in(&asked.name)?.toml)?;
    if scene::read(&table).is_err() {
        // The picture of a scene that still waits for its recording is that of a load model.
        scene::set(&mut table, "gait.model=young")?;
        scene::set(&mut table, "gait.step_frequency=1.85 Hz")?;
    }
    let scene = scene::read(&table)?;
    let target = files.target(&scene)?.map(|t| t.0);
    let design = synthesise(&scene, target.as_ref())?;
    Ok(json!({"svg": at_rest(&design)}))
}

/// A still picture of the animation: every part at its start position, in plain colours.
fn at_rest(design: &Design) -> String {
    let motion = serde_json::to_value(parts::motion(design)).unwrap_or_default();
    let first = |list: &str| motion[list][0].as_f64().unwrap_or(0.0);
    let turned = motion["start"].as_f64().unwrap_or(0.0);
    let stand = |id: &str, [x, y, angle]: [&str; 3]| {
        let (x, y, angle) = (first(x), first(y), first(angle));
        (
            format!("id=\"{id}\""),
            format!("transform=\"translate({x} {y}) rotate({angle})\""),
        )
    };
    let hidden = |id: &str| (format!("id=\"{id}\""), "display=\"none\"".to_string());
    let mut svg = parts::drawing(design, Language::En);
    let places = [
        stand("cam-follower", ["px", "py", "pa"]),
        stand("cam-second", ["qx", "qy", "qa"]),
        hidden("cam-push"),
        hidden("cam-contact"),
    ];
    for (id, place) in places {
        svg = svg.replace(&id, &place);
    }
    if motion["slide"].as_f64() == Some(0.0) {
        svg = svg.replace(
            "id=\"cam-turning\"",
            &format!("transform=\"rotate({turned})\""),
        );
    }
    for (colour, name) in palette::NAMES {
        let plain = format!("rgb({},{},{})", colour.0, colour.1, colour.2);
        svg = svg.replace(&format!("var(--{name})"), &plain);
    }
    let head = "<svg xmlns=\"http://www.w3.org/2000/svg\"";
    let style = "<style>*{vector-effect:non-scaling-stroke}</style>";
    let svg = svg.replacen("<svg", head, 1);
    svg.replacen('>', &format!(">{style}"), 1)
}

/// The catalogue of laws with their curves.
///
/// # Errors
/// None that a law of the catalogue has.
pub fn laws() -> Result<Value> {
    let all: Result<Vec<Value>> = Rise::catalogue().iter().map(law).collect();
    Ok(json!({"laws": all?}))
}

fn law(rise: &Rise) -> Result<Value> {
    let (law, factors, ends) = (rise.law()?, rise.factors()?, rise.ends()?);
    let (start, length) = law.extent();
    let mut curves: [Vec<Option<f64>>; 4] = Default::default();
    for i in 0..=POINTS {
        let at = law.svaj(start + length * i as f64 / POINTS as f64);
        for (curve, x) in curves.iter_mut().zip([at.s, at.v, at.a, at.j]) {
            curve.push(x.is_finite().then(|| (x * 1e4).round() / 1e4));
        }
    }
    let [s, v, a, j] = curves;
    let joins = |language| [ends.start.joins_in(language), ends.end.joins_in(language)];
    let finite = |x: f64| if x.is_finite() { json!(x) } else { Value::Null };
    Ok(json!({
        "name": rise.name(), "written": rise.written(), "formula": rise.formula(),
        "advice": {"en": laws_report::advice(rise, Language::En), "es": laws_report::advice(rise, Language::Es)},
        "cv": finite(factors.cv), "ca": finite(factors.ca), "cj": finite(factors.cj), "ct": finite(factors.ct),
        "joins": {"en": joins(Language::En), "es": joins(Language::Es)},
        "s": s, "v": v, "a": a, "j": j,
    }))
}
