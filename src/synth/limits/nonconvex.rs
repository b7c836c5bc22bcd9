//! Limits that are not convex in the law, as h(s, v, a, j, D, e) ≥ 0 with its derivatives: a roller's
//! curvature, and curvature and pressure angle of followers on an arm (theory §6), beside the loads.

use super::loads::Loads;
use super::{curvature, pressure_angle};
use crate::cam::{Criterion, LimitKind};
use crate::law::{Law, Svaj};
use crate::poly::{PiecewisePoly, stand_in_for_difference};

/// All of a scene's limits that are not convex in the law.
#[derive(Debug, Clone, Copy)]
pub struct NonconvexLimits {
    /// Those of the profile.
    pub profile: Option<Profile>,
    /// Those of shaft and contact.
    pub loads: Option<Loads>,
}

impl NonconvexLimits {
    /// Every limit at a place of the law; h ≥ 0 where it holds.
    pub fn slacks(&self, at: Svaj) -> Vec<Slack> {
        let mut out = self.profile.map_or_else(Vec::new, |f| f.slacks(at));
        if let Some(loads) = &self.loads {
            loads.slacks(at, self.size(), &mut out);
        }
        out
    }

    /// The size where it may be among the variables.
    pub fn size(&self) -> ProfileSize {
        self.profile.map_or(ProfileSize::NONE, |f| f.size())
    }

    /// The names of all of them.
    pub fn names(&self) -> Vec<Criterion> {
        let mut out: Vec<Criterion> = Vec::new();
        for slack in self.slacks(Svaj::default()) {
            if !out.contains(&slack.name) {
                out.push(slack.name);
            }
        }
        out
    }

    /// Those of them that `kept` names.
    pub fn only(&self, kept: impl Fn(Criterion) -> bool) -> Self {
        let left_out = |loads: Loads| {
            let named = loads.named().into_iter();
            named
                .filter(|l| !kept(l.0.into()))
                .fold(loads, |loads, (name, _)| loads.with(name, None))
        };
        NonconvexLimits {
            profile: self.profile.and_then(|p| p.only(&kept)),
            loads: self.loads.map(left_out),
        }
    }

    /// The same limits at another size.
    pub fn at_size(&self, size: ProfileSize) -> Self {
        NonconvexLimits {
            profile: self.profile.map(|f| f.at_size(size)),
            ..*self
        }
    }
}

/// A profile whose limits are not convex in the law, with all that fixes them.
#[derive(Debug, Clone, Copy)]
pub enum Profile {
    /// A roller that slides along +y.
    Roller(ProfileSize),
    /// A roller on an arm: pivot at distance c, arm A.
    Arm {
        /// c.
        pivot: f64,
        /// A.
        arm: f64,
        /// Radius of the prime circle.
        prime: f64,
        /// Smallest pitch radius allowed.
        rho: f64,
        /// Tangents of the pressure angles allowed on the rise and on the fall.
        tan: [Option<f64>; 2],
    },
    /// A flat face that swings about a pivot at distance c.
    Face {
        /// c.
        pivot: f64,
        /// Distance of the face from the pivot.
        offset: f64,
        /// Radius of the base circle.
        base: f64,
        /// Smallest convex radius allowed.
        rho: f64,
    },
}

/// What fixes the size of a cam, and the smallest radius allowed on it.
#[derive(Debug, Clone, Copy)]
pub struct ProfileSize {
    /// D of a roller that slides.
    pub rise: f64,
    /// e of the same.
    pub offset: f64,
    /// Radius of the prime circle under a follower that swings.
    pub radius: f64,
    /// Smallest radius allowed; under a roller that of the pitch curve: the cam's plus the roller's.
    pub rho: f64,
}

impl ProfileSize {
    /// Of a cam whose size is no part of the limits.
    pub const NONE: ProfileSize = ProfileSize {
        rise: 0.0,
        offset: 0.0,
        radius: 0.0,
        rho: 0.0,
    };

    /// Radius of the prime circle.
    pub fn prime_radius(&self) -> f64 {
        self.rise.hypot(self.offset) + self.radius
    }
}

/// h and its derivatives by s, v, a, j, D, e, Rp.
pub struct Slack {
    /// Name of the limit.
    pub name: Criterion,
    pub h: f64,
    /// ProfileSize of which h is a part: what the clearance is counted in.
    pub w: f64,
    /// Largest term in h.
    pub largest: f64,
    pub by_lift: f64,
    pub by_velocity: f64,
    pub by_acceleration: f64,
    pub by_jerk: f64,
    pub by_rise: f64,
    pub by_offset: f64,
    pub by_radius: f64,
}

impl Slack {
    /// A limit that nothing enters, to be filled in.
    pub fn none(name: impl Into<Criterion>) -> Self {
        Slack {
            name: name.into(),
            h: 0.0,
            w: 1.0,
            largest: 1.0,
            by_lift: 0.0,
            by_velocity: 0.0,
            by_acceleration: 0.0,
            by_jerk: 0.0,
            by_rise: 0.0,
            by_offset: 0.0,
            by_radius: 0.0,
        }
    }
}

impl Profile {
    /// Every limit at a place of the law; h ≥ 0 where it holds.
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
                for (tan, side) in tan.into_iter().zip([1.0, -1.0]) {
                    out.extend(
                        tan.map(|t| pressure_angle::arm_slack(at, pivot, arm, rest, t, side)),
                    );
                }
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

    /// The size where it may be among the variables.
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
                ..ProfileSize::NONE
            },
        }
    }

    /// The limits that `kept` names; `None` where that is none.
    fn only(mut self, kept: impl Fn(Criterion) -> bool) -> Option<Self> {
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
                    *rho = curvature::SHARP * *prime;
                }
                (curved || tan.iter().any(Option::is_some)).then_some(self)
            }
        }
    }

    /// The same follower at another size.
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

/// ξ of an arm on the prime circle, rad, and its derivative by the circle's radius: Rp² = A² + c² − 2Ac cos ξ.
fn arm_at_rest(pivot: f64, arm: f64, prime: f64) -> (f64, f64) {
    let cos = (arm * arm + pivot * pivot - prime * prime) / (2.0 * arm * pivot);
    let rest = cos.clamp(-1.0, 1.0).acos();
    (rest, prime / (arm * pivot * rest.sin()))
}

/// ξ of a face on the base circle, rad, and its derivative by the circle's radius: Rb = c sin ξ + offset.
fn face_at_rest(pivot: f64, offset: f64, base: f64) -> (f64, f64) {
    let rest = ((base - offset) / pivot).clamp(-1.0, 1.0).asin();
    (rest, 1.0 / (pivot * rest.cos()))
}

/// A follower that swings knows its size by ξ = rest + s alone.
fn with_size_at_rest(mut slacks: Vec<Slack>, by_radius: f64) -> Vec<Slack> {
    for slack in &mut slacks {
        slack.by_radius = slack.by_lift * by_radius;
    }
    slacks
}

/// h/w over the law, for each of the limits.
pub fn relative(law: &Law, limits: &NonconvexLimits) -> Vec<PiecewisePoly> {
    let breaks = law.breaks();
    let place = |i: usize, x: f64| law.svaj_on(i, (x - breaks[i]) / (breaks[i + 1] - breaks[i]));
    let first = limits.slacks(place(0, breaks[0]));
    (0..first.len())
        .map(|k| {
            let terms = (first[k].largest / first[k].w).abs();
            stand_in_for_difference(breaks, 1e-11, terms, |i, x| {
                let s = &limits.slacks(place(i, x))[k];
                s.h / s.w
            })
        })
        .collect()
}

/// Smallest h/w over the law, for each of the limits.
pub fn clearances(law: &Law, limits: &NonconvexLimits) -> Vec<f64> {
    let curves = relative(law, limits);
    curves.iter().map(|c| c.extremes().0.value).collect()
}

/// The same of the loads alone; ∞ where there are none.
pub fn loaded(law: &Law, limits: &NonconvexLimits) -> f64 {
    let names: Vec<Criterion> = limits
        .loads
        .iter()
        .flat_map(|l| l.named())
        .map(|n| n.0.into())
        .collect();
    let first = limits.slacks(law.svaj_on(0, 0.0));
    relative(law, limits)
        .iter()
        .zip(first)
        .filter(|(_, slack)| names.contains(&slack.name))
        .fold(f64::INFINITY, |m, (curve, _)| {
            m.min(curve.extremes().0.value)
        })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cam::{Cam, Follower as Kind};
    use crate::law::{Extent, Rise, Segment, program};

    fn law(lift: f64) -> Law {
        let segment = |lift: f64, angle: f64| Segment {
            motion: Rise::Cycloidal,
            lift,
            angle,
        };
        let pi = std::f64::consts::PI;
        program(&[segment(lift, pi), segment(-lift, pi)], Extent::TURN).unwrap()
    }

    /// Smallest h/w over the law.
    fn clearance(law: &Law, limits: &NonconvexLimits) -> f64 {
        let all = clearances(law, limits).into_iter();
        all.fold(f64::INFINITY, f64::min)
    }

    /// Central differences of h against the derivatives stated, at places of many kinds.
    #[test]
    fn derivatives_of_every_limit_agree_with_differences() {
        let followers = [
            Profile::Roller(ProfileSize {
                rise: 0.04,
                offset: 0.007,
                radius: 0.0,
                rho: 0.02,
            }),
            Profile::Arm {
                pivot: 0.1,
                arm: 0.08,
                prime: 0.057,
                rho: 0.02,
                tan: [Some(0.6), Some(0.7)],
            },
            Profile::Face {
                pivot: 0.1,
                offset: 0.01,
                base: 0.058,
                rho: 0.005,
            },
        ];
        for follower in followers {
            let unit = if matches!(follower, Profile::Roller(_)) {
                0.01
            } else {
                0.1
            };
            for i in 0..20 {
                let x = f64::from(i);
                let at = Svaj {
                    s: unit * (1.0 + (1.3 * x).sin()),
                    v: unit * (0.7 * x).cos(),
                    a: unit * (0.3 * x + 1.0).sin(),
                    j: 0.0,
                };
                for k in 0..follower.slacks(at).len() {
                    let h = |at: Svaj| follower.slacks(at)[k].h;
                    let d = 1e-6 * unit;
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
            }
        }
    }

    fn alone(profile: Profile) -> NonconvexLimits {
        NonconvexLimits {
            profile: Some(profile),
            loads: None,
        }
    }

    /// h is zero exactly where the finished cam has the radius or the pressure angle asked for.
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
            tan[k] = Some(angle.tan());
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
