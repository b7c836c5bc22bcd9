//! Trade-off fronts: minimum force error as a function of another quantity, such as the size of the cam, the jerk, the acceleration or the
//! stroke. The limit on each of these quantities is convex, so minimising the force error for each permitted value gives every point of the
//! front.

use super::design::Design;
use super::design::figures::{FIGURES, Figure, Figures};
use super::search::Search;
use super::synthesis::design;
use crate::cam::Criterion;
use crate::drive::DriveKind;
use crate::error::{Placed, Result, SweepError, SynthError};
use crate::problem::{Problem, Size};
use crate::scene::{Family, LawSpec, LimitKind, Minimise};

/// Point of a trade-off front.
///
/// ```
/// use gaitcam::synth::{Search, trade, traded};
/// use gaitcam::{Problem, scene};
///
/// // A smaller stroke causes a larger force error.
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let problem = Problem::resolve(&scene, scene.model_force()?.as_ref())?;
/// let front = trade(&problem, traded("force_error:stroke")?, 4, &Search::default())?;
/// for pair in front.windows(2) {
///     let cost = |i: usize| (pair[i].allowed, -pair[i].design.force.rms_error_n);
///     assert!((cost(0) <= cost(1)) || (cost(1) <= cost(0)));
/// }
/// assert!(front.len() >= 2);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Trade {
    /// Permitted value of the quantity other than the force error, in SI units.
    pub allowed: f64,
    /// Design with the minimum force error for the permitted value.
    pub design: Design,
}

/// Largest force error on the front, relative to the mean force. If twice the error of the unlimited law is larger than this value, twice
/// the error is the maximum instead.
const WORST: f64 = 0.1;
/// Number of bisection steps that find the tightest value of the front.
const HALVINGS: usize = 14;
/// Ratio of the weakest permitted value on the front and the value of the unlimited law. The ratio is below 1, so that the limit is active.
const INSIDE: f64 = 1.0 - 1e-6;
/// Factor from the number of spans of the first design to the number of spans of a law on the front.
const MORE_SPANS: usize = 2;
/// Maximum automatic number of spans of a law on the front.
const MOST_SPANS: usize = 64;

/// The quantity (figure) that is combined with the force error in a pair such as `force_error:prime_radius`, in either order.
///
/// # Errors
/// The pair is incomplete, lacks the force error, or contains an unknown figure. The error lists the valid figures.
///
/// ```
/// use gaitcam::synth::traded;
///
/// assert_eq!(traded("stroke:force_error")?.column, "stroke_m");
/// assert!(traded("force_error:mass").is_err());
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
pub fn traded(pair: &str) -> Result<&'static Figure> {
    // The prime radius is the example in the message.
    let others = || Figure::traded_names().filter(|name| *name != "prime_radius");
    let known = || others().collect::<Vec<_>>().join(", ");
    let (a, b) = pair
        .split_once(':')
        .ok_or_else(|| SynthError::PairIncomplete {
            pair: pair.to_string(),
            known: known(),
        })?;
    let other = match (a, b) {
        ("force_error", other) | (other, "force_error") => other,
        _ => return Err(SynthError::PairWithoutForceError { known: known() }.into()),
    };
    // The size of a flat-faced cam is its base radius.
    let other = if other == "base_radius" {
        "prime_radius"
    } else {
        other
    };
    let mut traded = FIGURES.iter().filter(|f| f.trade.is_some());
    let figure = traded.find(|f| f.trade == Some(other) || names(f.key, other));
    figure.ok_or_else(|| {
        let typed = other.to_string();
        let known = known();
        SynthError::PairUnknown { typed, known }.into()
    })
}

/// Limit of a problem that bounds a figure.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Bound {
    /// The limit of the figure in the scene.
    Limit(LimitKind),
    /// Lift-off speed, bounded by a minimum force at the speed of the machine.
    LiftoffSpeed,
}

impl Bound {
    fn of(figure: &Figure) -> Bound {
        figure.limit.map_or(Bound::LiftoffSpeed, Bound::Limit)
    }

    /// Converts a value of the figure to a quantity to be minimised, or back. The result is the reciprocal of a lift-off speed, and the
    /// unchanged value for other figures.
    fn turned(self, value: f64) -> f64 {
        match self {
            Bound::LiftoffSpeed => 1.0 / value,
            Bound::Limit(_) => value,
        }
    }

    /// Rejects problems for which the front is not defined, and figures that cannot be limited.
    fn check(self, problem: &Problem) -> Result<()> {
        if problem.target.is_none() {
            return Err(SynthError::NoTarget.at_key("gait"));
        }
        if !matches!(problem.law.family, Family::Spline | Family::Auto) {
            return Err(SynthError::OnlySplines.at_key("law.family"));
        }
        let fixed = matches!(problem.size(), Size::Given { .. });
        match self {
            Bound::LiftoffSpeed if problem.drive.kind != DriveKind::MovingAxis => {
                Err(SweepError::FrontWithoutMovingAxis.at_key("drive.kind"))
            }
            Bound::Limit(LimitKind::HertzPressure) if !fixed => {
                Err(SweepError::FrontWithoutSize.at_key("cam.base_radius"))
            }
            Bound::Limit(LimitKind::PrimeRadius) if fixed => {
                Err(SynthError::SizeFixed.at_key("cam"))
            }
            _ => Ok(()),
        }
    }

    /// The problem with `value` as a bound of the figure. A stricter limit of the scene is kept.
    fn held(self, problem: &Problem, value: f64) -> Problem {
        match self {
            Bound::LiftoffSpeed => {
                // With the lift-off speed ωₗ, the condition M(g + ωₗ²a) ≥ 0 bounds a, and thereby the force at the speed of the machine.
                let drive = &problem.drive;
                let least = drive.rest_force * (1.0 - (drive.speed / value).powi(2));
                let own = problem.limits[LimitKind::ForceMin];
                let bound = own.map_or(least, |own| own.max(least));
                problem.with(LimitKind::ForceMin.into(), bound)
            }
            Bound::Limit(kind) => {
                let bound = problem.limits[kind].map_or(value, |own| own.min(value));
                problem.with(kind.into(), bound)
            }
        }
    }
}

/// Whether a word is the name of a column or its beginning, up to an underscore.
fn names(column: &str, word: &str) -> bool {
    let rest = column.strip_prefix(word);
    rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('_'))
}

/// The problem on which all points of the front are based: a spline with minimum force error, without a limit on this error.
fn unlimited(problem: &Problem, search: &Search) -> Result<Problem> {
    let mut law = LawSpec {
        family: Family::Spline,
        ..problem.law.clone()
    };
    let first = design(&problem.with_law(law.clone()), search)?;
    law.minimise = Some(Minimise::ForceError);
    if law.spans.is_none() && law.dwells.is_empty() {
        let own = first.cam.law.poly().pieces();
        law.spans = Some((MORE_SPANS * own).min(MOST_SPANS.max(own)));
    }
    // The check of the accuracy would fail for most points of the front.
    Ok(problem.with_law(law).without_accuracy())
}

/// Trade-off front between the force error and another quantity. The permitted values have equal steps, from the tightest value to the value of
/// the unlimited law. If the search is stopped, the front has fewer points.
///
/// # Errors
///
/// The problem has no target force, its family is neither `spline` nor `auto`, or its limits are infeasible. For the prime radius, the size
/// is given. For the Hertz pressure, the size is not given. For the lift-off speed, the drive is not a moving axis.
pub fn trade(
    problem: &Problem,
    against: &Figure,
    points: usize,
    search: &Search,
) -> Result<Vec<Trade>> {
    let bound = Bound::of(against);
    bound.check(problem)?;
    let of = |design: &Design| against.value(&Figures::of(design));
    let open = unlimited(problem, search)?;
    let free = design(&open, search)?;
    if let Some(why) = &free.infeasible {
        return Err(why.no_law().at_key("limits"));
    }
    let most = bound.turned(of(&free)) * INSIDE;
    let held = |value: f64| design(&bound.held(&open, bound.turned(value)), search);
    // Conditions may cause a larger force error even for the unlimited law.
    let own = free.force.rms_error_n;
    let worst = (WORST * free.force.target_mean_n.abs()).max(2.0 * own);
    let good = |design: &Design| {
        let held = |c: &crate::cam::Check| c.pass || c.name == Criterion::RmsError;
        design.infeasible.is_none()
            && !design.out_of_time
            && design.checks.iter().all(held)
            && design.force.rms_error_n <= worst
    };
    let (mut low, mut high) = (0.0, most);
    for _ in 0..HALVINGS {
        if search.halt.is_asked() {
            return Ok(Vec::new());
        }
        let middle = 0.5 * (low + high);
        match held(middle) {
            Ok(design) if good(&design) => high = middle,
            _ => low = middle,
        }
    }
    // Values below the value of the unlimited law may be infeasible, for example if a bore determines the size.
    if high == most && !held(most).is_ok_and(|d| good(&d)) {
        let (allowed, design) = (of(&free), free);
        return Ok(vec![Trade { allowed, design }]);
    }
    let mut out = Vec::with_capacity(points);
    for i in 0..points {
        let share = i as f64 / (points - 1).max(1) as f64;
        let value = high + share * (most - high);
        let design = held(value)?;
        if search.halt.is_asked() {
            break;
        }
        if design.infeasible.is_none() {
            let allowed = bound.turned(value);
            out.push(Trade { allowed, design });
        }
    }
    Ok(out)
}
