//! Contents of the program that do not depend on a scene: texts, keys, built-in scenes and laws of motion.

use serde::Deserialize;
use serde_json::{Value, json};

use crate::page::kept::Start;
use crate::page::questions::variation::is_traded;
use crate::page::sources::Files;
use crate::page::{table, words};
use gaitcam::error::Result;
use gaitcam::law::Rise;
use gaitcam::scene::{self, EXAMPLE_RECORDING, SCENES, built_in, keys};
use gaitcam::synth::{Design, FIGURES, synthesise};
use gaitcam::wording::{Language, people, scene_doc};
use gaitcam_output::report::parts;
use gaitcam_output::{laws_report, palette};

/// Number of points on the curve of a law in the catalogue.
const POINTS: usize = 60;

/// Data that the page loads once when it is opened.
pub fn start(start: &Start) -> Value {
    let scenes = SCENES.iter().map(|s| {
        json!({
            "name": s.name,
            "toml": with_recording(s.name, s.toml),
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

/// Text of a built-in scene. If the scene has no recording of its own, the built-in example recording is inserted.
fn with_recording(name: &str, toml: &str) -> String {
    let file = format!("[gait]\nfile = \"{EXAMPLE_RECORDING}\"\n");
    match name {
        "measured_walk" => toml.replacen("[gait]\n", &file, 1),
        _ => toml.to_string(),
    }
}

/// Request for the picture of a built-in scene.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Picture {
    /// Name of the built-in scene.
    pub name: String,
}

/// Picture of the cam of a built-in scene, as SVG.
///
/// # Errors
///
/// No built-in scene has this name.
pub fn picture(files: &Files, asked: &Picture) -> Result<Value> {
    let scene = built_in(&asked.name)?;
    let table = table(&with_recording(scene.name, scene.toml))?;
    let scene = scene::read(&table)?;
    let target = files.target(&scene)?.map(|t| t.0);
    let design = synthesise(&scene, target.as_ref())?;
    Ok(json!({"svg": at_rest(&design)}))
}

/// First frame of the animation as a static SVG, in which RGB values replace the colour variables of the page.
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

/// Catalogue of the laws, with the curves of each law.
///
/// # Errors
///
/// No error is expected, because all laws of the catalogue are valid.
pub fn laws() -> Result<Value> {
    let all: Result<Vec<Value>> = Rise::catalogue().iter().map(law).collect();
    let dwell = Rise::Dwell.name();
    let title = |language| parts::name(dwell, language);
    Ok(json!({"laws": all?, "dwell": {"en": title(Language::En), "es": title(Language::Es)}}))
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
    let title = |language| parts::name(rise.name(), language);
    let finite = |x: f64| if x.is_finite() { json!(x) } else { Value::Null };
    Ok(json!({
        "name": rise.name(), "written": rise.written(), "formula": rise.formula(),
        "title": {"en": title(Language::En), "es": title(Language::Es)},
        "advice": {"en": laws_report::advice(rise, Language::En), "es": laws_report::advice(rise, Language::Es)},
        "cv": finite(factors.cv), "ca": finite(factors.ca), "cj": finite(factors.cj), "ct": finite(factors.ct),
        "vdi": [ends.start.vdi(), ends.end.vdi()],
        "joins": {"en": joins(Language::En), "es": joins(Language::Es)},
        "s": s, "v": v, "a": a, "j": j,
    }))
}
