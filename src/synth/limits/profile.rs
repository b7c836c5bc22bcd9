//! Nonconvex limits of the profile: curvature for a roller, and curvature and pressure angle of followers on an arm (theory §6).

use super::curvature;
use super::pressure_angle::{self, NEARLY_RIGHT};
use super::slack::{ProfileSize, Slack};
use crate::cam::{Criterion, FollowerKind, LimitKind};
use crate::law::Svaj;
use crate::problem::{Problem, Size};

/// Radius of curvature that replaces zero for a sharp edge, relative to the prime radius. With it, divisions by the radius remain finite.
pub const SHARP: f64 = 1e-6;

/// Dimensions of a follower whose profile has nonconvex limits, m.
#[derive(Debug, Clone, Copy)]
pub enum Profile {
    /// Roller, arc or sharp edge that translates along +y.
    Roller(ProfileSize),
    /// Roller on an arm of length A, with the pivot at distance c from the cam centre.
    Arm {
        /// Distance c of the pivot from the cam centre.
        pivot: f64,
        /// Length A of the arm.
        arm: f64,
        /// Radius of the prime circle.
        prime: f64,
        /// Minimum permitted radius of curvature of the pitch curve.
        rho: f64,
        /// Tangents of the permitted pressure angles on rise and fall.
        tan: [Option<f64>; 2],
    },
    /// Flat face that oscillates about a pivot at distance c.
    Face {
        /// Distance c of the pivot from the cam centre.
        pivot: f64,
        /// Distance of the face from the pivot.
        offset: f64,
        /// Radius of the base circle.
        base: f64,
        /// Minimum permitted convex radius of curvature.
        rho: f64,
    },
}

impl Profile {
    /// Follower with the nonconvex limits of its profile. `None` if there are no such limits, or if the size is computed after the law.
    pub fn of(problem: &Problem) -> Option<Profile> {
        let (cam, limits) = (&problem.cam, &problem.limits);
        let rho = limits[LimitKind::Curvature].unwrap_or(0.0);
        let pitch = rho + cam.roller_radius;
        match cam.follower {
            FollowerKind::RollerTranslating
            | FollowerKind::KnifeTranslating
            | FollowerKind::MushroomTranslating => {
                let offset = cam.offset.unwrap_or(0.0);
                let rise = match problem.size() {
                    Size::Given { prime, .. } => (prime * prime - offset * offset).max(0.0).sqrt(),
                    Size::Sought => 0.0,
                    Size::AfterLaw => return None,
                };
                (pitch > 0.0).then_some(Profile::Roller(ProfileSize {
                    rise,
                    offset,
                    radius: 0.0,
                    rho: pitch,
                }))
            }
            FollowerKind::RollerOscillating | FollowerKind::KnifeOscillating => {
                let (pivot, arm) = (cam.pivot_distance?, cam.arm?);
                let asked = limits.pressure_angles();
                let (prime, angles) = match problem.size() {
                    Size::Given { prime, .. } => (prime, asked),
                    Size::Sought => (
                        problem.reach_of_arm()?[1],
                        problem.sizing_pressure_angles().map(Some),
                    ),
                    Size::AfterLaw => return None,
                };
                Some(Profile::Arm {
                    pivot,
                    arm,
                    prime,
                    rho: pitch.max(SHARP * prime),
                    tan: angles.map(|angle| angle.map(|a| libm::tan(a.min(NEARLY_RIGHT)))),
                })
            }
            FollowerKind::FlatOscillating => {
                let base = match problem.size() {
                    Size::Given { base, .. } => base,
                    Size::Sought => problem.reach_of_arm()?[1],
                    Size::AfterLaw => return None,
                };
                Some(Profile::Face {
                    pivot: cam.pivot_distance?,
                    offset: cam.face_offset,
                    base,
                    rho,
                })
            }
            FollowerKind::FlatTranslating
            | FollowerKind::MushroomOscillating
            | FollowerKind::TranslatingCam
            | FollowerKind::Barrel => None,
        }
    }

    /// Clearances h of all limits at a point of the law. A limit is satisfied if h ≥ 0.
    pub fn slacks(&self, at: Svaj) -> Vec<Slack> {
        match *self {
            Profile::Roller(size) => vec![curvature::roller_slack(at, size)],
            Profile::Arm {
                pivot,
                arm,
                prime,
                rho,
                tan,
            } => {
                let (rest, by_radius) = arm_at_rest(pivot, arm, prime);
                let mut out = vec![curvature::arm_slack(at, pivot, arm, rest, rho)];
                let rows = pressure_angle::angle_rows(tan).into_iter();
                out.extend(rows.map(|row| pressure_angle::arm_slack(at, pivot, arm, rest, row)));
                with_size_at_rest(out, by_radius)
            }
            Profile::Face {
                pivot,
                offset,
                base,
                rho,
            } => {
                let (rest, by_radius) = face_at_rest(pivot, offset, base);
                let out = vec![curvature::face_slack(at, pivot, offset, rest, rho)];
                with_size_at_rest(out, by_radius)
            }
        }
    }

    /// Size of the cam for which the limits are evaluated. It may be a variable of the program.
    pub fn size(&self) -> ProfileSize {
        match *self {
            Profile::Roller(size) => size,
            Profile::Arm {
                prime: radius, rho, ..
            }
            | Profile::Face {
                base: radius, rho, ..
            } => ProfileSize {
                radius,
                rho,
                ..ProfileSize::default()
            },
        }
    }

    /// The limits whose names `kept` selects; `None` if it selects none.
    pub fn only(mut self, kept: impl Fn(Criterion) -> bool) -> Option<Self> {
        let curved = kept(LimitKind::Curvature.into());
        match &mut self {
            Profile::Roller(_) | Profile::Face { .. } => curved.then_some(self),
            Profile::Arm {
                prime, rho, tan, ..
            } => {
                for (tan, side) in tan.iter_mut().zip(pressure_angle::SIDES) {
                    *tan = tan.filter(|_| kept(side.into()));
                }
                if !curved {
                    *rho = SHARP * *prime;
                }
                (curved || tan.iter().any(Option::is_some)).then_some(self)
            }
        }
    }

    /// The limits for a cam of another size.
    pub fn at_size(mut self, size: ProfileSize) -> Self {
        match &mut self {
            Profile::Roller(own) => {
                *own = ProfileSize {
                    radius: 0.0,
                    ..size
                }
            }
            Profile::Arm { prime: radius, .. } | Profile::Face { base: radius, .. } => {
                *radius = size.radius;
            }
        }
        self
    }
}

/// Arm angle ξ on the prime circle, rad, and the derivative dξ/dRp, rad/m, from Rp² = A² + c² − 2Ac cos ξ.
pub(super) fn arm_at_rest(pivot: f64, arm: f64, prime: f64) -> (f64, f64) {
    let cos = (arm * arm + pivot * pivot - prime * prime) / (2.0 * arm * pivot);
    let rest = libm::acos(cos.clamp(-1.0, 1.0));
    (rest, prime / (arm * pivot * libm::sin(rest)))
}

/// Face angle ξ on the base circle, rad, and the derivative dξ/dRb, rad/m, from Rb = c sin ξ + offset.
pub(super) fn face_at_rest(pivot: f64, offset: f64, base: f64) -> (f64, f64) {
    let rest = libm::asin(((base - offset) / pivot).clamp(-1.0, 1.0));
    (rest, 1.0 / (pivot * libm::cos(rest)))
}

/// Sets the derivatives with respect to the radius of the prime or base circle. For an oscillating follower, the radius changes only the angle
/// at rest, and ξ = rest + s. `by_radius` is the derivative of the angle at rest.
fn with_size_at_rest(mut slacks: Vec<Slack>, by_radius: f64) -> Vec<Slack> {
    for slack in &mut slacks {
        slack.by_radius = slack.by_lift * by_radius;
    }
    slacks
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cam::{Cam, Follower as Kind};
    use crate::law::{Extent, Law, Rise, Segment, program};
    use crate::synth::limits::nonconvex::{NonconvexLimits, clearances};

    fn law(lift: f64) -> Law {
        let segment = |lift: f64, angle: f64| Segment {
            motion: Rise::Cycloidal,
            lift,
            angle,
        };
        let pi = std::f64::consts::PI;
        program(&[segment(lift, pi), segment(-lift, pi)], Extent::TURN).unwrap()
    }

    /// Minimum of the clearance h/w over the law and over all limits.
    fn clearance(law: &Law, limits: &NonconvexLimits) -> f64 {
        let all = clearances(law, limits).into_iter();
        all.fold(f64::INFINITY, f64::min)
    }

    /// Compares the derivatives of h with central differences, for many points and followers.
    #[test]
    fn derivatives_of_every_limit_agree_with_differences() {
        let roller = Profile::Roller(ProfileSize {
            rise: 0.04,
            offset: 0.007,
            radius: 0.0,
            rho: 0.02,
        });
        let arm = Profile::Arm {
            pivot: 0.1,
            arm: 0.08,
            prime: 0.057,
            rho: 0.02,
            tan: [Some(0.6), Some(0.7)],
        };
        let face = Profile::Face {
            pivot: 0.1,
            offset: 0.01,
            base: 0.058,
            rho: 0.005,
        };
        for (follower, unit) in [(roller, 0.01), (arm, 0.1), (face, 0.1)] {
            for x in (0..20).map(f64::from) {
                let at = Svaj {
                    s: unit * (1.0 + (1.3 * x).sin()),
                    v: unit * (0.7 * x).cos(),
                    a: unit * (0.3 * x + 1.0).sin(),
                    j: 0.0,
                };
                for k in 0..follower.slacks(at).len() {
                    agrees_with_differences(&follower, at, k, 1e-6 * unit);
                }
            }
        }
    }

    /// Asserts the derivatives of limit `k` with respect to lift, velocity, acceleration and radius, by differences with steps `d`.
    fn agrees_with_differences(follower: &Profile, at: Svaj, k: usize, d: f64) {
        let h = |at: Svaj| follower.slacks(at)[k].h;
        let by = |plus: Svaj, minus: Svaj| (h(plus) - h(minus)) / (2.0 * d);
        let found = [
            by(Svaj { s: at.s + d, ..at }, Svaj { s: at.s - d, ..at }),
            by(Svaj { v: at.v + d, ..at }, Svaj { v: at.v - d, ..at }),
            by(Svaj { a: at.a + d, ..at }, Svaj { a: at.a - d, ..at }),
        ];
        let own = &follower.slacks(at)[k];
        let stated = [own.by_lift, own.by_velocity, own.by_acceleration];
        let at_radius = |more: f64| {
            let size = follower.size();
            let radius = size.radius + more;
            let other = follower.at_size(ProfileSize { radius, ..size });
            other.slacks(at)[k].h
        };
        let by_radius = (at_radius(d) - at_radius(-d)) / (2.0 * d);
        let tolerance = 1e-6 * own.by_radius.abs().max(own.by_lift.abs());
        assert!(
            (by_radius - own.by_radius).abs() <= tolerance,
            "{follower:?} {k}: {by_radius} {}",
            own.by_radius
        );
        let size = stated.iter().fold(0.0_f64, |m, s| m.max(s.abs()));
        for (f, s) in found.iter().zip(stated) {
            assert!(
                (f - s).abs() < 1e-6 * size,
                "{follower:?} {k}: {found:?} {stated:?}"
            );
        }
    }

    fn alone(profile: Profile) -> NonconvexLimits {
        NonconvexLimits {
            diameter: None,
            profile: Some(profile),
            loads: None,
        }
    }

    /// h is zero if and only if the finished cam has the permitted radius of curvature or pressure angle.
    #[test]
    fn limits_of_arms_are_those_of_the_cam() {
        let law = law(0.3);
        let (pivot, arm, prime, roller) = (0.1, 0.08, 0.05, 0.01);
        let cam = Cam {
            law: law.clone(),
            follower: Kind::RollerOscillating {
                pivot_distance: pivot,
                arm,
                prime_radius: prime,
                roller_radius: roller,
            },
        };
        let (fall, rise) = cam.pressure_angle_extremes();
        let arms = |rho: f64, tan: [Option<f64>; 2]| Profile::Arm {
            pivot,
            arm,
            prime,
            rho,
            tan,
        };
        let sharpest = cam.curvature().convex.value + roller;
        let exact = clearance(&law, &alone(arms(sharpest, [None, None])));
        assert!(exact.abs() < 1e-7, "{exact}");
        for (k, angle) in [(0, rise.value), (1, -fall.value)] {
            let mut tan = [None, None];
            tan[k] = Some(libm::tan(angle));
            let exact = clearance(&law, &alone(arms(1e-4, tan)));
            assert!(exact.abs() < 1e-7, "{k}: {exact}");
        }
        let (base, offset) = (0.05, 0.004);
        let cam = Cam {
            law: law.clone(),
            follower: Kind::FlatOscillating {
                pivot_distance: pivot,
                face_offset: offset,
                base_radius: base,
            },
        };
        let face = Profile::Face {
            pivot,
            offset,
            base,
            rho: cam.curvature().convex.value,
        };
        let exact = clearance(&law, &alone(face));
        assert!(exact.abs() < 1e-7, "{exact}");
    }
}
