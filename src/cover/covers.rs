//! Sets of 1 to k cams for many walkers, with lower bounds of their errors.

use super::alternation::{Columns, Trial};
use super::bound;
use super::people::People;
use super::served::{Assigned, Under, one_walker};
use crate::error::Result;
use crate::force::ForceCurve;
use crate::scene::{Robust, Scene};
use crate::synth::population::alone::points;
use crate::synth::population::errors::{in_tail, tail};
use crate::synth::{Design, Search};

/// A set of cams, and the assignment of the walkers to them.
///
/// ```
/// use gaitcam::synth::Search;
/// use gaitcam::{cover, scene};
///
/// // With two cams instead of one, the maximum error decreases by more than a quarter.
/// let scene = scene::built_in("footbridge")?.scene()?.with("gait.step_frequency", "1.4 Hz:2.4 Hz:11")?;
/// let scene = scene.with("law.robust", "worst")?;
/// let walkers = scene.model_force()?.unwrap();
/// let covers = cover::covers(&scene, &walkers, 2, &Search::default())?;
/// assert!(covers[1].worst < 0.75 * covers[0].worst);
/// assert!(covers[1].bound.unwrap() <= covers[1].worst);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Cover {
    /// Scene with the common family and size of the laws.
    pub scene: Scene,
    /// The cams, each designed for its own walkers.
    pub cams: Vec<Design>,
    /// Assigned cam and errors of each cycle.
    pub each: Vec<Assigned>,
    /// Weighted mean of the RMS force errors. This value and the following ones are in percent of each walker's mean force or in newtons, as
    /// `law.error` of the scene specifies.
    pub mean: f64,
    /// Maximum RMS force error of a cycle.
    pub worst: f64,
    /// Minimised quantity: the maximum error, or the root mean square error over all walkers or over the worst ones.
    pub objective: f64,
    /// Lower bound of the objective for this number of cams of this family and size; `None` for non-convex limits.
    pub bound: Option<f64>,
}

/// Designs a set of cams for each number of cams from 1 to k, and assigns the walkers to the cams. There is at most one cam per walker. Every cam has
/// the family and size of the common cam's law.
///
/// # Errors
///
/// Errors of the design of a cam. The force belongs to a single walker.
pub fn covers(
    scene: &Scene,
    force: &ForceCurve,
    cams: usize,
    search: &Search,
) -> Result<Vec<Cover>> {
    let Some(population) = force.population.as_deref().filter(|p| p.count() > 1) else {
        return Err(one_walker());
    };
    let mut people = People::of(scene, population, search)?;
    people.points = bound::compressed(points(&people.problem, search)?);
    people.covers(cams)
}

impl People<'_> {
    pub fn covers(&self, cams: usize) -> Result<Vec<Cover>> {
        let mut columns = Columns::new();
        let mut out: Vec<(Vec<usize>, Cover)> = Vec::new();
        for count in 1..=cams.min(self.cycles.len()) {
            let best = match out.last() {
                None => self.alternated(vec![0; self.cycles.len()], 1, &mut columns)?,
                Some((owner, cover)) => self.best_of(count, owner, &cover.each, &mut columns)?,
            };
            out.push((best.owner.clone(), self.cover(&best, count)?));
            if self.search.halt.is_asked() {
                break;
            }
        }
        let mut out: Vec<Cover> = out.into_iter().map(|c| c.1).collect();
        // A lower bound for k cams is also a lower bound for fewer cams.
        let mut least = 0.0_f64;
        for cover in out.iter_mut().rev() {
            cover.bound = cover.bound.map(|b| b.max(least));
            least = cover.bound.unwrap_or_default();
        }
        Ok(out)
    }

    /// Set of the `count` cams of a trial, with the errors of all cycles.
    fn cover(&self, trial: &Trial, count: usize) -> Result<Cover> {
        let mut each: Vec<Option<Assigned>> = vec![None; self.shares.len()];
        let mut cams = Vec::new();
        for cam in 0..count {
            let of = |w: &usize| trial.owner[*w] == cam;
            let group: Vec<usize> = (0..trial.owner.len()).filter(of).collect();
            let design = self.cam(&group, trial.objectives[cam])?;
            let own = Under::of(&self.problem, &design)?.assigned(cam);
            for i in group.iter().flat_map(|w| &self.cycles[*w]) {
                each[*i] = Some(own[*i].clone());
            }
            cams.push(design);
        }
        let each: Vec<Assigned> = each.into_iter().flatten().collect();
        let errors = each.iter().map(|a| a.error.measured(self.scene.law.error));
        let both = errors.clone().zip(&self.shares);
        let unit = self.unit();
        Ok(Cover {
            scene: self.scene.clone(),
            cams,
            mean: both.map(|(e, share)| e * share).sum(),
            worst: errors.fold(0.0, f64::max),
            objective: unit * trial.value.1.sqrt(),
            bound: self.bound(count, trial).map(|square| unit * square.sqrt()),
            each,
        })
    }

    /// Lower bound of the square of the objective: the mean square error over all walkers or over the worst walkers, or the maximum mean square
    /// error. For one cam, the certificate of its design can raise the bound.
    fn bound(&self, cams: usize, trial: &Trial) -> Option<f64> {
        if self.points.is_empty() {
            return None;
        }
        let square = match self.scene.law.robust {
            Robust::Mean => bound::mean(&self.points, &self.shares, cams),
            Robust::Worst => bound::worst(&self.points, cams),
            Robust::Tail(part) => {
                let worst = in_tail(part, &trial.squares, &self.shares);
                let least: Vec<f64> = self.points.iter().map(|p| p.least).collect();
                let bound = bound::tail(&self.points, part, &self.shares, cams, &worst);
                bound.max(tail(part, &least, &self.shares))
            }
        };
        let is_proved = cams == 1 && self.one.solver.certified;
        let own = self.one.population.as_ref().filter(|_| is_proved);
        let of_one = own.map_or(0.0, |p| trial.value.1 * (1.0 - p.gap));
        Some(square.max(of_one))
    }
}
