//! Reasons why a cycle is excluded from a population.

use std::collections::HashMap;

use serde::Serialize;

use super::Walker;
use crate::units::G;

/// Permitted range of the mean force of both feet, as fractions of the body weight.
const BOTH: std::ops::RangeInclusive<f64> = 0.85..=1.15;
/// Ratio of a mean force to the median of the population, or its reciprocal, above which the unit of force is assumed to differ. The
/// weights of walkers differ by a smaller factor.
const UNIT: f64 = 6.0;
/// Permitted range of the mean force of one foot, as fractions of the body weight.
const ONE: std::ops::RangeInclusive<f64> = 0.4..=0.65;
/// The foot is considered off the ground if the force is below this fraction of its mean.
const LIFTED: f64 = 0.02;
/// Ratio of two periods above which the shorter one is the period of a step and the longer one is the period of a stride. A stride consists
/// of two steps.
const STEPS: f64 = 1.45;

/// Reason why a cycle cannot belong to a population.
///
/// ```
/// use gaitcam_gait::{ForceCurve, Walker, WalkerFault, walker_faults};
///
/// // The mean force of a walker of 90 kg is not 700 N.
/// let mut cycle = ForceCurve::from_samples("W01", 0.5, vec![700.0, 800.0, 700.0, 600.0])?;
/// cycle.mass_kg = Some(90.0);
/// let walkers = [Walker::new("W01", cycle)];
/// assert!(matches!(walker_faults(&walkers)[0], Some(WalkerFault::MeanNotWeight { .. })));
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum WalkerFault {
    /// The mean force is not positive.
    NoMeanForce,
    /// The mean force differs from the weight that follows from the mass.
    MeanNotWeight {
        /// Mean force, in percent of the weight.
        percent: f64,
    },
    /// The mean force differs so strongly from that of most cycles that its unit is probably another one.
    OtherUnit,
    /// The cycle is of one foot, but most cycles are of both feet, or vice versa.
    OtherFeet,
    /// The cycle is a step, but most cycles are strides, or vice versa.
    OtherCycle,
    /// The kind of movement differs from that of most cycles.
    OtherKind,
}

/// Reason for the exclusion of each walker; `None` for an included walker.
pub fn faults(all: &[Walker]) -> Vec<Option<WalkerFault>> {
    let crowd = Crowd::of(all);
    all.iter().map(|walker| crowd.fault(walker)).collect()
}

/// Properties of the majority of the cycles in a population.
struct Crowd {
    /// Median of the mean forces of all cycles, N.
    force: f64,
    /// Median period, s, of the cycles that have the most frequent number of steps (see `halves`).
    period: f64,
    /// Whether most cycles with a known mass are of both feet.
    both_feet: bool,
    /// Whether most cycles are of one foot. A cycle with a known mass is classified by its mean force. A cycle without mass and movement
    /// counts as one foot if its force falls almost to zero.
    one_foot: bool,
    /// Whether most cycles consist of two similar halves, as a stride of two steps does.
    halves: bool,
    /// Number of cycles for each kind of movement. Cycles without a known kind are not counted.
    kinds: HashMap<&'static str, usize>,
}

impl Crowd {
    fn of(all: &[Walker]) -> Crowd {
        let shares: Vec<f64> = all.iter().filter_map(share).collect();
        let both = shares.iter().filter(|s| BOTH.contains(s)).count();
        let written: Vec<&Walker> = all.iter().filter(|w| is_written(w)).collect();
        let single = shares.iter().filter(|s| ONE.contains(s)).count();
        let single = single + written.iter().filter(|w| lifts(w)).count();
        let of_halves = all.iter().filter(|w| is_of_halves(w)).count();
        let halves = 2 * of_halves >= all.len();
        let alike = all.iter().filter(|w| is_of_halves(w) == halves);
        let mut kinds = HashMap::new();
        for kind in all.iter().filter_map(kind) {
            *kinds.entry(kind).or_default() += 1;
        }
        Crowd {
            force: median(all.iter().map(|w| w.curve.mean_n().abs())),
            period: median(alike.map(|w| w.curve.period_s)),
            both_feet: 2 * both >= shares.len(),
            one_foot: 2 * single > shares.len() + written.len(),
            halves,
            kinds,
        }
    }

    fn fault(&self, walker: &Walker) -> Option<WalkerFault> {
        let (mean, period) = (walker.curve.mean_n(), walker.curve.period_s);
        if !(mean.is_finite() && mean > 0.0) {
            return Some(WalkerFault::NoMeanForce);
        }
        if mean * UNIT < self.force || mean > UNIT * self.force {
            return Some(WalkerFault::OtherUnit);
        }
        if let Some(share) = share(walker) {
            let is_both = BOTH.contains(&share);
            if !is_both && !ONE.contains(&share) {
                let percent = 100.0 * share;
                return Some(WalkerFault::MeanNotWeight { percent });
            }
            if is_both != self.both_feet {
                return Some(WalkerFault::OtherFeet);
            }
        }
        if is_written(walker) && lifts(walker) != self.one_foot {
            return Some(WalkerFault::OtherFeet);
        }
        let is_other = if self.halves {
            period * STEPS < self.period
        } else {
            period > STEPS * self.period
        };
        if is_other && is_of_halves(walker) != self.halves {
            return Some(WalkerFault::OtherCycle);
        }
        let alike = self.kinds.get(kind(walker)?)?;
        let judged: usize = self.kinds.values().sum();
        (2 * alike < judged).then_some(WalkerFault::OtherKind)
    }
}

/// Whether neither mass nor movement is known, as for a cycle that the user wrote.
fn is_written(walker: &Walker) -> bool {
    walker.curve.mass_kg.is_none() && kind(walker).is_none()
}

/// Whether the force falls almost to zero, as it does for one foot.
fn lifts(walker: &Walker) -> bool {
    let least = walker
        .curve
        .force_n
        .iter()
        .copied()
        .fold(f64::INFINITY, f64::min);
    least < LIFTED * walker.curve.mean_n()
}

fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut all: Vec<f64> = values.filter(|x| x.is_finite()).collect();
    all.sort_by(f64::total_cmp);
    all.get(all.len() / 2).copied().unwrap_or_default()
}

/// Whether the deviations from the mean force are similar in both halves of a cycle, as in the two steps of a stride. In a single step,
/// they have opposite signs.
fn is_of_halves(walker: &Walker) -> bool {
    let (force, mean) = (&walker.curve.force_n, walker.curve.mean_n());
    let half = force.len() / 2;
    let pairs = force.iter().zip(force.iter().cycle().skip(half));
    pairs.map(|(a, b)| (a - mean) * (b - mean)).sum::<f64>() > 0.0
}

/// Mean force as a fraction of the weight, if the mass is known.
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

    /// A walker from a load model: one step, or a stride of two steps of which the second is stronger by the fraction `uneven`.
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
                    assert!(faults(&all).iter().all(Option::is_none), "{model} {f}");
                    all[3] = walker(model, f, None);
                    assert_eq!(
                        faults(&all),
                        [None, None, None, Some(WalkerFault::OtherCycle)],
                        "{model} {f}"
                    );
                    let mut steps = [1.4, 1.8, 2.2].map(|f| walker(model, f, None)).to_vec();
                    steps.push(walker(model, f, Some(uneven)));
                    assert_eq!(
                        faults(&steps),
                        [None, None, None, Some(WalkerFault::OtherCycle)]
                    );
                }
            }
        }
    }

    #[test]
    fn one_foot_among_both_is_noticed_without_a_mass() {
        let mut all = [1.4, 1.8, 2.2].map(|f| walker("young", f, None)).to_vec();
        let one = crate::model("li-2010", Some(1.9), 700.0, crate::Feet::One).unwrap();
        all.push(Walker::new("one", one));
        assert_eq!(
            faults(&all),
            [None, None, None, Some(WalkerFault::OtherFeet)]
        );
    }

    /// A walker without a mass in the file is added to walkers with known masses.
    #[test]
    fn one_foot_without_a_mass_among_walkers_with_masses_is_noticed() {
        let known = |f| {
            let mut both = walker("young", f, None);
            both.curve.mass_kg = Some(700.0 / G);
            both
        };
        let mut all = [1.4, 1.8, 2.2].map(known).to_vec();
        let one = crate::model("li-2010", Some(1.9), 700.0, crate::Feet::One).unwrap();
        all.push(Walker::new("one", one));
        let other = Some(WalkerFault::OtherFeet);
        assert_eq!(faults(&all), [None, None, None, other]);
        all[3] = walker("young", 1.9, None);
        assert!(faults(&all).iter().all(Option::is_none));
    }

    /// A slow step with a dominant second harmonic has two peaks, as a stride has, but not the period of a stride.
    #[test]
    fn a_step_of_two_peaks_is_no_stride() {
        let mut all = [1.4, 1.8, 2.2].map(|f| walker("young", f, None)).to_vec();
        let force = (0..100).map(|i| {
            let x = std::f64::consts::TAU * f64::from(i) / 100.0;
            700.0 * (1.0 + 0.1 * x.sin() + 0.14 * (2.0 * x).sin())
        });
        let curve = ForceCurve::from_samples("", 1.0 / 1.4, force.collect()).unwrap();
        all.push(Walker::new("slow", curve));
        assert!(is_of_halves(&all[3]));
        assert_eq!(faults(&all), [None, None, None, None]);
    }
}
