//! Functions that tests of several crates share: scenes from text and changes, their designs, laws from a list of motions.

#![forbid(unsafe_code)]
#![deny(missing_docs)]
#![cfg_attr(not(test), warn(unused_crate_dependencies))]

pub mod designs;
mod fluent;
mod memory;
pub mod readers;
pub mod thesis;
pub mod words;

pub use memory::Memory;

use std::path::Path;

use gaitcam::error::Result;
use gaitcam::force::{Feet, ForceCurve, model};
use gaitcam::law::{Extent, Law, Rise, Segment, program};
use gaitcam::scene::{self, Scene};
use gaitcam::synth::{Design, synthesise};

/// Root of the repository.
pub fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
}

/// Text of a scene in the folder `scenes`.
///
/// # Panics
///
/// If there is no scene with this name.
pub fn scene_file(name: &str) -> String {
    let path = root().join(format!("scenes/{name}.toml"));
    std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// Scene from a text with changes, each as `key=value`.
///
/// # Errors
///
/// A key or value is invalid.
///
/// # Panics
///
/// If the text is not TOML.
pub fn scene<C: AsRef<str>>(text: &str, changes: &[C]) -> Result<Scene> {
    let mut table: toml::Table = text.parse().unwrap_or_else(|e| panic!("{e}"));
    for change in changes {
        scene::set(&mut table, change.as_ref())?;
    }
    scene::read(&table)
}

/// Design from a text with changes, for the force of the load model that it names.
///
/// # Errors
///
/// Errors of scene, model and synthesis.
pub fn design<C: AsRef<str>>(text: &str, changes: &[C]) -> Result<Design> {
    let scene = scene(text, changes)?;
    synthesise(&scene, scene.model_force()?.as_ref())
}

/// As [`scene`], for a valid text and valid changes.
///
/// # Panics
///
/// If the scene cannot be read.
#[track_caller]
pub fn scene_of(text: &str, changes: &[&str]) -> Scene {
    scene(text, changes).unwrap_or_else(|e| panic!("{e}"))
}

/// As [`design`], for a scene with a design.
///
/// # Panics
///
/// If there is no design.
#[track_caller]
pub fn design_of(text: &str, changes: &[&str]) -> Design {
    design(text, changes).unwrap_or_else(|e| panic!("{e}"))
}

/// Force of both feet of a walker of 700 N at 1.85 steps per second, by Young's model.
///
/// # Panics
///
/// If the model is missing.
pub fn young() -> ForceCurve {
    model("young", Some(1.85), 700.0, Feet::Both).unwrap_or_else(|e| panic!("{e}"))
}

/// Design of a scene in the folder `scenes`.
///
/// # Panics
///
/// If there is no scene with this name, or no design of it.
pub fn designed(name: &str) -> Design {
    design::<&str>(&scene_file(name), &[]).unwrap_or_else(|e| panic!("{name}: {e}"))
}

/// Segments from motions given by name, lift and angle in degrees.
///
/// # Panics
///
/// If the catalogue does not contain a name.
pub fn segments(motions: &[(&str, f64, f64)]) -> Vec<Segment> {
    let segment = |&(motion, lift, degrees): &(&str, f64, f64)| Segment {
        motion: Rise::from_name(motion).unwrap_or_else(|e| panic!("{e}")),
        lift,
        angle: degrees.to_radians(),
    };
    motions.iter().map(segment).collect()
}

/// Law of such motions over one turn.
///
/// # Panics
///
/// If the motions do not fill one turn.
pub fn turn(motions: &[(&str, f64, f64)]) -> Law {
    program(&segments(motions), Extent::TURN).unwrap_or_else(|e| panic!("{e}"))
}

/// Asserts that a value equals the expected one.
///
/// # Panics
///
/// If the difference exceeds `within`.
#[track_caller]
pub fn near(value: f64, expected: f64, within: f64) {
    assert!(
        (value - expected).abs() <= within,
        "{value} is not {expected}"
    );
}
