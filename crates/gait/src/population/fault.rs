//! What keeps a cycle out of a population.

use serde::Serialize;

use super::Walker;
use crate::units::G;

/// Mean force of both feet, parts of the weight, of a walker who can be.
const BOTH: std::ops::RangeInclusive<f64> = 0.85..=1.15;
/// People's weights are nearer to each other than this factor; units of force are farther apart.
const UNIT: f64 = 6.0;
/// The same of one foot.
const ONE: std::ops::RangeInclusive<f64> = 0.4..=0.65;

/// Why a cycle cannot be one of a population.
///
/// ```
/// use gaitcam_gait::{ForceCurve, Walker, WalkerFault, walker_fault};
///
/// // 700 N on average are no force of a walker of 90 kg.
/// let mut cycle = ForceCurve::from_samples("W01", 0.5, vec![700.0, 800.0, 700.0, 600.0])?;
/// cycle.mass_kg = Some(90.0);
/// let walkers = [Walker::new("W01", cycle)];
/// assert!(matches!(walker_fault(&walkers[0], &walkers), Some(WalkerFault::MeanNotWeight { .. })));
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum WalkerFault {
    /// The mean force is not positive.
    NoMeanForce,
    /// The mean force is not the weight of the mass.
    MeanNotWeight {
        /// Percent of the weight.
        percent: f64,
    },
    /// A force in another unit than those of the others.
    OtherUnit,
    /// One foot among both feet, or the other way round.
    OtherFeet,
    /// Another kind of movement than most.
    OtherKind,
}

/// What is wrong with a walker among others; `None` where nothing is.
pub fn fault(walker: &Walker, all: &[Walker]) -> Option<WalkerFault> {
    let mean = walker.curve.mean_n();
    if !(mean.is_finite() && mean > 0.0) {
        return Some(WalkerFault::NoMeanForce);
    }
    let median = median(all.iter().map(|w| w.curve.mean_n().abs()));
    if mean * UNIT < median || mean > UNIT * median {
        return Some(WalkerFault::OtherUnit);
    }
    if let Some(share) = share(walker) {
        if !BOTH.contains(&share) && !ONE.contains(&share) {
            let percent = 100.0 * share;
            return Some(WalkerFault::MeanNotWeight { percent });
        }
        let alike = |w: &&Walker| {
            self::share(w).is_some_and(|s| BOTH.contains(&s) == BOTH.contains(&share))
        };
        let judged = all.iter().filter(|w| self::share(w).is_some()).count();
        if 2 * all.iter().filter(alike).count() < judged {
            return Some(WalkerFault::OtherFeet);
        }
    }
    let kind = kind(walker)?;
    let alike = all.iter().filter(|w| self::kind(w) == Some(kind)).count();
    let judged = all.iter().filter(|w| self::kind(w).is_some()).count();
    (2 * alike < judged).then_some(WalkerFault::OtherKind)
}

fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut all: Vec<f64> = values.filter(|x| x.is_finite()).collect();
    all.sort_by(f64::total_cmp);
    all.get(all.len() / 2).copied().unwrap_or_default()
}

/// Mean force as a part of the weight, where the mass is known.
fn share(walker: &Walker) -> Option<f64> {
    Some(walker.curve.mean_n() / (walker.curve.mass_kg? * G))
}

fn kind(walker: &Walker) -> Option<&'static str> {
    Some(walker.curve.recording.as_ref()?.kind?.name())
}
