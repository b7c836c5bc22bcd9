//! Checks of a cam against its limits, and the verdict on the cam.

use serde::Serialize;

use super::Criterion;
use crate::poly::Extreme;

/// Minimum radii of curvature of the finished profile.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::law::Law;
///
/// // An eccentric disc: constant radius, no concave flank.
/// let law = Law::harmonic(0.01, &[(0.0, 0.01)]);
/// let curvature = Cam::new(law, Follower::FlatTranslating { base_radius: 0.02 })?.curvature();
/// assert!((curvature.convex.value - 0.03).abs() < 1e-12);
/// assert!(curvature.concave.is_none() && !curvature.undercut);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Curvature {
    /// Minimum convex radius, m, signed: a negative value means undercut. Infinite if no part is convex.
    pub convex: Extreme,
    /// Minimum concave radius, m, which is negative; `None` if the profile has no concave part.
    pub concave: Option<Extreme>,
    /// Whether a part of the profile is undercut.
    pub undercut: bool,
}

/// Comparison of a value of the cam with its limit.
///
/// ```
/// use gaitcam::cam::Check;
/// use gaitcam::criterion::LimitKind;
/// use gaitcam::poly::Extreme;
///
/// let stroke = Extreme { at: 1.0, value: 0.05 };
/// assert!(Check::of(LimitKind::Stroke, stroke, 0.05, 0.0).pass);
/// assert!(!Check::of(LimitKind::Stroke, stroke, 0.049, 0.01).pass);
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Check {
    /// Criterion that is checked.
    pub name: Criterion,
    /// Worst value over the whole law, in SI units.
    pub worst: f64,
    /// Permitted value, in SI units.
    pub limit: f64,
    /// Cam angle of the worst value, rad.
    pub at: f64,
    /// Whether the value satisfies the limit.
    pub pass: bool,
}

impl Check {
    /// Compares a value with its limit; `slack` is the relative tolerance.
    pub fn of(name: impl Into<Criterion>, worst: Extreme, limit: f64, slack: f64) -> Self {
        let name = name.into();
        let direction = name.direction();
        let eased = limit + direction.sign() * slack * limit.abs();
        Check {
            name,
            worst: worst.value,
            limit,
            at: worst.at,
            pass: direction.keeps(worst.value, eased),
        }
    }

    /// Amount by which the worst value violates the limit, in SI units; negative if the limit is satisfied.
    pub fn excess(&self) -> f64 {
        self.name.direction().excess(self.worst, self.limit)
    }
}

/// Verdict on a cam, with the classes of CAM-DAS (Serrano Muñoz 2010).
///
/// ```
/// use gaitcam::cam::Verdict;
///
/// assert!(Verdict::Acceptable < Verdict::NotForHighSpeed);
/// assert_eq!(Verdict::NotForHighSpeed.name(), "not-for-high-speed");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, strum::IntoStaticStr)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
pub enum Verdict {
    /// Every check passes and the acceleration is continuous.
    Acceptable,
    /// Every check passes, but the acceleration has a jump. The cam is only suitable for slow machines.
    NotForHighSpeed,
    /// A check fails, or the lift or the velocity has a jump. A design is also unacceptable if its scene is infeasible or has an open
    /// question, if its mean force differs from the weight, or if the search was stopped.
    Unacceptable,
}

impl Verdict {
    /// Name of the verdict in `summary.json`.
    pub fn name(self) -> &'static str {
        self.into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cam::LimitKind;

    #[test]
    fn a_check_gives_way_by_its_slack_and_no_more() {
        for (limit, slack) in [(0.05_f64, 8e-10), (-3.0, 1e-8), (250.0, 0.0), (0.0, 1e-8)] {
            let room = slack * limit.abs();
            let over = (limit + 1.1 * room).max(limit.next_up());
            for (value, passes) in [(limit + 0.9 * room, true), (over, false), (-1e9, true)] {
                let check = Check::of(LimitKind::Stroke, Extreme { at: 1.0, value }, limit, slack);
                assert_eq!(
                    (check.pass, check.worst, check.limit, check.at),
                    (passes, value, limit, 1.0)
                );
                let mirrored = Extreme {
                    at: 1.0,
                    value: -value,
                };
                let check = Check::of(LimitKind::Curvature, mirrored, -limit, slack);
                assert_eq!(
                    (check.pass, check.worst, check.limit),
                    (passes, -value, -limit)
                );
            }
        }
    }
}
