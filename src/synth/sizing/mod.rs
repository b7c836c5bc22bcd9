//! Cam of a law, with the size given in the scene or with the minimum feasible size.

pub mod checked_cam;
mod notes;

pub use notes::notes;

use std::f64::consts::PI;

use crate::cam::{
    BarrelGroove, Cam, Conjugate, Follower, FollowerKind, LimitKind, PrimeCircle, Rollers,
    SizeLimits, least_between, smallest_base_radius, smallest_for, smallest_prime_circle,
};
use crate::error::{Error, NoDesignError, Placed, Result, SynthError};
use crate::law::Law;
use crate::problem::Problem;
use crate::synth::limits::{self, NEARLY_RIGHT};
use crate::units::Quantity;

/// Relative accuracy of a prime radius that is computed by bisection.
const BISECTION: f64 = 1e-12;
/// Factor between successive trial sizes in the search for a feasible size.
const GROWTH: f64 = 1.5;
const GROWTHS: i32 = 35;
/// Relative margin that is added to a size from bisection, so that limits hold in spite of rounding errors.
const ROUNDING: f64 = 1e-9;
/// Minimum radius of a cam, relative to the travel of the follower, if no requirement determines a larger radius.
const NOTHING: f64 = 1e-4;
/// Variation of s(θ) + s(θ + π), relative to the stroke, below which the breadth counts as constant.
const BREADTH: f64 = 1e-9;
/// Number of angles at which the breadth is computed and compared.
const BREADTH_POINTS: usize = 720;

/// Cam of a law. The lift 0 is on the base circle.
///
/// `pressing` is the law that determines the force: the law of the cam, or of the end of a polydyne follower.
///
/// # Errors
///
/// A dimension of the follower is missing, or the dimensions are impossible. Examples are an arm that is too short, a pivot inside the cam, or a
/// law without constant breadth.
pub fn cam(problem: &Problem, law: Law, pressing: &Law) -> Result<Cam> {
    let follower = match (problem.cam.follower, problem.cam.breadth) {
        (FollowerKind::FlatTranslating, None) => flat(problem, &law, pressing),
        (FollowerKind::RollerTranslating | FollowerKind::KnifeTranslating, None) => {
            roller(problem, &law, pressing)?
        }
        (_, None) => return sized(problem, law),
        (_, Some(breadth)) => return constant_breadth(problem, law, breadth),
    };
    Ok(Cam { law, follower })
}

/// Second cam of a conjugate pair; `None` if the scene has no pair.
pub fn conjugate(problem: &Problem, cam: &Cam) -> Result<Option<Conjugate>> {
    problem
        .cam
        .conjugate
        .and_then(|pair| {
            let conjugate = if problem.cam.pivot_beside {
                Conjugate::beside
            } else {
                Conjugate::new
            };
            Some(conjugate(cam, pair.closure()?, pair.roller_radius))
        })
        .transpose()
        .map_err(|e| e.at_key("cam.conjugate"))
}

/// Groove of a barrel cam, with both walls; `None` for other cams.
pub fn groove(problem: &Problem, cam: &Cam) -> Result<Option<BarrelGroove>> {
    let Follower::Barrel {
        radius,
        roller_radius,
    } = cam.follower
    else {
        return Ok(None);
    };
    let rollers = match problem.cam.eccentricity {
        None => Rollers::One {
            radius: roller_radius,
        },
        Some(eccentricity) => Rollers::TwoEccentric {
            radius: roller_radius,
            eccentricity,
        },
    };
    BarrelGroove::new(cam.law.clone(), radius - depth(problem), radius, rollers)
        .map(Some)
        .map_err(|e| e.at_key("cam.depth"))
}

/// Minimum base radius, m, for which the law satisfies the curvature limit of the scene without undercut. The other dimensions are those of
/// `cam`. `None` if no size is sufficient.
pub fn smallest_without_undercut(problem: &Problem, cam: &Cam) -> Option<f64> {
    let limits = SizeLimits {
        rho_min: problem.limits[LimitKind::Curvature].unwrap_or(0.0),
        pivot_beside: problem.cam.pivot_beside,
        ..SizeLimits::no_undercut()
    };
    smallest_for(cam, &limits).ok()
}

/// Depth of the groove of a barrel, m. The default is the diameter of the roller.
fn depth(problem: &Problem) -> f64 {
    problem.cam.depth.unwrap_or(2.0 * problem.cam.roller_radius)
}

fn flat(problem: &Problem, law: &Law, pressing: &Law) -> Follower {
    let rho = problem.limits[LimitKind::Curvature].unwrap_or(0.0);
    let base_radius = problem.base_radius().unwrap_or_else(|| {
        smallest_base_radius(law, rho)
            .max(problem.hub_radius_for(law))
            .max(limits::smallest_base_radius(problem, law, pressing))
    });
    Follower::FlatTranslating { base_radius }
}

/// Cam of constant breadth. The result is an error if the breadth of the law is not constant. The base or prime radius is half the
/// difference of breadth and lift.
fn constant_breadth(problem: &Problem, law: Law, breadth: f64) -> Result<Cam> {
    let key = |e: Error| e.at_key("cam.breadth");
    let sum = |theta: f64| law.svaj(theta).s + law.svaj(theta + PI).s;
    let lift = sum(0.0);
    let worst = (0..BREADTH_POINTS)
        .map(|i| PI * i as f64 / BREADTH_POINTS as f64)
        .map(|theta| (theta, (sum(theta) - lift).abs()))
        .max_by(|a, b| a.1.total_cmp(&b.1));
    if let Some((at, miss)) = worst.filter(|w| w.1 > BREADTH * law.stroke()) {
        return Err(key(NoDesignError::NoConstantBreadth {
            sum: Quantity::length(lift),
            miss: Quantity::length(miss),
            at: Quantity::angle(at),
        }
        .into()));
    }
    let spec = &problem.cam;
    let place = 0.5 * (breadth - lift);
    let offset = spec.offset.unwrap_or(0.0);
    if place <= 0.0 {
        return Err(key(NoDesignError::BreadthTooSmall {
            breadth: Quantity::length(breadth),
            lift: Quantity::length(lift),
        }
        .into()));
    }
    let follower = follower(problem, place, libm::hypot(place, offset), offset)?;
    Cam::new(law, follower).map_err(key)
}

fn roller(problem: &Problem, law: &Law, pressing: &Law) -> Result<Follower> {
    let spec = &problem.cam;
    let [rise, fall] = problem
        .sizing_pressure_angles()
        .map(|angle| angle.min(NEARLY_RIGHT));
    let make = |prime: f64, offset: f64| follower(problem, prime, prime, offset);
    if let Some(prime) = problem.prime_radius() {
        return make(prime, spec.offset.unwrap_or(0.0));
    }
    let PrimeCircle { radius, offset } = smallest_prime_circle(law, rise, fall, spec.offset);
    let lift = (radius.powi(2) - offset.powi(2)).max(0.0).sqrt();
    let least =
        (problem.hub_radius_for(law) + spec.roller_radius).max(next_to_nothing(problem, law));
    let wanted = problem.limits[LimitKind::Curvature].unwrap_or(0.0);
    let bearable = limits::bearable_on_some_size(problem, pressing);
    let press = limits::Press::of(problem, pressing);
    // A larger D at the same offset relaxes the limits on pressure angle, curvature and pressure.
    let holds = |d: f64| {
        let prime = libm::hypot(d, offset);
        if prime < least || offset.abs() >= prime {
            return false;
        }
        let Ok(follower) = make(prime, offset) else {
            return false;
        };
        let law = law.clone();
        let cam = Cam { law, follower };
        let curvature = cam.curvature();
        curvature.convex.value >= wanted
            && !curvature.undercut
            && bearable.is_none_or(|most| press.on(&cam).value <= most)
    };
    if holds(lift) {
        return make(libm::hypot(lift, offset), offset);
    }
    let first = lift.max(least);
    let high = (0..GROWTHS)
        .map(|k| first * GROWTH.powi(k))
        .find(|&d| holds(d))
        .ok_or_else(|| NoDesignError::NoPrimeCircle.at_key("limits.curvature"))?;
    let distance = least_between(lift, high, BISECTION, holds);
    make(libm::hypot(distance, offset), offset)
}

/// Minimum radius of a cam, m, if no limit and no bore determines the size.
fn next_to_nothing(problem: &Problem, law: &Law) -> f64 {
    let travel = law.stroke() * problem.lever();
    if travel > 0.0 {
        NOTHING * travel
    } else {
        NOTHING
    }
}

/// Cam for followers other than translating flat faces, rollers and sharp edges. The base radius is given, or it is the minimum feasible
/// radius.
fn sized(problem: &Problem, law: Law) -> Result<Cam> {
    let spec = &problem.cam;
    let given = problem.base_radius();
    // `smallest_for` ignores the base radius of the cam, so any value is permitted here.
    let follower = on_base_circle(problem, given.unwrap_or(1.0))?;
    if given.is_some() || matches!(follower, Follower::TranslatingCam { .. }) {
        return fitting(problem, law, follower);
    }
    let limits = &problem.limits;
    let [pressure_rise, pressure_fall] = problem.sizing_pressure_angles();
    let limits = SizeLimits {
        rho_min: limits[LimitKind::Curvature].unwrap_or(0.0),
        pressure_rise,
        pressure_fall,
        pivot_beside: spec.pivot_beside,
    };
    let cam = Cam { law, follower };
    let smallest = smallest_for(&cam, &limits).map_err(|e| e.at_key("cam.base_radius"))?;
    let barrel = matches!(follower, Follower::Barrel { .. });
    // The groove of a barrel is steepest at its floor, where the limits must hold. The radius of the floor must exceed the radius of the
    // roller.
    let base = if barrel {
        smallest
            .max(problem.hub_radius_for(&cam.law))
            .max(spec.roller_radius * (1.0 + 1e-6))
            + depth(problem)
    } else {
        smallest
            .max(problem.hub_radius_for(&cam.law))
            .max(next_to_nothing(problem, &cam.law))
    };
    let base = base * (1.0 + ROUNDING);
    fitting(problem, cam.law, follower.with_base_radius(base))
}

/// Creates the cam and checks whether the follower is possible for the law. If `pivot_beside` is set, the pivot is beside the cam.
fn fitting(problem: &Problem, law: Law, follower: Follower) -> Result<Cam> {
    let new = if problem.cam.pivot_beside {
        Cam::beside
    } else {
        Cam::new
    };
    new(law, follower).map_err(|e| e.at_key("cam"))
}

/// Checks whether an arm of the given length reaches the prime circle. The result does not depend on the law.
///
/// # Errors
///
/// The arm or its pivot distance is invalid.
pub fn check_arm(problem: &Problem) -> Result<()> {
    let Some(base) = problem
        .base_radius()
        .filter(|_| problem.cam.follower.is_oscillating())
    else {
        return Ok(());
    };
    let cam = Cam {
        law: Law::harmonic(0.0, &[]),
        follower: on_base_circle(problem, base)?,
    };
    cam.check_beside().map_err(|e| e.at_key("cam"))
}

/// Follower of the scene for a base radius, m.
fn on_base_circle(problem: &Problem, base: f64) -> Result<Follower> {
    let (radius, offset) = (problem.cam.roller_radius, problem.cam.offset);
    follower(problem, base, base + radius, offset.unwrap_or(0.0))
}

/// Follower of the scene for given radii, m. A follower with a roller or an arc uses the prime radius, other followers the base radius.
fn follower(
    problem: &Problem,
    base_radius: f64,
    prime_radius: f64,
    offset: f64,
) -> Result<Follower> {
    let spec = &problem.cam;
    let missing = |key: &str| SynthError::FollowerNeeds.at_key(&format!("cam.{key}"));
    let pivot = || spec.pivot_distance.ok_or_else(|| missing("pivot_distance"));
    let arm = || spec.arm.ok_or_else(|| missing("arm"));
    Ok(match spec.follower {
        FollowerKind::MushroomTranslating => Follower::MushroomTranslating {
            prime_radius,
            offset,
            arc_radius: spec.roller_radius,
        },
        FollowerKind::RollerOscillating | FollowerKind::KnifeOscillating => {
            Follower::RollerOscillating {
                pivot_distance: pivot()?,
                arm: arm()?,
                prime_radius,
                roller_radius: spec.roller_radius,
            }
        }
        FollowerKind::MushroomOscillating => Follower::MushroomOscillating {
            pivot_distance: pivot()?,
            arm: arm()?,
            prime_radius,
            arc_radius: spec.roller_radius,
        },
        FollowerKind::FlatOscillating => Follower::FlatOscillating {
            pivot_distance: pivot()?,
            face_offset: spec.face_offset,
            base_radius,
        },
        FollowerKind::TranslatingCam => Follower::TranslatingCam {
            // The height has no effect on the law. The default only determines the appearance of the cam.
            base_height: problem.base_radius().unwrap_or(2.0 * spec.roller_radius),
            roller_radius: spec.roller_radius,
        },
        FollowerKind::Barrel => Follower::Barrel {
            radius: base_radius,
            roller_radius: spec.roller_radius,
        },
        FollowerKind::FlatTranslating => Follower::FlatTranslating { base_radius },
        FollowerKind::RollerTranslating | FollowerKind::KnifeTranslating => {
            Follower::RollerTranslating {
                prime_radius,
                offset,
                roller_radius: spec.roller_radius,
            }
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::synth::samples::{FLAT, amplitude, one_wave};

    /// Law s = A (1 − cos θ), which is on its base circle.
    fn wave(problem: &Problem) -> Law {
        let a = amplitude(problem);
        Law::harmonic(a, &[(-a, 0.0)])
    }

    fn sized(problem: &Problem) -> Cam {
        let law = wave(problem);
        cam(problem, law.clone(), &law).unwrap()
    }

    /// The tangent of the pressure angle is A sin θ/(D + A − A cos θ). The maximum pressure angle is φ for D = A (1/sin φ − 1).
    #[test]
    fn the_smallest_roller_cam_of_one_wave_has_the_pressure_angle_that_is_allowed() {
        let follower =
            "follower = \"roller-translating\"\nroller_radius = \"1 mm\"\noffset = \"0 mm\"";
        for degrees in [15.0_f64, 20.0, 28.0] {
            let problem = one_wave(follower, &format!("pressure_angle = \"{degrees} deg\""));
            let prime = sized(&problem).follower.prime_radius();
            let wanted = amplitude(&problem) * (1.0 / degrees.to_radians().sin() - 1.0);
            assert!(
                (prime / wanted - 1.0).abs() < 1e-6,
                "{degrees}: {prime} {wanted}"
            );
        }
    }

    #[test]
    fn a_flat_cam_is_as_large_as_curvature_and_hub_ask() {
        // s + a = A everywhere: ρ = R + A.
        let problem = one_wave(FLAT, "curvature = \"60 mm\"");
        let base = sized(&problem).follower.base_radius();
        assert!((base + amplitude(&problem) - 0.06).abs() < 1e-12);
        let bored = one_wave(
            &format!("{FLAT}\nbore = \"80 mm\""),
            "curvature = \"60 mm\"",
        );
        assert_eq!(sized(&bored).follower.base_radius(), bored.hub_radius());
        let given = one_wave(&format!("{FLAT}\nbase_radius = \"33 mm\""), "");
        assert_eq!(sized(&given).follower.base_radius(), 0.033);
    }
}
