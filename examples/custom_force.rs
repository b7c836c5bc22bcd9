//! Designs the cam for a force given as numbers.
//!
//! `cargo run --release --example custom_force`
use std::error::Error;
use std::f64::consts::TAU;

use gaitcam::scene::Limits;
use gaitcam::scene::{CamSpec, Gait};
use gaitcam::synth::synthesise;
use gaitcam::{ForceCurve, LimitKind, Scene};

pub fn main() -> Result<(), Box<dyn Error>> {
    // One cycle of 0.8 s: 500 N with two harmonics, at equal steps of time.
    let samples = (0..256).map(|i| {
        let theta = TAU * f64::from(i) / 256.0;
        500.0 + 120.0 * theta.sin() + 40.0 * (2.0 * theta).cos()
    });
    let target = ForceCurve::from_samples("two harmonics", 0.8, samples.collect())?;

    // The cam carries the mass whose weight is the mean force; it turns once a cycle.
    let limits = Limits::default()
        .with(LimitKind::Stroke, 0.100)
        .with(LimitKind::Curvature, 0.005);
    let scene = Scene {
        name: "two harmonics".to_string(),
        gait: Some(Gait::given()),
        cam: CamSpec {
            bore: Some(0.012),
            ..CamSpec::default()
        },
        limits,
        rms: Some(0.005),
        ..Scene::default()
    };
    let design = synthesise(&scene, Some(&target))?;

    let (law, cam) = (&design.cam.law, &design.cam);
    println!("{}: {}", design.problem.name, design.verdict.name());
    println!("stroke {:.2} mm", 1e3 * law.stroke());
    println!("base radius {:.2} mm", 1e3 * cam.follower.base_radius());
    println!("force error {:.3} N RMS", design.force.rms_error_n);
    assert!((design.force.mean_n - 500.0).abs() < 1e-6);
    Ok(())
}
