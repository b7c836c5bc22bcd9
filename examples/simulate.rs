//! Simulates the emitted cam on its machine, from its points instead of its law.
//!
//! `cargo run --release --example simulate`
use std::error::Error;

use gaitcam::Scene;
use gaitcam::dynamics::simulate;
use gaitcam::dynamics::{Model, Run};
use gaitcam::scene::{CamSpec, Gait};
use gaitcam::synth::synthesise;

pub fn main() -> Result<(), Box<dyn Error>> {
    let scene = Scene {
        gait: Some(Gait {
            step_frequency: Some(1.85),
            ..Gait::model("young")
        }),
        cam: CamSpec {
            bore: Some(0.012),
            ..CamSpec::default()
        },
        rms: Some(0.005),
        ..Scene::default()
    };
    let design = synthesise(&scene, scene.model_force()?.as_ref())?;

    let run = Run::new(design.cam.clone(), design.problem.drive, 1440);
    let outcome = simulate(&run, Model::Auto)?;
    println!("model: {}", outcome.model.name());
    let force = outcome.force;
    println!("force {:.1} … {:.1} N", force.min, force.max);
    assert!(!outcome.contact_lost);
    assert!((force.max - design.force.max_n).abs() < 0.01 * design.force.max_n);
    Ok(())
}
