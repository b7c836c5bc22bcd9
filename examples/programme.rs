//! A programme of classical motions → cam and checks.
//!
//! `cargo run --release --example programme`
use std::error::Error;

use gaitcam::cam::{Cam, Continuity, Follower};
use gaitcam::law::{Extent, Rise, Segment, program};

pub fn main() -> Result<(), Box<dyn Error>> {
    // Up 20 mm in 120°, dwell, down in 90°, dwell.
    let segment = |motion, lift, degrees: f64| Segment {
        motion,
        lift,
        angle: degrees.to_radians(),
    };
    let law = program(
        &[
            segment(Rise::from_name("cycloidal")?, 0.020, 120.0),
            segment(Rise::Dwell, 0.0, 60.0),
            segment(Rise::from_name("modified-sine")?, -0.020, 90.0),
            segment(Rise::Dwell, 0.0, 90.0),
        ],
        Extent::TURN,
    )?;
    let follower = Follower::RollerTranslating {
        prime_radius: 0.050,
        offset: 0.0,
        roller_radius: 0.010,
    };
    let cam = Cam::new(law, follower)?;

    let (fall, rise) = cam.pressure_angle_extremes();
    let sharpest = cam.curvature().convex;
    println!("{:?}", Continuity::of(&cam));
    println!(
        "pressure angle {:.2}° … {:.2}°",
        fall.value.to_degrees(),
        rise.value.to_degrees()
    );
    println!(
        "smallest convex radius {:.2} mm at {:.1}°",
        1e3 * sharpest.value,
        sharpest.at.to_degrees()
    );
    assert!(!cam.curvature().undercut);
    Ok(())
}
