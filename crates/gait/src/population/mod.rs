//! Several walkers for whom one cam is designed: cycles with statistical weights, and the mean of these cycles.

mod fault;
mod table;

use std::f64::consts::TAU;
use std::sync::Arc;

pub use fault::{WalkerFault, faults};
pub use table::{WalkerRow, is_table, read_rows, read_table, write_table};

use crate::curve::ForceCurve;
use crate::error::{ForceError, Result};

/// Cycle of one walker, with a statistical weight.
///
/// ```
/// use gaitcam_gait::{ForceCurve, Walker};
///
/// let cycle = ForceCurve::from_samples("W01", 0.5, vec![700.0, 800.0, 700.0, 600.0])?;
/// assert_eq!(Walker::new("W01", cycle).weight, 1.0);
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Walker {
    /// Name of the walker. All cycles with this name belong to this walker.
    pub name: String,
    /// Mean cycle of the force of the walker.
    pub curve: ForceCurve,
    /// Statistical weight of the walker in a mean. Only the ratios of the statistical weights of the walkers affect the mean.
    pub weight: f64,
    /// Walking speed, m/s, if known.
    pub speed_m_per_s: Option<f64>,
}

impl Walker {
    /// A walker with the statistical weight 1 in means and an unknown walking speed.
    pub fn new(name: &str, curve: ForceCurve) -> Walker {
        Walker {
            name: name.to_string(),
            curve,
            weight: 1.0,
            speed_m_per_s: None,
        }
    }
}

/// Walkers for whom one cam is designed.
///
/// ```
/// use gaitcam_gait::{ForceCurve, Walker};
///
/// // The mean of two walkers is computed from the cycles as fractions of the weight and multiplied by the mean weight.
/// let cycle = |g: f64, a: f64| ForceCurve::from_samples("", 0.5, vec![g, g * (1.0 + a), g, g * (1.0 - a)]);
/// let walkers = vec![Walker::new("A", cycle(600.0, 0.2)?), Walker::new("B", cycle(800.0, 0.4)?)];
/// let mean = ForceCurve::of_walkers(walkers)?;
/// assert!((mean.mean_n() - 700.0).abs() < 1e-9);
/// assert!((mean.at(std::f64::consts::FRAC_PI_2) - 700.0 * 1.3).abs() < 1.0);
/// assert_eq!(mean.population.unwrap().count(), 2);
/// # Ok::<(), gaitcam_gait::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Population {
    /// All cycles of all walkers.
    pub walkers: Vec<Walker>,
    /// Statistical weight of each cycle in a mean. The sum of these weights is 1. The cycles of a walker share the statistical weight of
    /// the walker.
    pub shares: Vec<f64>,
}

impl Population {
    fn of(walkers: Vec<Walker>) -> Population {
        let mut cycles: std::collections::HashMap<&str, f64> = Default::default();
        for walker in &walkers {
            *cycles.entry(&walker.name).or_default() += 1.0;
        }
        let each = walkers.iter().map(|w| w.weight / cycles[w.name.as_str()]);
        let each: Vec<f64> = each.collect();
        let total: f64 = each.iter().sum();
        let shares = each.iter().map(|w| w / total).collect();
        Population { walkers, shares }
    }

    /// Number of walkers, regardless of the number of their cycles.
    pub fn count(&self) -> usize {
        let names = self.walkers.iter().map(|w| w.name.as_str());
        names.collect::<std::collections::HashSet<_>>().len()
    }

    /// Each cycle with its statistical weight in a mean (see `shares`).
    pub fn each(&self) -> impl Iterator<Item = (&Walker, f64)> {
        self.walkers.iter().zip(self.shares.iter().copied())
    }
}

impl ForceCurve {
    /// Mean cycle of several walkers. The forces of each walker are divided by the mean force of this walker and averaged. The average is
    /// then scaled to the average of the mean forces and to the mean cadence.
    ///
    /// The field `population` of the result lists the walkers. For a single walker, the result is the cycle of this walker.
    ///
    /// # Errors
    ///
    /// There is no walker; a statistical weight is not positive; a mean force is not positive.
    pub fn of_walkers(walkers: Vec<Walker>) -> Result<ForceCurve> {
        let positive = |x: f64| x.is_finite() && x > 0.0;
        for walker in &walkers {
            if !positive(walker.weight) || !positive(walker.curve.mean_n()) {
                let walker = walker.name.clone();
                return Err(ForceError::WalkerImpossible { walker }.into());
            }
        }
        let population = Population::of(walkers);
        let mut mean = match population.walkers.as_slice() {
            [] => return Err(ForceError::NoWalkers.into()),
            [one] => one.curve.clone(),
            _ => population.mean()?,
        };
        mean.population = Some(Arc::new(population));
        Ok(mean)
    }
}

impl Population {
    fn mean(&self) -> Result<ForceCurve> {
        let samples = self.walkers.iter().map(|w| w.curve.force_n.len());
        let n = samples.max().unwrap_or(0);
        let weight: f64 = self.each().map(|(w, p)| p * w.curve.mean_n()).sum();
        let cadence: f64 = self.each().map(|(w, p)| p / w.curve.period_s).sum();
        let mut force = vec![0.0; n];
        for (walker, part) in self.each() {
            let curve = &walker.curve;
            let factor = part * weight / curve.mean_n();
            if curve.force_n.len() == n {
                let samples = force.iter_mut().zip(&curve.force_n);
                samples.for_each(|(sum, f)| *sum += factor * f);
            } else {
                let at = |i: usize| curve.at(TAU * i as f64 / n as f64);
                (force.iter_mut().enumerate()).for_each(|(i, sum)| *sum += factor * at(i));
            }
        }
        ForceCurve::from_samples("mean", 1.0 / cadence, force)
    }
}
