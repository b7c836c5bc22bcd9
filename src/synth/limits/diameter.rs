//! Limit on the diameter of the finished cam: twice the maximum radius of the profile about the centre of the shaft.
//!
//! Where the profile is farthest from the centre, its normal is radial, so the radius depends only on lift and size ([`Cam::radii`]). If the
//! size is given, or if the radius is the sum of lift and size, the limit is a row of the convex program. The prime radius of a follower on
//! an arm and a free offset enter the limit nonlinearly. In these cases the limit is treated as a nonconvex limit.

use super::finished::GEOMETRY;
use super::profile::{arm_at_rest, face_at_rest};
use super::slack::{ProfileSize, Slack};
use crate::cam::{Cam, Check, Criterion, FollowerKind, LimitKind};
use crate::law::Svaj;
use crate::problem::{Problem, Size};
use crate::synth::qp::{Limit, Meaning, RADIUS, RISE, Variable, only, structural};

/// Nonconvex limit on the diameter. The fields are the dimensions that determine the distance of the follower from the cam centre, m and rad.
#[derive(Debug, Clone, Copy)]
pub enum Diameter {
    /// A follower that translates along a line with a free offset.
    Line {
        /// Maximum distance of the centre of roller or arc from the cam centre, m.
        reach: f64,
    },
    /// A roller or an arc on an arm.
    Arm {
        /// Distance of the pivot from the cam centre, m.
        pivot: f64,
        /// Length of the arm, m.
        arm: f64,
        /// Maximum angle of the arm, rad.
        widest: f64,
    },
    /// A flat face on an arm.
    Face {
        /// Distance of the pivot from the cam centre, m.
        pivot: f64,
        /// Distance of the face from the pivot, m.
        offset: f64,
        /// Maximum angle of the face, rad.
        widest: f64,
    },
}

/// Maximum distance from the cam centre, m, of the centre of roller or arc, or of a flat face. `None` without a limit on the diameter.
fn reach(problem: &Problem) -> Option<f64> {
    let diameter = problem.limits[LimitKind::Diameter]?;
    Some(0.5 * diameter + problem.cam.roller_radius)
}

/// The limit as a row of the convex program; `None` if the limit is absent or nonconvex.
pub fn row(problem: &Problem, is_sized: bool) -> Option<Limit> {
    let reach = reach(problem)?;
    let given = match problem.size() {
        Size::Given { prime, .. } => Some(prime),
        Size::Sought | Size::AfterLaw => None,
    };
    if !is_sized && given.is_none() {
        return None;
    }
    match problem.cam.follower {
        FollowerKind::FlatTranslating => Some(match given {
            Some(base) => affine(problem, reach - base, 2.0 * base),
            None => sized(problem, reach, RADIUS, 0.0),
        }),
        FollowerKind::RollerTranslating
        | FollowerKind::KnifeTranslating
        | FollowerKind::MushroomTranslating => {
            let offset = problem.offset().or(given.map(|_| 0.0))?;
            let most = (reach * reach - offset * offset).max(0.0).sqrt();
            let Some(prime) = given else {
                return Some(sized(problem, most, RISE, offset));
            };
            let rise = (prime * prime - offset * offset).max(0.0).sqrt();
            Some(match offset {
                0.0 => affine(
                    problem,
                    most - rise,
                    2.0 * (rise - problem.cam.roller_radius),
                ),
                _ => Meaning::Sized.of(lift(problem, most - rise)),
            })
        }
        FollowerKind::RollerOscillating
        | FollowerKind::KnifeOscillating
        | FollowerKind::MushroomOscillating
        | FollowerKind::FlatOscillating => {
            let at_rest = Diameter::of_arm(problem, reach)?.at_rest(given?).0;
            let widest = Diameter::of_arm(problem, reach)?.widest()?;
            Some(Meaning::Sized.of(lift(problem, widest - at_rest)))
        }
        FollowerKind::TranslatingCam | FollowerKind::Barrel => None,
    }
}

/// Limit s ≤ `bound` on the lift s, m or rad.
fn lift(problem: &Problem, bound: f64) -> Limit {
    structural(LimitKind::Diameter, only(0, 1.0), bound, problem.length())
}

/// Limit s ≤ `bound` on the lift, where the bound corresponds to the diameter 2·`bound` + `offset`, m.
fn affine(problem: &Problem, bound: f64, offset: f64) -> Limit {
    Meaning::Value {
        factor: 2.0,
        offset,
    }
    .of(lift(problem, bound))
}

/// Limit on the sum of the lift and a size variable, m: at most `bound`. The offset of the follower, m, relates this bound to the diameter.
fn sized(problem: &Problem, bound: f64, size: Variable, offset: f64) -> Limit {
    let radius = problem.cam.roller_radius;
    let meaning = Meaning::Diameter { offset, radius };
    let mut limit = meaning.of(lift(problem, bound));
    limit.extra[size] = 1.0;
    limit
}

impl Diameter {
    /// Nonconvex limit on the diameter of the cam of a problem; `None` if this limit is absent or linear.
    pub fn of(problem: &Problem) -> Option<Diameter> {
        let reach = reach(problem)?;
        if problem.size() != Size::Sought {
            return None;
        }
        match problem.cam.follower {
            FollowerKind::RollerTranslating
            | FollowerKind::KnifeTranslating
            | FollowerKind::MushroomTranslating => {
                let is_open = problem.offset().is_none();
                is_open.then_some(Diameter::Line { reach })
            }
            _ => Diameter::of_arm(problem, reach),
        }
    }

    /// Limit for a follower on an arm; `None` for other followers.
    fn of_arm(problem: &Problem, reach: f64) -> Option<Diameter> {
        let cam = &problem.cam;
        match cam.follower {
            FollowerKind::RollerOscillating
            | FollowerKind::KnifeOscillating
            | FollowerKind::MushroomOscillating => {
                let (pivot, arm) = (cam.pivot_distance?.abs(), cam.arm?);
                let widest = arm_at_rest(pivot, arm, reach).0;
                Some(Diameter::Arm { pivot, arm, widest })
            }
            FollowerKind::FlatOscillating => {
                let (pivot, offset) = (cam.pivot_distance?.abs(), cam.face_offset);
                let widest = face_at_rest(pivot, offset, reach).0;
                Some(Diameter::Face {
                    pivot,
                    offset,
                    widest,
                })
            }
            _ => None,
        }
    }

    /// Arm angle on the prime circle, rad, and the derivative of this angle with respect to the prime radius, rad/m.
    fn at_rest(&self, prime: f64) -> (f64, f64) {
        match *self {
            Diameter::Line { .. } => (0.0, 0.0),
            Diameter::Arm { pivot, arm, .. } => arm_at_rest(pivot, arm, prime),
            Diameter::Face { pivot, offset, .. } => face_at_rest(pivot, offset, prime),
        }
    }

    fn widest(&self) -> Option<f64> {
        match *self {
            Diameter::Line { .. } => None,
            Diameter::Arm { widest, .. } | Diameter::Face { widest, .. } => Some(widest),
        }
    }

    /// Clearance h of the limit at a point of the law. The limit is satisfied if h ≥ 0.
    pub fn slack(&self, at: Svaj, size: ProfileSize) -> Slack {
        let none = Slack::none(LimitKind::Diameter);
        match *self {
            Diameter::Line { reach } => {
                let (x, e) = (size.rise + at.s, size.offset);
                let distance = libm::hypot(x, e);
                Slack {
                    h: reach - distance,
                    w: reach,
                    largest: reach,
                    by_lift: -x / distance,
                    by_rise: -x / distance,
                    by_offset: -e / distance,
                    ..none
                }
            }
            Diameter::Arm { widest, .. } | Diameter::Face { widest, .. } => {
                let (rest, by_radius) = self.at_rest(size.radius);
                Slack {
                    h: widest - rest - at.s,
                    by_lift: -1.0,
                    by_radius: -by_radius,
                    ..none
                }
            }
        }
    }
}

/// Whether the diameter limit of a problem is nonconvex, so that it is not a row of the convex program.
pub fn is_nonconvex(problem: &Problem) -> bool {
    Diameter::of(problem).is_some()
}

/// Check of the diameter of a finished cam; `None` without a limit on the diameter.
pub fn check(problem: &Problem, cam: &Cam, name: impl Into<Criterion>) -> Option<Check> {
    let limit = problem.limits[LimitKind::Diameter]?;
    let [_, most] = cam.radii()?;
    Some(Check::of(
        name,
        most.map(|radius| 2.0 * radius),
        limit,
        GEOMETRY,
    ))
}
