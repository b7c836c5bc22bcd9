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
    /// One step among strides, or the other way round.
    OtherCycle,
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
    let halves = is_of_halves(walker);
    if 2 * all.iter().filter(|w| is_of_halves(w) == halves).count() < all.len() {
        return Some(WalkerFault::OtherCycle);
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

/// Whether the halves of a cycle are more alike than opposite, as the two steps of a stride are.
fn is_of_halves(walker: &Walker) -> bool {
    let (force, mean) = (&walker.curve.force_n, walker.curve.mean_n());
    let half = force.len() / 2;
    let pairs = force.iter().zip(force.iter().cycle().skip(half));
    pairs.map(|(a, b)| (a - mean) * (b - mean)).sum::<f64>() > 0.0
}

/// Mean force as a part of the weight, where the mass is known.
fn share(walker: &Walker) -> Option<f64> {
    Some(walker.curve.mean_n() / (walker.curve.mass_kg? * G))
}

fn kind(walker: &Walker) -> Option<&'static str> {
    Some(walker.curve.recording.as_ref()?.kind?.name())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::ForceCurve;

    /// A walker of a load model, as one step or as a stride of two steps of which the second is stronger by a part.
    fn walker(model: &str, f: f64, uneven: Option<f64>) -> Walker {
        let step = crate::model(model, Some(f), 700.0, crate::Feet::Both).unwrap();
        let mut force = step.force_n.clone();
        if let Some(part) = uneven {
            force.extend(
                step.force_n
                    .iter()
                    .map(|x| 700.0 + (1.0 + part) * (x - 700.0)),
            );
        }
        let steps = if uneven.is_some() { 2.0 } else { 1.0 };
        let curve = ForceCurve::from_samples("", steps / f, force).unwrap();
        Walker::new(&format!("{model} {f}"), curve)
    }

    #[test]
    fn one_step_among_strides_is_noticed_and_the_reverse() {
        for model in ["young", "setra", "kerr"] {
            for f in [1.5, 1.85, 2.3] {
                for uneven in [0.0, 0.5, -0.4] {
                    let strides = [1.4, 1.8, 2.2].map(|f| walker(model, f, Some(0.1)));
                    let mut all = strides.to_vec();
                    all.push(walker(model, f, Some(uneven)));
                    assert!(all.iter().all(|w| fault(w, &all).is_none()), "{model} {f}");
                    all[3] = walker(model, f, None);
                    let of = |w: &Walker, all: &[Walker]| fault(w, all);
                    assert_eq!(
                        of(&all[3], &all),
                        Some(WalkerFault::OtherCycle),
                        "{model} {f}"
                    );
                    let mut steps = [1.4, 1.8, 2.2].map(|f| walker(model, f, None)).to_vec();
                    steps.push(walker(model, f, Some(uneven)));
                    assert_eq!(of(&steps[3], &steps), Some(WalkerFault::OtherCycle));
                    assert_eq!(of(&steps[0], &steps), None);
                }
            }
        }
    }
}
