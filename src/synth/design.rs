//! From a law to its cam: the size that the scene fixes, or the smallest that meets the limits.

use crate::cam::{Cam, Follower, smallest_base_radius, smallest_prime_circle};
use crate::error::{Error, Result};
use crate::law::Law;
use crate::scene::Scene;

/// Pressure angle that sizes a roller cam when the scene limits none: 30°, the usual rule.
pub const USUAL_PRESSURE_ANGLE: f64 = std::f64::consts::PI / 6.0;
/// Room around a bore, m, when the base circle follows from it.
const WALL: f64 = 1e-3;
/// Relative accuracy of a prime radius found by bisection.
const BISECTION: f64 = 1e-12;
/// A prime circle this many times the first guess without success is no cam.
const LARGEST_GROWTH: f64 = 1e6;

/// The cam for a law whose zero is the base circle.
///
/// Fails on a follower that needs a length the scene does not give.
pub fn cam(scene: &Scene, law: Law) -> Result<Cam> {
    let spec = &scene.cam;
    let follower = match spec.follower.as_str() {
        "flat-translating" => flat(scene, &law),
        "roller-translating" | "knife-translating" => roller(scene, &law)?,
        other => {
            return Err(Error::key(
                "cam.follower",
                format!("\"{other}\" is not known here"),
            ));
        }
    };
    Ok(Cam { law, follower })
}

/// Smallest base radius that the bore leaves.
fn outside_bore(scene: &Scene) -> f64 {
    scene.cam.bore.map_or(0.0, |b| 0.5 * b + WALL)
}

fn flat(scene: &Scene, law: &Law) -> Follower {
    let rho = scene.limits.curvature.unwrap_or(0.0);
    let base_radius = scene
        .cam
        .base_radius
        .or(scene.cam.prime_radius)
        .unwrap_or_else(|| smallest_base_radius(law, rho).max(outside_bore(scene)));
    Follower::FlatTranslating { base_radius }
}

fn roller(scene: &Scene, law: &Law) -> Result<Follower> {
    let spec = &scene.cam;
    let given = super::limits::prime_radius(scene);
    let rise = scene
        .limits
        .pressure_angle_rise
        .unwrap_or(USUAL_PRESSURE_ANGLE);
    let fall = scene
        .limits
        .pressure_angle_fall
        .unwrap_or(USUAL_PRESSURE_ANGLE);
    let make = |prime_radius: f64, offset: f64| Follower::RollerTranslating {
        prime_radius,
        offset,
        roller_radius: spec.roller_radius,
    };
    if let Some(prime) = given {
        let offset = spec.offset.unwrap_or(0.0);
        if offset.abs() >= prime {
            return Err(Error::key(
                "cam.offset",
                format!("{offset} m reaches the prime circle of {prime} m"),
            )
            .help("the offset must be smaller than the prime radius"));
        }
        return Ok(make(prime, offset));
    }
    let circle = smallest_prime_circle(law, rise, fall, spec.offset);
    let (lift, offset) = (
        (circle.radius.powi(2) - circle.offset.powi(2))
            .max(0.0)
            .sqrt(),
        circle.offset,
    );
    let least = (outside_bore(scene) + spec.roller_radius).max(1e-6);
    let wanted = scene.limits.curvature.unwrap_or(0.0);
    // Growing D at the same offset relaxes the pressure angle and the curvature alike.
    let holds = |d: f64| {
        let prime = d.hypot(offset);
        if prime < least || offset.abs() >= prime {
            return false;
        }
        let curvature = Cam {
            law: law.clone(),
            follower: make(prime, offset),
        }
        .curvature();
        curvature.convex.value >= wanted && !curvature.undercut
    };
    let first = lift.max(least * 1e-3);
    if holds(lift) {
        return Ok(make(lift.hypot(offset), offset));
    }
    let mut high = first.max(least);
    while !holds(high) {
        high *= 1.5;
        if high > LARGEST_GROWTH * first.max(least) {
            return Err(
                Error::key("limits.curvature", "no prime circle is large enough for it")
                    .help("a law with a jump in velocity has a corner that no size removes"),
            );
        }
    }
    let mut low = lift;
    while high - low > BISECTION * high {
        let mid = 0.5 * (low + high);
        if holds(mid) {
            high = mid;
        } else {
            low = mid;
        }
    }
    Ok(make(high.hypot(offset), offset))
}
