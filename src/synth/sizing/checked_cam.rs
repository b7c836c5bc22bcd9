//! A law on its cam, with force and checks; for every family, every iterate of a polydyne cam and the finished design.

use crate::cam::{BarrelGroove, Cam, Check, Conjugate, LimitKind, PrimeCircle};
use crate::error::Result;
use crate::law::Law;
use crate::problem::Problem;
use crate::synth::limits::{ENLARGED, Finished, diameter_check, force_report};
use crate::synth::report::force::ForceReport;
use crate::synth::sizing;

/// A law on its cam, with its force and all checks.
#[derive(Clone)]
pub struct CheckedCam {
    /// Cam of the law. The minimum lift is on the base circle unless the drive or a condition determines the level.
    pub cam: Cam,
    /// Shift of the law to the base circle, in units of its lift.
    pub raised: f64,
    /// Law of the end of a compliant follower, with the same shift.
    pub end: Option<Law>,
    /// Second cam of a conjugate pair, if any.
    pub conjugate: Option<Conjugate>,
    /// Groove of a barrel, with both walls.
    pub groove: Option<BarrelGroove>,
    /// Comparison of force and target, N.
    pub force: ForceReport,
    /// Checks of every limit of the problem, and of general requirements.
    pub checks: Vec<Check>,
}

/// Cam of a law. `end` is the law of the end of a compliant follower; `circle` is a size for which the law satisfies its limits.
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

/// Checks of a problem for a cam.
fn checked(problem: &Problem, cam: Cam, raised: f64, end: Option<Law>) -> Result<CheckedCam> {
    let conjugate = sizing::conjugate(problem, &cam)?;
    let groove = sizing::groove(problem, &cam)?;
    let pressing = end.as_ref().unwrap_or(&cam.law);
    let force = force_report(problem, pressing);
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
    /// The cam with the force and the checks of another problem.
    ///
    /// # Errors
    ///
    /// The dimensions do not determine a second cam or a groove.
    pub fn at(&self, problem: &Problem) -> Result<CheckedCam> {
        checked(problem, self.cam.clone(), self.raised, self.end.clone())
    }

    /// Law that determines the force.
    pub fn pressing(&self) -> &Law {
        self.end.as_ref().unwrap_or(&self.cam.law)
    }

    /// First failed check.
    pub fn broken(&self) -> Option<&Check> {
        self.checks.iter().find(|check| !check.pass)
    }
}

/// Smallest cam of a law that satisfies the limits, near a given circle. The offset of this circle is also tried: the best offset for the pressure
/// angle may not be the best offset for the curvature, and a smaller prime radius may have a larger diameter.
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

/// The law, shifted so that its minimum is on the base circle unless the drive or a condition determines the level.
fn on_base_circle(problem: &Problem, law: &Law) -> Law {
    if problem.level_is_known() {
        return law.clone();
    }
    law.raised(-law.extremes(0).0.value)
}
