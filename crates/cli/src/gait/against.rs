//! Assigns walkers to the cams in an output folder of `gaitcam cover`. Each walker is assigned to the cam with the minimum force error.

use std::path::Path;

use serde_json::{Value, json};

use super::cover::{of_unit, reason};
use crate::console::error::CliError;
use crate::console::language;
use crate::console::table::{
    Side::{Left, Right},
    table,
};
use crate::console::words::{self, number};
use gaitcam::cover::{Assigned, served_by};
use gaitcam::error::{Placed, Result};
use gaitcam::force::{ForceCurve, Walker};
use gaitcam::synth::{Search, answer};
use gaitcam::wording::walker;
use gaitcam_app::Input;
use gaitcam_app::design::scene_of_cover;
use gaitcam_app::read::read_text;

/// Best cam in an output folder of `gaitcam cover` for each walker, for every number of cams. Returns a table for the console and JSON
/// data.
///
/// # Errors
///
/// The folder is not an output folder of `gaitcam cover`, or the machine cannot be adjusted to a walker.
pub fn against(folder: &Path, walkers: Vec<Walker>) -> Result<(String, Value)> {
    let path = folder.join("cover.csv");
    let covers = read_text(&path)?;
    let numbers: Option<Vec<usize>> = covers
        .lines()
        .skip(1)
        .map(|l| l.split(',').next()?.parse().ok())
        .collect();
    let numbers = numbers.filter(|n| covers.starts_with("cams,") && !n.is_empty());
    let numbers = numbers.ok_or_else(|| CliError::NotCover.in_file(&path))?;
    let first = Input::open(&folder.join(scene_of_cover(numbers[0], 1)))?;
    // The walkers must have the same unit, feet, movement and cycle as the walkers for whom the cams were designed.
    let known = first.target()?.and_then(|f| f.population);
    let mut all = known.map_or(Vec::new(), |p| p.walkers.clone());
    all.extend(walkers.iter().cloned());
    first
        .scene
        .gait
        .iter()
        .try_for_each(|g| g.walkers(all.clone(), &[]).map(drop))?;
    let force = ForceCurve::of_walkers(walkers)?;
    let measure = first.scene.law.error;
    let error = of_unit("error", measure);
    let names = ["walker", "cams", "cam", &error, "reason"];
    let mut rows = vec![names.map(|c| words::text(&format!("against-{c}"))).to_vec()];
    let mut objects = Vec::new();
    for cams in numbers {
        for served in serving(folder, cams, &force)? {
            let file = scene_of_cover(cams, served.cam + 1);
            objects.push(json!({"walker": served.error.walker, "cams": cams, "cam": served.cam + 1, "scene": file,
                "rms_error_percent": served.error.rms_error_percent, "rms_error_n": served.error.rms_error_n}));
            let error = number(served.error.measured(measure));
            rows.push(vec![
                walker(language::current(), &served.error.walker),
                cams.to_string(),
                file,
                error,
                reason(&served),
            ]);
        }
    }
    let head = words::fill(
        "against-head",
        &json!({"folder": folder.display().to_string()}),
    );
    Ok((
        format!(
            "{head}\n{}",
            table(&rows, &[Left, Right, Left, Right, Left])
        ),
        Value::Array(objects),
    ))
}

/// Cam with the minimum force error for the force curve of each walker, selected from the set of `cams` cams.
fn serving(folder: &Path, cams: usize, force: &ForceCurve) -> Result<Vec<Assigned>> {
    let (mut designs, mut scene) = (Vec::new(), None);
    for cam in 0..cams {
        let input = Input::open(&folder.join(scene_of_cover(cams, cam + 1)))?;
        let outcome = answer(&input.scene, input.target()?.as_ref(), &Search::default())?;
        designs.push(outcome.built()?);
        scene = Some(input.scene);
    }
    scene.map_or(Ok(Vec::new()), |scene| served_by(&scene, &designs, force))
}
