//! A law with its cam, force and checks. This type is used for every family, for the iterates of a polydyne cam and for the finished
//! design.

use crate::cam::{BarrelGroove, Cam, Check, Conjugate, LimitKind, PrimeCircle};
use crate::error::Result;
use crate::law::Law;
use crate::problem::Problem;
use crate::synth::limits::{ENLARGED, Finished, diameter_check};
use crate::synth::report::force::ForceReport;
use crate::synth::sizing;

/// A law with its cam, its force and all checks.
#[derive(Clone)]
pub struct CheckedCam {
    /// Cam of the law. The minimum lift is on the base circle, unless the drive or a condition fixes the level of the lift.
    pub cam: Cam,
    /// Shift by which the law was raised to the base circle, m or rad.
    pub raised: f64,
    /// Law of the end of a compliant follower, with the same shift; `None` without a polydyne cam.
    pub end: Option<Law>,
    /// Second cam of a conjugate pair, if any.
    pub conjugate: Option<Conjugate>,
    /// Groove of a barrel cam, with both walls.
    pub groove: Option<BarrelGroove>,
    /// Comparison of achieved force and target.
    pub force: ForceReport,
    /// Checks of every limit of the problem, and of general requirements.
    pub checks: Vec<Check>,
}

/// Cam of a law, with force and checks. `end` is the law of a compliant follower's end. `circle` is a prime circle on which the law satisfies
/// its limits.
///
/// # Errors
///
/// The dimensions do not determine a cam.
pub fn checked_cam(
    problem: &Problem,
    law: &Law,
    circle: Option<PrimeCircle>,
    end: Option<&Law>,
) -> Result<CheckedCam> {
    let own = on_base_circle(problem, law);
    let start = law.extent().0;
    let raised = own.svaj(start).s - law.svaj(start).s;
    let end = end.map(|end| end.raised(raised));
    let cam = cam_about(problem, own.clone(), end.as_ref().unwrap_or(&own), circle)?;
    checked(problem, cam, raised, end)
}

/// Computes force and checks of a cam for a problem.
fn checked(problem: &Problem, cam: Cam, raised: f64, end: Option<Law>) -> Result<CheckedCam> {
    let conjugate = sizing::conjugate(problem, &cam)?;
    let groove = sizing::groove(problem, &cam)?;
    let pressing = end.as_ref().unwrap_or(&cam.law);
    let force = ForceReport::of(problem, pressing);
    let finished = Finished {
        problem,
        cam: &cam,
        second: conjugate.as_ref().map(|pair| &pair.second),
        groove: groove.as_ref(),
        pressing,
        force: &force,
    };
    let checks = finished.checks();
    Ok(CheckedCam {
        cam,
        raised,
        end,
        conjugate,
        groove,
        force,
        checks,
    })
}

impl CheckedCam {
    /// The same cam with the force and the checks of another problem.
    ///
    /// # Errors
    ///
    /// The dimensions do not determine a second cam or a groove.
    pub fn at(&self, problem: &Problem) -> Result<CheckedCam> {
        checked(problem, self.cam.clone(), self.raised, self.end.clone())
    }

    /// Law that determines the force: the law of the follower's end for a polydyne cam, otherwise the law of the cam.
    pub fn pressing(&self) -> &Law {
        self.end.as_ref().unwrap_or(&self.cam.law)
    }

    /// First failed check; `None` if every check passes.
    pub fn broken(&self) -> Option<&Check> {
        self.checks.iter().find(|check| !check.pass)
    }
}

/// Smallest cam with which a law satisfies its limits. `circle` is a prime circle from the program of the law. The offset of this circle is
/// also tried, for two reasons. The best offset for the pressure angle may differ from the best offset for the curvature. A cam with a
/// smaller prime radius may have a larger diameter.
fn cam_about(
    problem: &Problem,
    law: Law,
    pressing: &Law,
    circle: Option<PrimeCircle>,
) -> Result<Cam> {
    let own = sizing::cam(problem, law.clone(), pressing)?;
    let radius = |cam: &Cam| cam.follower.prime_radius();
    // Radii that differ by less than the margin of the program are treated as equal.
    let smaller = (1.0 - ENLARGED) * radius(&own);
    let too_wide = is_too_wide(problem, &own);
    let Some(circle) = circle.filter(|circle| circle.radius < smaller || too_wide) else {
        return Ok(own);
    };
    let other = sizing::cam(&problem.at_offset(circle.offset), law, pressing)?;
    let is_better = match (too_wide, is_too_wide(problem, &other)) {
        (true, false) => true,
        (false, true) => false,
        _ => radius(&other) < smaller,
    };
    Ok(if is_better { other } else { own })
}

/// Whether a cam violates the limit on the diameter.
fn is_too_wide(problem: &Problem, cam: &Cam) -> bool {
    diameter_check(problem, cam, LimitKind::Diameter).is_some_and(|check| !check.pass)
}

/// The law, raised or lowered until its minimum is on the base circle. If the drive or a condition fixes the level of the lift, the law is
/// unchanged.
fn on_base_circle(problem: &Problem, law: &Law) -> Law {
    if problem.level_is_known() {
        return law.clone();
    }
    law.raised(-law.extremes(0).0.value)
}
