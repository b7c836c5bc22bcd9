//! Designs the cam for a programme of classical motions and prints its checks.
//!
//! `cargo run --release --example programme`
use std::error::Error;

use gaitcam::cam::Continuity;
use gaitcam::cam::FollowerKind;
use gaitcam::law::Rise;
use gaitcam::scene::Limits;
use gaitcam::scene::{CamSpec, DriveSpec, LawSpec, SegmentSpec};
use gaitcam::synth::synthesise;
use gaitcam::{LimitKind, Scene};

pub fn main() -> Result<(), Box<dyn Error>> {
    // Up 20 mm in 120°, dwell, down in 90°, dwell.
    let angle = f64::to_radians;
    let law = LawSpec::program(vec![
        SegmentSpec::new(Rise::Cycloidal, 0.020, angle(120.0)),
        SegmentSpec::dwell(angle(60.0)),
        SegmentSpec::new(Rise::ModifiedSine, -0.020, angle(90.0)),
        SegmentSpec::dwell(angle(90.0)),
    ]);
    let scene = Scene {
        name: "two dwells".to_string(),
        drive: DriveSpec {
            speed: Some(10.0),
            ..DriveSpec::fixed_axis(0.5, 2000.0)
        },
        law,
        cam: CamSpec {
            prime_radius: Some(0.050),
            roller_radius: 0.010,
            ..CamSpec::new(FollowerKind::RollerTranslating)
        },
        limits: Limits::default().with(LimitKind::PressureAngle, angle(30.0)),
        ..Scene::default()
    };
    let design = synthesise(&scene, None)?;

    println!("{}: {}", design.problem.name, design.verdict.name());
    for check in &design.checks {
        let outcome = if check.pass { "ok" } else { "fails" };
        println!(
            "{outcome:<6} {} at {:.1}°",
            check.name,
            check.at.to_degrees()
        );
    }
    let continuity = Continuity::of(&design.cam);
    assert!(continuity.s && continuity.v && continuity.a);
    assert!(!design.cam.curvature().undercut);
    Ok(())
}
