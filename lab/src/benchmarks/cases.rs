//! Scenes, forces and laws for several groups of benchmarks.

use std::f64::consts::TAU;

use gaitcam::drive::Drive;
use gaitcam::force::{Feet, ForceCurve, model};
use gaitcam::law::{Extent, Law, Rise, Segment, program};
use gaitcam::scene::{self, Scene};

/// Force of a pedestrian on a footbridge, and the drive for this weight.
pub(crate) fn footbridge() -> (ForceCurve, Drive) {
    let target = model("young", Some(1.85), 700.0, Feet::Both).expect("a known model");
    let drive = Drive::moving_axis(target.mean_n() / 9.81, 9.81, TAU / target.period_s);
    (target, drive)
}

/// Default scene with changes.
pub(crate) fn scene_with(changes: &[&str]) -> Scene {
    let mut table = scene::DEFAULT.parse().expect("the built-in scene");
    for change in changes {
        scene::set(&mut table, change).expect("a key of the scene");
    }
    scene::read(&table).expect("a scene")
}

/// Law of rise, dwell, fall and dwell, a quarter of the length each.
pub(crate) fn turn(motion: &str, lift: f64, extent: Extent, length: f64) -> Law {
    let quarter = |motion: &str, lift: f64| Segment {
        motion: Rise::from_name(motion).expect("in the catalogue"),
        lift,
        angle: 0.25 * length,
    };
    let segments = [
        quarter(motion, lift),
        quarter("dwell", 0.0),
        quarter(motion, -lift),
        quarter("dwell", 0.0),
    ];
    program(&segments, extent).expect("a quarter each fills the extent")
}
