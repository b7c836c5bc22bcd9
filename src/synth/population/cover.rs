//! Several cams for many walkers: which cams, and who is served by which.
//!
//! Cams and walkers are sought in turn from several starts: every cam is the design for its walkers, then every walker goes to
//! the cam that serves him best, until nobody changes (Lloyd, 1982). What is found need not be the best; [`super::bound`] says
//! how far it can be from it.

use std::collections::HashMap;

use super::bound::{self, Point};
use super::errors::{Aim, Nodes, measure};
use super::served::{Assigned, Under, one_walker};
use super::{bare, gap, hold, limits, phase, weighed};
use crate::error::{Placed, Result, SynthError};
use crate::force::{ForceCurve, Population, Walker};
use crate::problem::{Problem, Walkers};
use crate::scene::{Family, Robust, Scene};
use crate::synth::design::{Design, Tier};
use crate::synth::families;
use crate::synth::search::Search;

/// Turns of cams and walkers at most.
const TURNS: usize = 30;
/// Starts from walkers who are far from each other, beside that from the cams one fewer.
const STARTS: usize = 3;

/// So many cams with the walkers whom they serve.
///
/// ```
/// use gaitcam::{scene, synth};
///
/// // Two cams share the cadences of a model: the worst error falls by a quarter.
/// let scene = scene::built_in("footbridge")?.scene()?.with("gait.step_frequency", "1.4 Hz:2.4 Hz:11")?;
/// let scene = scene.with("law.robust", "worst")?;
/// let walkers = scene.model_force()?.unwrap();
/// let covers = synth::covers(&scene, &walkers, 2, &synth::Search::default())?;
/// assert!(covers[1].worst_percent < 0.75 * covers[0].worst_percent);
/// assert!(covers[1].bound_percent.unwrap() <= covers[1].worst_percent);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Cover {
    /// The scene with the family and size of law that every cam has.
    pub scene: Scene,
    /// The cams; the design of each is for its own walkers.
    pub cams: Vec<Design>,
    /// Who is served by which, cycle by cycle.
    pub each: Vec<Assigned>,
    /// Mean of the RMS force errors, by weight.
    pub mean_percent: f64,
    /// Largest of them.
    pub worst_percent: f64,
    /// No cams of this number and kind have a smaller objective: the worst error, or the root of the mean square; `None`
    /// where limits are not convex.
    pub bound_percent: Option<f64>,
}

/// The covers of 1 to so many cams, as many as there are walkers at most. Every cam has the family and size of law that the scene
/// gives the cam of all.
///
/// # Errors
/// As of one cam; a force of one walker; an objective that does not belong to single walkers.
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
    people.points = people.points_of_all()?;
    people.covers(cams)
}

/// Walkers, and what they would have alone.
pub(super) struct People<'a> {
    /// The scene with the law's family and size.
    scene: Scene,
    population: &'a Population,
    problem: Problem,
    search: &'a Search,
    /// Cycles of each walker.
    cycles: Vec<Vec<usize>>,
    shares: Vec<f64>,
    /// The cam for all.
    one: Design,
    /// The cam of each cycle alone; empty where no bound is sought.
    points: Vec<Point>,
}

/// Cams with their walkers on the way.
struct Trial {
    /// Cam of each walker.
    owner: Vec<usize>,
    /// Mean square error of each cycle under its cam.
    squares: Vec<f64>,
    /// Cams without a law under their limits, and the objective.
    value: (usize, f64),
}

/// The errors of all cycles under a cam; whether it keeps its limits.
type Column = (bool, Vec<f64>);

impl<'a> People<'a> {
    pub(super) fn of(
        scene: &Scene,
        population: &'a Population,
        search: &'a Search,
    ) -> Result<Self> {
        if let Robust::Tail(_) = scene.law.robust {
            return Err(SynthError::NotOfCover.at_key("law.robust"));
        }
        let all = population.walkers.clone();
        let mut places: HashMap<&str, usize> = HashMap::new();
        let mut cycles: Vec<Vec<usize>> = Vec::new();
        for (i, walker) in population.walkers.iter().enumerate() {
            let place = *places.entry(&walker.name).or_insert(cycles.len());
            if place == cycles.len() {
                cycles.push(Vec::new());
            }
            cycles[place].push(i);
        }
        let force = ForceCurve::of_walkers(all)?;
        let one = crate::synth::design(&Problem::resolve(scene, Some(&force))?, search)?;
        let scene = of_size(scene, &one);
        Ok(People {
            problem: Problem::resolve(&scene, Some(&force))?,
            shares: population.shares.clone(),
            points: Vec::new(),
            scene,
            population,
            search,
            cycles,
            one,
        })
    }

    pub(super) fn covers(&self, cams: usize) -> Result<Vec<Cover>> {
        let mut columns = HashMap::new();
        let mut out: Vec<(Vec<usize>, Cover)> = Vec::new();
        for count in 1..=cams.min(self.cycles.len()) {
            let best = match out.last() {
                None => self.alternated(vec![0; self.cycles.len()], 1, &mut columns)?,
                Some((owner, cover)) => self.best_of(count, owner, cover, &mut columns)?,
            };
            out.push((best.owner.clone(), self.cover(&best, count)?));
            if self.search.halt.is_asked() {
                break;
            }
        }
        let mut out: Vec<Cover> = out.into_iter().map(|c| c.1).collect();
        // What so many cams cannot do, fewer cannot.
        let mut least = 0.0_f64;
        for cover in out.iter_mut().rev() {
            cover.bound_percent = cover.bound_percent.map(|b| b.max(least));
            least = cover.bound_percent.unwrap_or_default();
        }
        Ok(out)
    }

    /// The best of all starts.
    fn best_of(
        &self,
        count: usize,
        owner: &[usize],
        before: &Cover,
        columns: &mut HashMap<Vec<usize>, Column>,
    ) -> Result<Trial> {
        let error = |w: &usize| {
            let each = self.cycles[*w]
                .iter()
                .map(|i| before.each[*i].error.rms_error_percent);
            each.fold(0.0, f64::max)
        };
        let split = filled(owner.to_vec(), count, &|w, _| error(&w));
        let badly = split.iter().position(|cam| *cam == count - 1);
        let badly = badly.unwrap_or_default();
        let mut best = self.alternated(split, count, columns)?;
        let starts = if self.points.is_empty() { 0 } else { STARTS };
        for start in 0..starts {
            let first = (badly + start * owner.len() / STARTS) % owner.len();
            let trial = self.alternated(self.far_apart(first, count), count, columns)?;
            if trial.value < best.value {
                best = trial;
            }
        }
        Ok(best)
    }

    /// Every walker with the nearest of walkers who are far from each other.
    fn far_apart(&self, first: usize, count: usize) -> Vec<usize> {
        let own = |w: usize| &self.points[self.cycles[w][0]];
        let distance = |a: usize, b: usize| {
            let off = own(a)
                .at
                .iter()
                .zip(&own(b).at)
                .map(|(x, y)| (x - y).powi(2));
            own(b).scale.powi(2) * off.sum::<f64>()
        };
        let mut owner = vec![0; self.cycles.len()];
        let mut nearest: Vec<f64> = (0..owner.len()).map(|w| distance(first, w)).collect();
        for cam in 1..count {
            let next = (0..owner.len()).max_by(|a, b| nearest[*a].total_cmp(&nearest[*b]));
            let next = next.unwrap_or(first);
            for w in 0..owner.len() {
                let own = distance(next, w);
                if own < nearest[w] || w == next {
                    (nearest[w], owner[w]) = (own, cam);
                }
            }
        }
        // Walkers alike are no seeds of their own.
        filled(owner, count, &|_, _| 0.0)
    }

    /// Cams and walkers in turn.
    fn alternated(
        &self,
        mut owner: Vec<usize>,
        count: usize,
        columns: &mut HashMap<Vec<usize>, Column>,
    ) -> Result<Trial> {
        let mut best: Option<Trial> = None;
        for _ in 0..TURNS {
            let mut of_cams: Vec<Column> = Vec::new();
            for cam in 0..count {
                let group: Vec<usize> = (0..owner.len()).filter(|w| owner[*w] == cam).collect();
                if !columns.contains_key(&group) {
                    let design = self.cam(&group)?;
                    let errors = Under::of(&self.problem, &design)?.squares;
                    columns.insert(group.clone(), (design.infeasible.is_none(), errors));
                }
                of_cams.push(columns[&group].clone());
            }
            let mut squares = vec![0.0; self.shares.len()];
            for (walker, cam) in owner.iter().enumerate() {
                self.cycles[walker]
                    .iter()
                    .for_each(|i| squares[*i] = of_cams[*cam].1[*i]);
            }
            let impossible = of_cams.iter().filter(|c| !c.0).count();
            let value = (
                impossible,
                measure(self.scene.law.robust, &squares, &self.shares),
            );
            if best.as_ref().is_none_or(|b| value < b.value) {
                best = Some(Trial {
                    owner: owner.clone(),
                    squares,
                    value,
                });
            }
            let next = self.nearest(&of_cams);
            if next == owner || self.search.halt.is_asked() {
                break;
            }
            owner = next;
        }
        best.ok_or_else(one_walker)
    }

    /// The cam that serves each walker best.
    fn nearest(&self, of_cams: &[Column]) -> Vec<usize> {
        let error = |walker: usize, cam: usize| {
            let each = self.cycles[walker]
                .iter()
                .map(|i| (of_cams[cam].1[*i], self.shares[*i]));
            match self.scene.law.robust {
                Robust::Worst => each.fold(0.0, |m: f64, e| m.max(e.0)),
                Robust::Mean | Robust::Tail(_) => each.map(|e| e.0 * e.1).sum(),
            }
        };
        let count = of_cams.len();
        let best = |w: usize| (0..count).min_by(|a, b| error(w, *a).total_cmp(&error(w, *b)));
        let owner: Vec<usize> = (0..self.cycles.len())
            .map(|w| best(w).unwrap_or_default())
            .collect();
        filled(owner, count, &error)
    }

    fn force(&self, group: &[usize]) -> Result<ForceCurve> {
        let cycles = group.iter().flat_map(|w| &self.cycles[*w]);
        let walkers: Vec<Walker> = cycles
            .map(|i| self.population.walkers[*i].clone())
            .collect();
        ForceCurve::of_walkers(walkers)
    }

    /// The cam of some walkers.
    fn cam(&self, group: &[usize]) -> Result<Design> {
        let problem = Problem::resolve(&self.scene, Some(&self.force(group)?))?;
        crate::synth::design(&problem, self.search)
    }

    /// The cover of a trial.
    fn cover(&self, trial: &Trial, count: usize) -> Result<Cover> {
        let mut each: Vec<Option<Assigned>> = vec![None; self.shares.len()];
        let mut cams = Vec::new();
        for cam in 0..count {
            let of = |w: &usize| trial.owner[*w] == cam;
            let group: Vec<usize> = (0..trial.owner.len()).filter(of).collect();
            let design = self.cam(&group)?;
            let own = Under::of(&self.problem, &design)?.assigned(cam);
            for i in group.iter().flat_map(|w| &self.cycles[*w]) {
                each[*i] = Some(own[*i].clone());
            }
            cams.push(design);
        }
        let errors = trial.squares.iter().map(|x| 100.0 * x.sqrt());
        let both = errors.clone().zip(&self.shares);
        Ok(Cover {
            scene: self.scene.clone(),
            cams,
            each: each.into_iter().flatten().collect(),
            mean_percent: both.map(|(e, share)| e * share).sum(),
            worst_percent: errors.fold(0.0, f64::max),
            bound_percent: self.bound(count, trial.value.1),
        })
    }

    /// Percent that no such cams beat; the cam of all has a proof of its own.
    fn bound(&self, cams: usize, value: f64) -> Option<f64> {
        if self.points.is_empty() {
            return None;
        }
        let square = match self.scene.law.robust {
            Robust::Mean => bound::mean(&self.points, &self.shares, cams),
            Robust::Worst | Robust::Tail(_) => bound::worst(&self.points, cams),
        };
        let is_proved = cams == 1 && self.one.solver.certified;
        let own = self.one.population.as_ref().filter(|_| is_proved);
        let of_one = own.map_or(0.0, |p| value * (1.0 - p.gap));
        Some(100.0 * square.max(of_one).sqrt())
    }

    /// The cam of each cycle alone; none where the sets of laws are not convex.
    fn points_of_all(&self) -> Result<Vec<Point>> {
        let problem = &self.problem;
        let Some(walkers) = problem.walkers.as_deref() else {
            return Ok(Vec::new());
        };
        if walkers.adjust.phase || problem.phase_is_free {
            let of = |aim: Aim| Point {
                at: aim.towards.iter().map(|y| y / aim.scale).collect(),
                slack: 0.0,
                scale: aim.scale,
                least: 0.0,
            };
            return Ok(phase::amplitudes_of(walkers).into_iter().map(of).collect());
        }
        let mut out = Vec::new();
        for walker in &walkers.each {
            let alone = Walkers {
                each: vec![walker.clone()],
                ..walkers.clone()
            };
            let mut limited = limits::for_all(&bare(problem), &alone, 1.0);
            // Of the machine of another walker they say nothing.
            limits::LOADS
                .into_iter()
                .for_each(|kind| limited.limits[kind] = None);
            let own = families::law(&weighed(&limited, &alone, &[1.0]), self.search);
            let Some(law) = own.ok().filter(|law| law.solver.tier != Tier::Scp) else {
                return Ok(Vec::new());
            };
            let nodes = Nodes::of(&law.law);
            let (aim, at) = (nodes.aim(walker), nodes.force(&problem.drive, &law.law));
            let gap = 2.0 * gap(&law);
            let least = (aim.square(&at) - aim.scale.powi(2) * gap).max(0.0);
            out.push(Point {
                at,
                slack: gap.sqrt(),
                scale: aim.scale,
                least,
            });
        }
        Ok(out)
    }
}

/// The same where every cam serves somebody: one that would serve nobody takes the walker who is served worst by a cam of several.
fn filled(mut owner: Vec<usize>, count: usize, error: &dyn Fn(usize, usize) -> f64) -> Vec<usize> {
    let size = |owner: &[usize], cam: usize| owner.iter().filter(|o| **o == cam).count();
    for cam in 0..count {
        if size(&owner, cam) == 0 {
            let own = |w: &usize| error(*w, owner[*w]);
            let free = (0..owner.len()).filter(|w| size(&owner, owner[*w]) > 1);
            let badly = free.max_by(|a, b| own(a).total_cmp(&own(b)));
            owner[badly.unwrap_or_default()] = cam;
        }
    }
    owner
}

/// The scene whose laws have family and size of a design.
fn of_size(scene: &Scene, design: &Design) -> Scene {
    let mut out = scene.clone();
    let family = Family::ALL.iter().find(|f| f.name() == design.family);
    let family = family.copied().unwrap_or(scene.law.family);
    hold(
        &mut out.law,
        family,
        &design.cam.law,
        design.coefficients.len(),
    );
    out
}
