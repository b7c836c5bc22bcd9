//! The emitted cam on its machine: from its points, not from the law that they came from.
//!
//! `cargo run --release --example simulate`
use std::error::Error;

use gaitcam::dynamics::{Model, Run, simulate};
use gaitcam::force::{Feet, model};
use gaitcam::{scene, synth};

pub fn main() -> Result<(), Box<dyn Error>> {
    let scene = scene::read(&scene::DEFAULT.parse()?)?;
    let target = model("young", Some(1.85), 700.0, Feet::Both)?;
    let design = synth::synthesise(&scene, Some(&target))?;
    let run = Run::new(design.cam.clone(), design.drive, 1440);
    let outcome = simulate(&run, Model::Auto)?;
    println!("model: {}", outcome.model.name());
    println!(
        "force {:.1} … {:.1} N",
        outcome.force.min, outcome.force.max
    );
    assert!(!outcome.contact_lost);
    assert!((outcome.force.max - design.force.max_n).abs() < 0.01 * design.force.max_n);
    Ok(())
}
