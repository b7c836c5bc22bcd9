//! A grid of scenes, designed on all cores.
//!
//! `cargo run --release --example sweep`
use std::error::Error;

use gaitcam::error::Result;
use gaitcam::scene::{CamSpec, Gait};
use gaitcam::{Scene, synthesise};
use rayon::prelude::*;

pub fn main() -> std::result::Result<(), Box<dyn Error>> {
    let frequencies: Vec<f64> = (0..8).map(|i| 1.5 + 0.1 * f64::from(i)).collect();
    let strokes: Vec<f64> = frequencies
        .par_iter()
        .map(|&frequency| stroke(frequency))
        .collect::<Result<_>>()?;
    for (frequency, stroke) in frequencies.iter().zip(&strokes) {
        println!("{frequency:.1} Hz: {:.2} mm", 1e3 * stroke);
    }
    // Young's first factor grows with the frequency about as ω² does: the stroke hardly changes.
    assert!(strokes.iter().all(|s| (0.03..0.07).contains(s)));
    Ok(())
}

/// Stroke of the cam for a walker of 700 N at a step frequency.
fn stroke(frequency: f64) -> Result<f64> {
    let walker = Gait::model("young")
        .with_step_frequency(frequency)
        .with_body_weight(700.0);
    let scene = Scene::default()
        .with_gait(walker)
        .with_cam(CamSpec::default().with_bore(0.012))
        .with_accuracy(0.005);
    let design = synthesise(&scene, scene.model_force()?.as_ref())?;
    Ok(design.cam.law.stroke())
}
