//! Cross-validation of cams: force errors of new walkers. All cycles of a walker are left out together.

use std::collections::BTreeMap;

use super::people::People;
use super::served::served_by;
use crate::error::Result;
use crate::force::{ForceCurve, Population, Walker};
use crate::scene::Scene;
use crate::synth::Search;

/// Number of folds of the cross-validation.
const PARTS: usize = 5;
/// Minimum number of walkers for whom a cam is designed in the cross-validation.
const FEWEST: usize = 4;

/// Result of the cross-validation for one number of cams and one number of walkers. It contains the errors of the walkers for whom the cams
/// were designed, and the errors of new walkers.
///
/// ```
/// use gaitcam::synth::Search;
/// use gaitcam::{cover, scene};
///
/// // In each fold, two of the ten walkers are left out. Their errors estimate the error of a new walker.
/// let scene = scene::built_in("footbridge")?.scene()?.with("gait.step_frequency", "1.5 Hz:2.3 Hz:10")?;
/// let walkers = scene.model_force()?.unwrap();
/// let folds = cover::folds(&scene, &walkers, 1, &Search::default())?;
/// assert!(folds.iter().any(|fold| fold.cams == 1 && fold.walkers == 8));
/// assert!(folds.iter().all(|fold| fold.out_mean <= fold.out_worst));
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Fold {
    /// Number of cams in the set.
    pub cams: usize,
    /// Number of walkers for whom the cams were designed.
    pub walkers: usize,
    /// Mean RMS force error of these walkers, in percent of each mean force or in newtons, as `law.error` of the scene specifies.
    pub in_mean: f64,
    /// Maximum RMS force error of these walkers, in the same unit.
    pub in_worst: f64,
    /// Mean RMS force error of the new walkers, each with the best cam, in the same unit.
    pub out_mean: f64,
    /// Maximum RMS force error of the new walkers, in the same unit.
    pub out_worst: f64,
}

/// Accumulates the mean and the maximum of errors.
#[derive(Default, Clone, Copy)]
struct Errors {
    count: f64,
    sum: f64,
    worst: f64,
}

impl Errors {
    fn add(&mut self, error: f64) {
        self.count += 1.0;
        self.sum += error;
        self.worst = self.worst.max(error);
    }

    fn mean(self) -> f64 {
        self.sum / self.count.max(1.0)
    }
}

/// Errors for the walkers of the design and for new walkers, by five-fold cross-validation. The number of cams is 1 to k, and the number of
/// walkers of the design increases. The result is empty for fewer than ten walkers, or if the search is stopped.
///
/// # Errors
///
/// The errors of [`covers`](super::covers).
pub fn folds(scene: &Scene, force: &ForceCurve, cams: usize, search: &Search) -> Result<Vec<Fold>> {
    let Some(population) = force.population.as_deref() else {
        return Ok(Vec::new());
    };
    let names = shuffled(population);
    if names.len() < 2 * PARTS {
        return Ok(Vec::new());
    }
    let mut out: BTreeMap<(usize, usize), [Errors; 2]> = BTreeMap::new();
    let rest = names.len() - names.len().div_ceil(PARTS);
    let sizes = [rest / 8, rest / 4, rest / 2, rest];
    for part in 0..PARTS {
        let (left, kept): (Vec<_>, Vec<_>) = (0..names.len()).partition(|i| i % PARTS == part);
        let of = |places: &[usize]| {
            walkers(
                population,
                &places.iter().map(|i| names[*i]).collect::<Vec<_>>(),
            )
        };
        let others = ForceCurve::of_walkers(of(&left))?;
        for size in sizes.into_iter().filter(|s| *s >= FEWEST) {
            if search.halt.is_asked() {
                return Ok(Vec::new());
            }
            let known = ForceCurve::of_walkers(of(&kept[..size]))?;
            let Some(known) = known.population.as_deref() else {
                continue;
            };
            let people = People::of(scene, known, search)?;
            for cover in people.covers(cams)? {
                let errors = out.entry((cover.cams.len(), size)).or_default();
                cover
                    .each
                    .iter()
                    .for_each(|a| errors[0].add(a.error.measured(scene.law.error)));
                let each = served_by(&cover.scene, &cover.cams, &others)?;
                each.iter()
                    .for_each(|a| errors[1].add(a.error.measured(scene.law.error)));
            }
        }
    }
    let row = |((cams, walkers), [own, other]): ((usize, usize), [Errors; 2])| Fold {
        cams,
        walkers,
        in_mean: own.mean(),
        in_worst: own.worst,
        out_mean: other.mean(),
        out_worst: other.worst,
    };
    Ok(out.into_iter().map(row).collect())
}

/// Walkers with the given names, with all their cycles.
fn walkers(population: &Population, names: &[&str]) -> Vec<Walker> {
    let own = population
        .walkers
        .iter()
        .filter(|w| names.contains(&w.name.as_str()));
    own.cloned().collect()
}

/// Names of all walkers in a fixed pseudo-random order.
fn shuffled(population: &Population) -> Vec<&str> {
    let mut names: Vec<&str> = population.walkers.iter().map(|w| w.name.as_str()).collect();
    names.sort_unstable();
    names.dedup();
    let mut state = 1_u64;
    for i in (1..names.len()).rev() {
        // Knuth's linear congruential generator.
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        names.swap(i, (state >> 33) as usize % (i + 1));
    }
    names
}
