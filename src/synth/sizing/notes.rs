//! Notes on the size of a finished cam: bore, shaft, roller, and defaults.

use std::f64::consts::PI;

use super::ROUNDING;
use crate::cam::{Cam, Follower, LimitKind, Measures};
use crate::law::Law;
use crate::problem::{Note, Problem, Size, USUAL_PRESSURE_ANGLE};
use crate::synth::limits;
use crate::units::{Dimension, Quantity};

/// Permitted shear stress of a shaft of mild steel, Pa.
const SHEAR: f64 = 40e6;
/// Ratio of the bore and the required shaft diameter above which the unit of the bore is probably wrong.
const WIDE_HOLE: f64 = 8.0;

/// All notes on the size of a cam.
pub fn notes(problem: &Problem, cam: &Cam, pressing: &Law) -> Vec<Note> {
    let (size, wall) = (chosen_size(problem, cam), thin_wall(problem, cam));
    let shaft = shaft(problem, cam, pressing);
    let roller = large_roller(problem, cam);
    [size, wall, shaft, roller].into_iter().flatten().collect()
}

/// Note on a roller that is larger than the cam, because its unit may be wrong.
fn large_roller(problem: &Problem, cam: &Cam) -> Option<Note> {
    let follower = &cam.follower;
    let largest = follower.base_radius() + problem.lever() * cam.law.stroke();
    let rolls = !follower.is_unrolled() && !follower.kind().is_mushroom();
    (rolls && follower.roller_radius() > largest).then(|| Note::LargeRoller {
        roller: Quantity::length(follower.roller_radius()),
        cam: Quantity::length(largest),
    })
}

/// Note on a thin wall between bore and base circle. If the bore intersects the profile, a check fails instead.
fn thin_wall(problem: &Problem, cam: &Cam) -> Option<Note> {
    let hole = problem.cam.hole()?;
    let wall = cam.follower.base_radius() - hole.reach();
    let usual = hole.hub_radius() - hole.reach();
    let turns = !cam.follower.is_unrolled();
    (turns && wall > 0.0 && wall < usual * (1.0 - ROUNDING)).then(|| Note::ThinWall {
        wall: Quantity::length(wall),
        usual: Quantity::length(usual),
    })
}

/// Note on a base circle that is too small for the steel shaft that the torque requires. If a bore is given, the note is instead about a bore
/// that is much larger than this shaft.
fn shaft(problem: &Problem, cam: &Cam, pressing: &Law) -> Option<Note> {
    let circle = 2.0 * cam.follower.base_radius();
    let turns = cam.follower.measures() != Measures::Straight;
    if !turns || circle <= 0.0 {
        return None;
    }
    let force = problem.force_curve(pressing);
    let torque = limits::largest(&limits::torque_curve(force, &cam.law)).value;
    // The shear stress of a solid shaft of diameter d under the torque T is τ = 16 T/(π d³).
    let least = libm::cbrt(16.0 * torque / (PI * SHEAR));
    let [circle, shaft, torque] = [
        Quantity::length(circle),
        Quantity::length(least),
        Quantity::new(torque, Dimension::Torque),
    ];
    match problem.cam.bore {
        None => (circle.value < least).then_some(Note::ThinShaft {
            circle,
            shaft,
            torque,
        }),
        Some(bore) => (bore > WIDE_HOLE * least && least > 0.0).then_some(Note::LargeBore {
            bore: Quantity::length(bore),
            shaft,
            torque,
        }),
    }
}

/// Note on default values that determine the size.
fn chosen_size(problem: &Problem, cam: &Cam) -> Option<Note> {
    if matches!(problem.size(), Size::Given { .. }) || problem.cam.breadth.is_some() {
        return None;
    }
    if cam.follower.base_radius() <= 0.0 && matches!(cam.follower, Follower::FlatTranslating { .. })
    {
        return Some(Note::NoBaseCircle);
    }
    let limits = &problem.limits;
    let asked = limits[LimitKind::PressureAngleRise].is_some()
        || limits[LimitKind::PressureAngleFall].is_some();
    let by_curvature_alone =
        cam.follower.is_flat() || matches!(cam.follower, Follower::TranslatingCam { .. });
    if asked || by_curvature_alone {
        return None;
    }
    let (low, high) = cam.pressure_angle_extremes();
    let steepest = high.value.max(-low.value);
    (steepest > USUAL_PRESSURE_ANGLE * (1.0 - 1e-6)).then(|| Note::UsualPressureAngle {
        angle: Quantity::angle(USUAL_PRESSURE_ANGLE),
    })
}
