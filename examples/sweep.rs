//! A grid of scenes, designed on all cores.
//!
//! `cargo run --release --example sweep`
use std::error::Error;

use gaitcam::force::{Feet, model};
use gaitcam::{scene, synth};
use rayon::prelude::*;

pub fn main() -> Result<(), Box<dyn Error>> {
    let frequencies: Vec<f64> = (0..8).map(|i| 1.5 + 0.1 * f64::from(i)).collect();
    let strokes = frequencies
        .par_iter()
        .map(|&frequency| stroke(frequency))
        .collect::<gaitcam::error::Result<Vec<f64>>>()?;
    for (frequency, stroke) in frequencies.iter().zip(&strokes) {
        println!("{frequency:.1} Hz: {:.2} mm", 1e3 * stroke);
    }
    // Young's first factor grows with the frequency about as ω² does: the stroke hardly changes.
    assert!(strokes.iter().all(|s| (0.03..0.07).contains(s)));
    Ok(())
}

/// Stroke of the cam for a walker of 700 N at a step frequency.
fn stroke(frequency: f64) -> gaitcam::error::Result<f64> {
    let mut table = scene::DEFAULT.parse().unwrap_or_default();
    scene::set(&mut table, &format!("gait.step_frequency={frequency} Hz"))?;
    let target = model("young", Some(frequency), 700.0, Feet::Both)?;
    let design = synth::synthesise(&scene::read(&table)?, Some(&target))?;
    Ok(design.cam.law.stroke())
}
