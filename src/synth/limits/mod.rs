//! Limits of a problem, one file per limit or group.
//!
//! Each file contains the rows of its limit in a convex program, the nonconvex part of the limit, and the check of the finished design. The
//! size of the cam is either given or a variable of the program.

mod curvature;
mod diameter;
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

pub use diameter::{check as diameter_check, is_nonconvex as diameter_is_nonconvex};
pub use dwell_vibration::Vibrations;
pub use finished::{Finished, GEOMETRY};
pub use hertz_pressure::{bearable_on_some_size, smallest_base_radius};
pub use kinematic::above_base_circle;
pub use loads::{largest, power_curve, torque_curve};
pub use nonconvex::{ENLARGED, NonconvexLimits, clearances, loaded, relative};
pub use press::Press;
pub use pressure_angle::{NEARLY_RIGHT, is_usual, usual_pressure_angle};
pub use profile::Profile;
pub use size::leave_room;
pub use slack::ProfileSize;

use super::qp::{Basis, Limit, MeanSquare, Program};
use super::search::Search;
use crate::cam::{BarrelGroove, Cam, Check, Criterion, Follower, LimitKind, Wall};
use crate::criterion::DependsOn;
use crate::poly::PiecewisePoly;
use crate::problem::{OnShaft, Problem, Size};
use crate::scene::Minimise;

/// Adds the convex limits of a problem to a program. These are the limits over the whole turn, the limits on root mean squares, and the limits
/// on a size that is a variable. A law of harmonics has no conditions, and its only objective is the force error.
///
/// If no condition fixes the level of the lift, the law touches the base circle at the touching angle. Limits on the profile then use the
/// lift minus its value at this angle. A varying shaft speed or a moving floor adds a function of the angle to a limited quantity. The
/// bound is reduced by this function. `force_error` computes half the mean square of the force error.
pub fn constrain(
    problem: &Problem,
    search: &Search,
    program: &mut Program,
    force_error: impl FnOnce(&Problem, &Basis) -> MeanSquare,
) {
    let is_spline = matches!(program.basis, Basis::Spline { .. });
    let is_sized = problem.size() == Size::Sought
        && (is_spline || problem.objective() == Minimise::ForceError);
    let base_circle = kinematic::base_circle(problem).filter(|_| !search.below_base_circle);
    let mut rows: Vec<Limit> = base_circle.into_iter().collect();
    rows.extend(kinematic::stroke(problem));
    rows.extend(diameter::row(problem, is_sized));
    rows.extend(kinematic::face_width(problem));
    rows.extend(kinematic::timed(problem));
    if is_spline {
        rows.extend(kinematic::monotone(problem));
        rows.extend(kinematic::peak(problem, program));
    }
    rows.extend(force::rows(problem));
    let of_law_alone = rows.len();
    rows.extend(curvature::row(problem, is_sized));
    rows.extend(pressure_angle::rows(problem, is_sized));
    rows.extend(hertz_pressure::row(problem, is_sized));
    for limit in &mut rows[of_law_alone..] {
        limit.from_reference = !problem.level_is_known() && limit.weights[0] != 0.0;
    }
    if let Some(shaft) = &problem.on_shaft {
        for limit in &mut rows {
            shift(shaft, problem.drive.speed, program, limit);
        }
    }
    if is_spline {
        rows.extend(force::about_the_target(problem, program));
    }
    let accuracy = force::accuracy(problem, || force_error(problem, &program.basis));
    let power = power_mean::root_mean_square(problem, &program.basis);
    program.rms = accuracy.into_iter().chain(power).collect();
    if is_sized {
        rows.extend(size::priced(problem, program));
    }
    program.limits = rows;
}

/// Reduces the bound of a limit by the term that a varying speed or a floor adds to the limited quantity. The term is a function of the
/// angle. It is stored in the program.
fn shift(shaft: &OnShaft, speed: f64, program: &mut Program, limit: &mut Limit) {
    let per_time = speed.powi(limit.highest_order() as i32);
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

impl Finished<'_> {
    /// Checks of all limits of the problem, and of the requirements that apply to every cam. The second cam of a pair and the groove of a
    /// barrel are included.
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
        out.extend(diameter::check(problem, cam, LimitKind::Diameter));
        out.extend(curvature::interference(cam));
        out.extend(kinematic::base_circle_check(cam));
        out
    }
}

/// Checks of the second cam of a conjugate pair.
fn second_cam(problem: &Problem, second: Option<&Cam>) -> Vec<Check> {
    let Some(cam) = second else { return Vec::new() };
    let mut out = pressure_angle::checks(problem, cam.pressure_angles_by_motion());
    out.extend(curvature::checks(problem, cam));
    out.extend(curvature::interference(cam));
    out.extend(diameter::check(problem, cam, LimitKind::Diameter));
    for check in &mut out {
        check.name = check.name.of_second_cam();
    }
    out
}

/// Checks of pressure angle and convex walls of the groove of a barrel. The checks apply to the floor of the groove, where pressure angle
/// and curvature are largest.
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
