//! A programme of classical motions → cam and checks.
//!
//! `cargo run --release --example programme`
use std::error::Error;

use gaitcam::cam::Continuity;
use gaitcam::law::Rise;
use gaitcam::scene::{CamSpec, DriveSpec, LawSpec, SegmentSpec};
use gaitcam::{FollowerKind, LimitKind, Limits, Scene, synthesise};

pub fn main() -> Result<(), Box<dyn Error>> {
    // Up 20 mm in 120°, dwell, down in 90°, dwell.
    let angle = f64::to_radians;
    let law = LawSpec::program(vec![
        SegmentSpec::new(Rise::Cycloidal, 0.020, angle(120.0)),
        SegmentSpec::dwell(angle(60.0)),
        SegmentSpec::new(Rise::ModifiedSine, -0.020, angle(90.0)),
        SegmentSpec::dwell(angle(90.0)),
    ]);
    let cam = CamSpec::new(FollowerKind::RollerTranslating)
        .with_prime_radius(0.050)
        .with_offset(0.0)
        .with_roller(0.010);
    let scene = Scene::default()
        .named("two dwells")
        .with_drive(DriveSpec::fixed_axis(0.5, 2000.0).with_speed(10.0))
        .with_law(law)
        .with_cam(cam)
        .with_limits(Limits::default().with(LimitKind::PressureAngle, angle(30.0)));
    let design = synthesise(&scene, None)?;

    println!("{}: {}", design.name, design.verdict.name());
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
