//! What is asked of a cam, and the verdict.

use super::fit::mm;
use super::{Cam, Follower, SizeLimits, smallest_for};
use crate::poly::Extreme;

/// Where the finished profile is sharpest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Curvature {
    /// Smallest radius of the convex side, m, signed: negative means undercut. Infinite when no part is
    /// convex.
    pub convex: Extreme,
    /// Tightest concave radius, m (negative), where a flank is concave.
    pub concave: Option<Extreme>,
    /// The follower would cut away profile that it needs later.
    pub undercut: bool,
}

/// One limit held against what the cam does.
#[derive(Debug, Clone, PartialEq)]
pub struct Check {
    /// Name of the limit, as users know it: `stroke`, `curvature`, `pressure_angle_rise` …
    pub name: String,
    /// Worst value anywhere on the continuous law, SI.
    pub worst: f64,
    /// What is allowed, SI.
    pub limit: f64,
    /// Cam angle of the worst value, rad.
    pub at: f64,
    /// Whether the limit holds.
    pub pass: bool,
}

impl Check {
    /// A value that must not exceed its limit by more than `slack` of it.
    pub fn at_most(name: &str, worst: Extreme, limit: f64, slack: f64) -> Self {
        let pass = worst.value <= limit + slack * limit.abs();
        Check {
            name: name.to_string(),
            worst: worst.value,
            limit,
            at: worst.at,
            pass,
        }
    }

    /// A value that must not fall below its limit by more than `slack` of it.
    pub fn at_least(name: &str, worst: Extreme, limit: f64, slack: f64) -> Self {
        let pass = worst.value >= limit - slack * limit.abs();
        Check {
            name: name.to_string(),
            worst: worst.value,
            limit,
            at: worst.at,
            pass,
        }
    }
}

/// The three classes of CAM-DAS (Serrano Muñoz 2010).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Verdict {
    /// Every check passes and the acceleration is continuous.
    Acceptable,
    /// Every check passes, but the acceleration jumps somewhere: slow machines only.
    NotForHighSpeed,
    /// A check fails, or lift or velocity jumps.
    Unacceptable,
}

impl Verdict {
    /// The word of `summary.json`.
    pub fn name(self) -> &'static str {
        match self {
            Verdict::Acceptable => "acceptable",
            Verdict::NotForHighSpeed => "not-for-high-speed",
            Verdict::Unacceptable => "unacceptable",
        }
    }
}

/// The class of a cam with the reason for it.
#[derive(Debug, Clone, PartialEq)]
pub struct Judgement {
    /// The class.
    pub verdict: Verdict,
    /// Why, in one sentence for a student.
    pub reason: String,
    /// The class CAM-DAS itself would give (Serrano Muñoz 2010, §7.3.5), stricter by one derivative: a jump of jerk makes
    /// a cam not fit for high speed, a jump of acceleration unacceptable but for constant breadth.
    pub cam_das: Verdict,
}

/// Jumps below this share of the largest value of their derivative are rounding.
const JUMP: f64 = 1e-9;

/// Judges a cam by its joints, its curvature and the limits held against it.
///
/// The wording follows the order in which a designer mends: first what tears follower and cam apart (lift,
/// velocity), then geometry (undercut, cusp), then limits, then acceleration.
pub fn judge(cam: &Cam, checks: &[Check]) -> Judgement {
    let jumps = Jumps::of(cam);
    let curvature = cam.curvature();
    let fault = jumps
        .words(0, "the lift")
        .or_else(|| jumps.words(1, "the velocity"))
        .map(|w| format!("{w}: the follower would be struck or thrown off; join the motions there"))
        .or_else(|| undercut_words(cam, &curvature))
        .or_else(|| failed_words(cam, checks));
    if let Some(reason) = fault {
        return Judgement {
            verdict: Verdict::Unacceptable,
            reason,
            cam_das: Verdict::Unacceptable,
        };
    }
    if let Some(words) = jumps.words(2, "the acceleration") {
        return Judgement {
            verdict: Verdict::NotForHighSpeed,
            reason: format!(
                "{words}: the contact force jumps with it and shakes a fast machine; use it slowly or choose motions that meet in acceleration"
            ),
            cam_das: if has_constant_breadth(cam) {
                Verdict::Acceptable
            } else {
                Verdict::Unacceptable
            },
        };
    }
    match jumps.words(3, "the jerk") {
        Some(words) => Judgement {
            verdict: Verdict::Acceptable,
            reason: format!(
                "lift, velocity and acceleration are continuous and every check passes; {words}, which may ring at very high speed"
            ),
            cam_das: Verdict::NotForHighSpeed,
        },
        None => Judgement {
            verdict: Verdict::Acceptable,
            reason: "lift, velocity, acceleration and jerk are continuous and every check passes"
                .to_string(),
            cam_das: Verdict::Acceptable,
        },
    }
}

/// The largest jump of every derivative, when it is more than rounding.
struct Jumps {
    worst: [Option<Extreme>; 4],
    straight: bool,
}

impl Jumps {
    fn of(cam: &Cam) -> Self {
        let mut worst = [None; 4];
        let joints = cam.law.joints();
        for (order, worst) in worst.iter_mut().enumerate() {
            let (low, high) = cam.law.extremes(order);
            let scale = low.value.abs().max(high.value.abs());
            for joint in &joints {
                let jump = [joint.jump.s, joint.jump.v, joint.jump.a, joint.jump.j][order];
                let larger = worst.is_none_or(|w: Extreme| jump.abs() > w.value.abs());
                if jump.abs() > JUMP * scale && larger {
                    *worst = Some(Extreme {
                        at: joint.at,
                        value: jump,
                    });
                }
            }
        }
        Jumps {
            worst,
            straight: matches!(cam.follower, Follower::TranslatingCam { .. }),
        }
    }

    fn words(&self, order: usize, what: &str) -> Option<String> {
        let jump = self.worst[order]?;
        let at = place(self.straight, jump.at);
        Some(format!("{what} jumps by {:.4e} at {at}", jump.value))
    }
}

fn place(straight: bool, at: f64) -> String {
    if straight {
        format!("{:.3} mm", 1e3 * at)
    } else {
        format!("{:.2}°", at.to_degrees())
    }
}

fn undercut_words(cam: &Cam, curvature: &Curvature) -> Option<String> {
    let rho = curvature.convex;
    if rho.value > 0.0 {
        return None;
    }
    let straight = matches!(cam.follower, Follower::TranslatingCam { .. });
    let what = if curvature.undercut {
        "the profile is undercut: it crosses itself and the follower cannot reach it"
    } else {
        "the profile has a cusp, a sharp point that wears at once"
    };
    let at = place(straight, rho.at);
    let cure = match smallest_for(cam, &SizeLimits::no_undercut()) {
        Ok(base) if !straight => format!("a base radius above {} mends it", mm(base)),
        _ => "use a smaller roller or spread the motion".to_string(),
    };
    Some(format!("{what} (radius {} at {at}); {cure}", mm(rho.value)))
}

fn failed_words(cam: &Cam, checks: &[Check]) -> Option<String> {
    let check = checks.iter().find(|c| !c.pass)?;
    let straight = matches!(cam.follower, Follower::TranslatingCam { .. });
    let at = place(straight, check.at);
    let angle = check.name.starts_with("pressure_angle");
    Some(if angle {
        format!(
            "the pressure angle reaches {:.2}° at {at}, more than the {:.2}° allowed: the push goes sideways and jams the follower; enlarge the cam or shift its offset",
            check.worst.to_degrees(),
            check.limit.to_degrees()
        )
    } else {
        format!(
            "{} is {:.6e} at {at} where {:.6e} is allowed",
            check.name, check.worst, check.limit
        )
    })
}

/// Whether s(θ) + s(θ + π) is the same everywhere.
fn has_constant_breadth(cam: &Cam) -> bool {
    let (start, length) = cam.law.extent();
    let half = 0.5 * length;
    let stroke = cam.law.stroke();
    let sum = |x: f64| cam.law.svaj(x).s + cam.law.svaj(x + half).s;
    let first = sum(start);
    (1..32).all(|i| (sum(start + half * f64::from(i) / 32.0) - first).abs() <= JUMP * stroke)
}
