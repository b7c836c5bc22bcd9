//! Scene file, summary and result folder of a design.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use gaitcam::Problem;
use gaitcam::cover::Cover;
use gaitcam::error::{Error, Result};
use gaitcam::force::ForceCurve;
use gaitcam::scene::{Family, Scene};
use gaitcam::synth::Design;
use gaitcam_output::{Timing, json};
use serde_json::Value;

use crate::earlier::{self, SCENE, SCENE_BESIDE_INPUT, SUMMARY};
pub use crate::earlier::{
    FORCE, MOST_CAMS, OF_COVER, OF_IDENTIFICATION, OF_INSPECTION, OF_RUN, of_another_design,
    of_cover, of_design, scene_of_cover,
};
use crate::inputs;
use crate::result_folder::ResultFolder;
use crate::scene::Input;

/// Content of `summary.json`: the key figures of the design, and the scene from which it was computed.
pub fn summary(design: &Design, scene: &toml::Table, time: Timing) -> Value {
    let mut out = json::summary(design, time);
    out["scene"] = serde_json::to_value(scene).unwrap_or_default();
    out
}

/// Content of `summary.json` for a scene without a cam: the reason, the key that causes it, and the scene.
pub fn summary_without_cam(name: &str, error: &Error, scene: &toml::Table, total_s: f64) -> Value {
    let mut out = json::summary_without_cam(name, error, total_s);
    out["scene"] = serde_json::to_value(scene).unwrap_or_default();
    out
}

/// Whether a key changes the machine in which a manufactured cam runs, but not the cam.
pub fn is_of_machine(key: &str) -> bool {
    key.starts_with("drive.") || key.starts_with("machine.")
}

/// Places a manufactured cam in the machine of another scene, with the drive and the target force of that scene.
///
/// The target force of a load model is evaluated at the step frequency of the new speed. If the model is not defined at this frequency, the returned
/// design has no target force, and the second returned value is the reason.
///
/// # Errors
///
/// The drive has no speed or mass.
pub fn put_on(design: Design, scene: &Scene) -> Result<(Design, Option<Error>)> {
    let drive = Problem::resolve(scene, design.target_in_time())?.drive;
    let faster = (drive.speed / design.problem.drive.speed).abs();
    let design = design.on_drive(drive);
    let Some(gait) = scene.gait.as_ref().filter(|_| faster != 1.0) else {
        return Ok((design, None));
    };
    let mut gait = gait.clone();
    gait.step_frequency = match gait.step_frequencies.take() {
        // The scene has several walkers with different step frequencies. The step frequency at the new speed selects one of them.
        Some(_) => step_frequency(&design),
        // The frequency is rounded, because it is part of the name of the target.
        None => gait
            .step_frequency
            .map(|f| (faster * f * 1e9).round() / 1e9),
    };
    let (target, missing) = match gait.model_force() {
        Ok(None) => return Ok((design, None)),
        Ok(Some(force)) => {
            let mut scene = scene.clone();
            // The mass of the machine does not depend on the mean force at this speed.
            let mass = (drive.mass > 0.0).then_some(drive.mass);
            scene.drive.mass = scene.drive.mass.or(mass);
            let problem = Problem::resolve(&scene, Some(&force))?.at_phase(design.problem.phase);
            (problem.target_in_time().cloned(), None)
        }
        Err(error) => (None, Some(error)),
    };
    Ok((design.moved_to(drive, target), missing))
}

/// Applies another force to a manufactured cam. Values of the machine that the scene omits, such as mass and speed, are computed from this force.
///
/// # Errors
///
/// The mean force, the mass or the speed is defined neither by the force nor by the scene.
pub fn put_under(design: Design, scene: &Scene, force: &ForceCurve) -> Result<Design> {
    let problem = Problem::resolve(scene, Some(force))?.at_phase(design.problem.phase);
    let target = problem.target_in_time().cloned();
    Ok(design.moved_to(problem.drive, target))
}

/// Keys of `law` and their values for one cam of a set. Each cam has its own objective. All cams have the same law family and size.
pub fn law_of_cam(cover: &Cover, cam: usize) -> Vec<(&'static str, toml::Value)> {
    let law = &cover.scene.law;
    let objective = cover.cams[cam].population.as_ref();
    let size = |of: Family, x: Option<usize>| {
        let x = x.filter(|_| law.family == of);
        x.map(|x| toml::Value::Integer(x as i64))
    };
    let values = [
        ("law.robust", objective.map(|p| p.robust.clone().into())),
        ("law.family", Some(law.family.name().into())),
        ("law.spans", size(Family::Spline, law.spans)),
        ("law.harmonics", size(Family::Harmonic, law.harmonics)),
    ];
    let given = values.into_iter();
    given
        .filter_map(|(key, value)| Some((key, value?)))
        .collect()
}

/// Writes the scene and the summary, and moves all files of the result into the folder.
///
/// # Errors
///
/// A file cannot be written or moved.
pub fn finish(
    folder: ResultFolder,
    input: &Input,
    scene: &toml::Table,
    summary: &Value,
) -> Result<PathBuf> {
    let scene = toml::to_string(scene).unwrap_or_default();
    write_scene(&folder, input, &scene)?;
    let text = serde_json::to_string_pretty(summary).unwrap_or_default();
    folder.write(SUMMARY, text.as_bytes())?;
    let path = folder.path().to_path_buf();
    let stale = earlier::stale(&path, &scene);
    folder.commit(&stale)?;
    Ok(path)
}

/// Step frequency at the speed of the drive, Hz; `None` for a law without load factors.
fn step_frequency(design: &Design) -> Option<f64> {
    let of_step = design.load_factors().first()?.of_step;
    let period = design.cam.law.extent().1 / design.problem.drive.speed.abs();
    Some((1.0 / of_step).round() / period)
}

/// Writes the resolved scene as `scene.toml`. The name is `scene.used.toml` if the scene was read from `scene.toml` in this folder.
///
/// # Errors
///
/// The file cannot be written.
pub fn write_scene(folder: &ResultFolder, input: &Input, text: &str) -> Result<()> {
    let own = folder.path().join(SCENE);
    let name = if input.file.as_deref().is_some_and(|f| same(f, &own)) {
        SCENE_BESIDE_INPUT
    } else {
        SCENE
    };
    folder.write(name, text.as_bytes())
}

/// Checks that a design does not replace one of its own inputs in this folder. `more` contains inputs that are not in the scene.
///
/// # Errors
///
/// An input would be replaced. The error contains its path.
pub fn check_inputs_stay(folder: &Path, input: &Input, more: &[PathBuf]) -> Result<()> {
    let paths = input.paths()?;
    let paths = paths.iter().chain(more);
    let inputs: BTreeSet<PathBuf> = paths.filter_map(|p| p.canonicalize().ok()).collect();
    let names = of_design().into_iter().chain([SCENE_BESIDE_INPUT]);
    for name in names {
        inputs::check_among(&inputs, &folder.join(name))?;
    }
    inputs::check_in(folder, of_design())
}

fn same(a: &Path, b: &Path) -> bool {
    matches!((a.canonicalize(), b.canonicalize()), (Ok(a), Ok(b)) if a == b)
}
