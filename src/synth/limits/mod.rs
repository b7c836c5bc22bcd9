//! The limits of a problem, one file per limit or natural group.
//!
//! Each file answers the same questions, so that row and check of a limit stand side by side: which rows it
//! is in a convex program (on a given size, or with the size among the variables), what of it is not convex,
//! and how it is checked on the finished design.

mod curvature;
mod dwell_vibration;
mod finished;
mod force;
mod hertz_pressure;
mod kinematic;
mod loads;
#[cfg(test)]
mod loads_tests;
mod nonconvex;
mod power_mean;
mod press;
mod pressure_angle;
mod profile;
mod size;
mod slack;

pub use dwell_vibration::Vibrations;
pub use finished::{Finished, GEOMETRY};
pub use force::{about_the_target, report as force_report};
pub use hertz_pressure::{bearable_on_some_size, smallest_base_radius};
pub use kinematic::{above_base_circle, monotone, peak};
pub use loads::{largest, power_curve, torque_curve};
pub use nonconvex::{ENLARGED, NonconvexLimits, clearances, loaded, relative};
pub use press::Press;
pub use pressure_angle::{NEARLY_RIGHT, is_usual, usual_pressure_angle};
pub use profile::Profile;
pub use slack::ProfileSize;

use super::qp::{Basis, Limit, MeanSquare, Program, RmsLimit};
use crate::cam::{BarrelGroove, Cam, Check, Criterion, Follower, FollowerKind, LimitKind, Wall};
use crate::criterion::DependsOn;
use crate::poly::PiecewisePoly;
use crate::problem::Problem;

/// Limits over the whole turn that are linear in the law.
///
/// Where nothing fixes the level of the law, limits on the distance to the base circle count from the angle at
/// which the law touches it.
pub fn rows(problem: &Problem) -> Vec<Limit> {
    let mut out = kinematic::base_circle(problem);
    out.extend(kinematic::stroke(problem));
    out.extend(size::face_width(problem));
    if problem.on_shaft.is_none() {
        out.extend(kinematic::timed(problem));
        out.extend(force::rows(problem));
    }
    let of_law_alone = out.len();
    out.extend(curvature::row(problem));
    out.extend(pressure_angle::rows(problem));
    if problem.on_shaft.is_none() {
        out.extend(hertz_pressure::row(problem));
    }
    count_from_base_circle(problem, &mut out[of_law_alone..]);
    out
}

/// Limits on root mean squares over the turn; `force_error` gives half the mean square of the force error.
pub fn root_mean_squares(
    problem: &Problem,
    basis: &Basis,
    force_error: impl FnOnce(&Problem, &Basis) -> MeanSquare,
) -> Vec<RmsLimit> {
    let accuracy = force::accuracy(problem, || force_error(problem, basis));
    let power = power_mean::root_mean_square(problem, basis);
    accuracy.into_iter().chain(power).collect()
}

/// The lift in limits on the profile is a distance from the base circle.
fn count_from_base_circle(problem: &Problem, limits: &mut [Limit]) {
    for limit in limits {
        limit.from_reference = !problem.level_is_known() && limit.weights[0] != 0.0;
    }
}

/// Limits by time, on the force and on its pressure where the speed of the shaft varies or the floor moves: their bounds are
/// less by what that adds; these shapes join the program.
pub fn rows_on_shaft(problem: &Problem, program: &mut Program) -> Vec<Limit> {
    if problem.on_shaft.is_none() {
        return Vec::new();
    }
    let mut out = force::rows(problem);
    out.extend(kinematic::timed(problem));
    let of_law_alone = out.len();
    out.extend(hertz_pressure::row(problem));
    count_from_base_circle(problem, &mut out[of_law_alone..]);
    for limit in &mut out {
        shift(problem, program, limit);
    }
    out
}

/// Lowers the bound of a limit by what a varying speed or a floor adds to its quantity.
fn shift(problem: &Problem, program: &mut Program, limit: &mut Limit) {
    let Some(shaft) = &problem.on_shaft else {
        return;
    };
    let per_time = problem.drive.speed.powi(limit.highest_order() as i32);
    let timed = |order: usize| {
        let extra = shaft.extra.timed[order - 1].as_ref()?;
        Some((extra, -limit.weights[order] / per_time))
    };
    let Some(kind) = limit.name.limit() else {
        return;
    };
    let facts = kind.facts();
    let added = match facts.depends_on {
        DependsOn::Motion(order) => timed(order),
        DependsOn::Force | DependsOn::Load => Some((&shaft.extra.force, -facts.direction.sign())),
        DependsOn::Cam | DependsOn::Vibration => None,
    };
    if let Some((extra, factor)) = added {
        let shape = PiecewisePoly::combine(&[(factor, extra)], 0.0);
        program.shapes.push(shape);
        limit.shape = Some(program.shapes.len() - 1);
    }
}

/// Limits of the profile with the cam's size among the variables, and what the size costs (theory §6).
/// The radius is what is minimised, or it stays below its limit while something else is.
pub fn with_size(problem: &Problem, program: &mut Program) {
    let follower = problem.cam.follower;
    let mut sized = Vec::new();
    if follower == FollowerKind::FlatTranslating {
        sized.push(curvature::row_with_size(problem));
        let mut pressed = hertz_pressure::row_with_size(problem);
        pressed
            .iter_mut()
            .for_each(|limit| shift(problem, program, limit));
        sized.extend(pressed);
    } else if !follower.is_oscillating() {
        sized.extend(pressure_angle::rows_with_size(problem));
    }
    count_from_base_circle(problem, &mut sized);
    program.limits.extend(sized);
    size::priced(problem, program);
}

impl Finished<'_> {
    /// Every limit of the problem, and what no cam may lack, on the cam, its second cam and its groove.
    pub fn checks(&self) -> Vec<Check> {
        let mut out = kinematic::checks(self.problem, self.cam);
        out.extend(force::checks(self));
        out.extend(self.profile_checks());
        out.extend(force::accuracy_check(self));
        out.extend(loads::checks(self));
        out.extend(power_mean::check(self));
        out.extend(dwell_vibration::check(self));
        out.extend(second_cam(self.problem, self.second));
        out.extend(groove(self.problem, self.groove));
        out
    }

    fn profile_checks(&self) -> Vec<Check> {
        let (problem, cam) = (self.problem, self.cam);
        let mut out = Vec::new();
        if !matches!(cam.follower, Follower::Barrel { .. }) {
            out.extend(pressure_angle::checks(
                problem,
                cam.pressure_angles_by_motion(),
            ));
        }
        out.extend(curvature::checks(problem, cam));
        out.extend(size::checks(problem, cam));
        out.extend(curvature::interference(cam));
        out.extend(kinematic::base_circle_check(cam));
        out
    }
}

/// What the second cam of a conjugate pair must keep.
fn second_cam(problem: &Problem, second: Option<&Cam>) -> Vec<Check> {
    let Some(cam) = second else { return Vec::new() };
    let mut out = pressure_angle::checks(problem, cam.pressure_angles_by_motion());
    out.extend(curvature::checks(problem, cam));
    out.extend(curvature::interference(cam));
    for check in &mut out {
        check.name = check.name.of_second_cam();
    }
    out
}

/// Pressure angle and convex walls at the floor of a barrel's groove, where both are worst.
fn groove(problem: &Problem, groove: Option<&BarrelGroove>) -> Vec<Check> {
    let Some(groove) = groove else {
        return Vec::new();
    };
    let floor = groove.depth().0;
    let mut out = pressure_angle::checks(problem, groove.pressure_angles_by_motion(floor));
    let wanted = problem.limits[LimitKind::Curvature].unwrap_or(0.0);
    for (name, wall) in [
        (Criterion::UpperWall, Wall::Upper),
        (Criterion::LowerWall, Wall::Lower),
    ] {
        let radius = groove.smallest_bulge(floor, wall);
        out.push(Check::of(name, radius, wanted, GEOMETRY));
    }
    out
}
