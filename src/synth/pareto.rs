//! What one good costs in another: the least force error at each size of cam, jerk, acceleration or stroke.
//!
//! Every one of these is a convex limit, so holding it at a value and minimising the force error gives a
//! point of the front, and no point of the front is missed.

use super::{Design, Search, design};
use crate::cam::Criterion;
use crate::drive::DriveKind;
use crate::error::{Error, Placed, Result, SweepError, SynthError};
use crate::force::ForceCurve;
use crate::problem::{Problem, Size};
use crate::scene::{Family, LimitKind, Minimise, Scene};

/// What the force error is traded against.
///
/// ```
/// use gaitcam::synth::Against;
/// use gaitcam::{scene, synthesise};
///
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let design = synthesise(&scene, scene.model_force()?.as_ref())?;
/// assert_eq!(Against::Stroke.of(&design), design.cam.law.stroke());
/// assert_eq!(Against::Stroke.column(), "stroke_m");
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Against {
    /// Prime radius of a roller cam, base radius of a flat-faced one.
    PrimeRadius,
    /// Largest |d³s/dt³|.
    Jerk,
    /// Largest |d²s/dt²|.
    Acceleration,
    /// Largest |ds/dt|.
    Velocity,
    /// Stroke.
    Stroke,
    /// Largest torque of the shaft.
    Torque,
    /// Largest power of the shaft.
    Power,
    /// Highest Hertz pressure.
    HertzPressure,
    /// Speed of lift-off on a moving axis; the higher the better.
    LiftoffSpeed,
}

/// A point of the front.
///
/// ```
/// use gaitcam::scene;
/// use gaitcam::synth::{Against, trade};
///
/// // Less stroke costs force error.
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let front = trade(&scene, scene.model_force()?.as_ref(), Against::Stroke, 4)?;
/// for pair in front.windows(2) {
///     let cost = |i: usize| (pair[i].allowed, -pair[i].design.force.rms_error_n);
///     assert!((cost(0) <= cost(1)) || (cost(1) <= cost(0)));
/// }
/// assert!(front.len() >= 2);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Trade {
    /// The value that was allowed, SI.
    pub allowed: f64,
    /// The design of least force error under it.
    pub design: Design,
}

/// The front ends where the force error reaches this part of the mean force, or twice what it is at best.
const WORST: f64 = 0.1;
/// Halvings that look for that end.
const HALVINGS: usize = 14;
/// The other end stays this far inside what the unlimited law needs, so that the limit takes part.
const INSIDE: f64 = 1.0 - 1e-6;
/// Spans of the laws on the front when the scene leaves them open: twice what the unlimited law needs.
const MORE_SPANS: usize = 2;
/// … but no more than this.
const MOST_SPANS: usize = 64;

impl Against {
    /// Every quantity with the name users write and its column with unit.
    pub const NAMES: [(&'static str, Against, &'static str); 9] = [
        ("prime_radius", Against::PrimeRadius, "prime_radius_m"),
        ("jerk", Against::Jerk, "jerk_m_per_s3"),
        (
            "acceleration",
            Against::Acceleration,
            "acceleration_m_per_s2",
        ),
        ("velocity", Against::Velocity, "velocity_m_per_s"),
        ("stroke", Against::Stroke, "stroke_m"),
        ("torque", Against::Torque, "torque_max_n_m"),
        ("power", Against::Power, "power_max_w"),
        (
            "hertz_pressure",
            Against::HertzPressure,
            "hertz_pressure_max_pa",
        ),
        (
            "liftoff_speed",
            Against::LiftoffSpeed,
            "liftoff_speed_rad_per_s",
        ),
    ];

    /// Reads `force_error:prime_radius`, in either order.
    ///
    /// # Errors
    /// Other words, saying which are known.
    pub fn from_pair(pair: &str) -> Result<Self> {
        let others = || {
            Self::NAMES[1..]
                .iter()
                .map(|n| n.0)
                .collect::<Vec<_>>()
                .join(", ")
        };
        let (a, b) = pair
            .split_once(':')
            .ok_or_else(|| SynthError::PairIncomplete {
                pair: pair.to_string(),
                known: others(),
            })?;
        let other = match (a, b) {
            ("force_error", other) | (other, "force_error") => other,
            _ => return Err(SynthError::PairWithoutForceError { known: others() }.into()),
        };
        (Self::NAMES.iter().find(|n| {
            n.0 == other || names(n.2, other) || (n.0 == "prime_radius" && other == "base_radius")
        }))
        .map(|n| n.1)
        .ok_or_else(|| {
            let typed = other.to_string();
            let known = others();
            SynthError::PairUnknown { typed, known }.into()
        })
    }

    /// Its column with the unit.
    pub fn column(self) -> &'static str {
        Self::NAMES.iter().find(|n| n.1 == self).map_or("", |n| n.2)
    }

    /// Its value in a design, SI.
    pub fn of(self, design: &Design) -> f64 {
        let peak = |order: usize| {
            let (low, high) = design.cam.law.extremes(order);
            high.value.max(-low.value) * design.drive.speed.powi(order as i32)
        };
        match self {
            Against::PrimeRadius => design.cam.follower.prime_radius(),
            Against::Jerk => peak(3),
            Against::Acceleration => peak(2),
            Against::Velocity => peak(1),
            Against::Stroke => design.cam.law.stroke(),
            Against::Torque => known(design.machine().torque_max_n_m),
            Against::Power => known(design.machine().power_max_w),
            Against::HertzPressure => known(design.machine().hertz_pressure_max_pa),
            Against::LiftoffSpeed => known(design.machine().liftoff_speed_rad_per_s),
        }
    }

    /// A quantity that is to be small, from its value, and the value from it: of a lift-off speed the
    /// inverse, of all others themselves.
    fn turned(self, value: f64) -> f64 {
        match self {
            Against::LiftoffSpeed => 1.0 / value,
            _ => value,
        }
    }

    /// Refuses what no limit can hold in this problem.
    fn check(self, problem: &Problem) -> Result<()> {
        let fixed = matches!(problem.size(), Size::Given { .. });
        match self {
            Against::LiftoffSpeed if problem.drive.kind != DriveKind::MovingAxis => {
                let fault = Error::from(SweepError::FrontWithoutMovingAxis);
                Err(fault.at_key("drive.kind"))
            }
            Against::HertzPressure if !fixed => {
                let fault = Error::from(SweepError::FrontWithoutSize);
                Err(fault.at_key("cam.base_radius"))
            }
            _ => Ok(()),
        }
    }

    /// The problem with the quantity held at or below a value.
    fn held(self, problem: &Problem, value: f64) -> Problem {
        let mut out = problem.clone();
        let limits = &mut out.limits;
        if self == Against::LiftoffSpeed {
            // M(g + ωₗ²a) ≥ 0 bounds a, and with it the force at the speed of the machine.
            let drive = &problem.drive;
            let least = drive.rest_force * (1.0 - (drive.speed / value).powi(2));
            limits[LimitKind::ForceMin] =
                Some(limits[LimitKind::ForceMin].map_or(least, |own| own.max(least)));
            return out;
        }
        let at = match self {
            Against::PrimeRadius => &mut limits[LimitKind::PrimeRadius],
            Against::Jerk => &mut limits[LimitKind::Jerk],
            Against::Acceleration => &mut limits[LimitKind::Acceleration],
            Against::Velocity => &mut limits[LimitKind::Velocity],
            Against::Stroke => &mut limits[LimitKind::Stroke],
            Against::Torque => &mut limits[LimitKind::Torque],
            Against::Power => &mut limits[LimitKind::Power],
            Against::HertzPressure => &mut limits[LimitKind::HertzPressure],
            Against::LiftoffSpeed => &mut limits[LimitKind::ForceMin],
        };
        *at = Some(at.map_or(value, |own| own.min(value)));
        out
    }
}

/// Whether a word is a column's name, or its beginning.
fn names(column: &str, word: &str) -> bool {
    let rest = column.strip_prefix(word);
    rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('_'))
}

fn known(value: Option<f64>) -> f64 {
    value.unwrap_or(f64::NAN)
}

/// The front between force error and another quantity, from the tightest value to what the unlimited law
/// needs, in even steps.
///
/// # Errors
/// A scene without a force, a family other than splines, a size that the scene fixes, and where
/// the law without the limit cannot be built.
pub fn trade(
    scene: &Scene,
    force: Option<&ForceCurve>,
    against: Against,
    points: usize,
) -> Result<Vec<Trade>> {
    let search = Search::default();
    let mut problem = Problem::resolve(scene, force)?;
    if problem.target.is_none() {
        return Err(SynthError::NoTarget.at_key("gait"));
    }
    if !matches!(problem.law.family, Family::Spline | Family::Ladder) {
        return Err(SynthError::OnlySplines.at_key("law.family"));
    }
    let fixed = matches!(problem.size(), Size::Given { .. });
    if against == Against::PrimeRadius && fixed {
        return Err(SynthError::SizeFixed.at_key("cam"));
    }
    against.check(&problem)?;
    problem.law.family = Family::Spline;
    let first = design(&problem, &search)?;
    // The accuracy would raise the number of spans and fail what the front is there to show.
    let mut open = problem;
    open.accuracy = None;
    open.limits.unjudged.accuracy = true;
    open.law.minimise = Some(Minimise::ForceError);
    if open.law.spans.is_none() && open.law.dwells.is_empty() {
        let own = first.cam.law.poly().pieces();
        open.law.spans = Some((MORE_SPANS * own).min(MOST_SPANS.max(own)));
    }
    let free = design(&open, &search)?;
    if let Some(why) = &free.infeasible {
        return Err(why.no_law().at_key("limits"));
    }
    let most = against.turned(against.of(&free)) * INSIDE;
    let held = |value: f64| design(&against.held(&open, against.turned(value)), &search);
    // Demands may keep even the unlimited law farther away than that.
    let own = free.force.rms_error_n;
    let worst = (WORST * free.force.target_mean_n.abs()).max(2.0 * own);
    let good = |design: &Design| {
        let held = |c: &crate::cam::Check| c.pass || c.name == Criterion::RmsError;
        design.infeasible.is_none()
            && design.checks.iter().all(held)
            && design.force.rms_error_n <= worst
    };
    let (mut low, mut high) = (0.0, most);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        match held(middle) {
            Ok(design) if good(&design) => high = middle,
            _ => low = middle,
        }
    }
    // Nothing can be had below what the unlimited law takes: a bore, say, gives the size.
    if high == most && !held(most).is_ok_and(|d| good(&d)) {
        let allowed = against.of(&free);
        return Ok(vec![Trade {
            allowed,
            design: free,
        }]);
    }
    let mut out = Vec::with_capacity(points);
    for i in 0..points {
        let share = i as f64 / (points - 1).max(1) as f64;
        let value = high + share * (most - high);
        let design = held(value)?;
        if design.infeasible.is_none() {
            let allowed = against.turned(value);
            out.push(Trade { allowed, design });
        }
    }
    Ok(out)
}
