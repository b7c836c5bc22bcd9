//! Several cams for many walkers: which cams, and who is served by which.
//!
//! Cams and walkers are sought in turn from several starts: every cam is the design for its walkers, then every walker goes to
//! the cam that serves him best, until nobody changes (Lloyd, 1982). Where the worst part of all walkers counts, every cam counts
//! of its own walkers the part that belongs to it. What is found need not be the best; [`super::bound`] says how far it can be
//! from it.

use std::collections::HashMap;

use super::alternation::{Columns, Trial};
use super::bound::{self, Point};
use super::errors::{Aim, Nodes, in_tail, tail};
use super::served::{Assigned, Under, one_walker};
use super::{bare, gap, hold, limits, phase, weighed};
use crate::error::Result;
use crate::force::{ForceCurve, Population, Walker};
use crate::problem::{Problem, Walkers};
use crate::scene::{ErrorMeasure, Family, Robust, Scene};
use crate::synth::design::{Design, Tier};
use crate::synth::families;
use crate::synth::search::Search;

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
/// assert!(covers[1].worst < 0.75 * covers[0].worst);
/// assert!(covers[1].bound.unwrap() <= covers[1].worst);
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
    /// Mean of the RMS force errors, by weight: in percent of each walker's mean force, or in newtons, as the scene's `law.error`
    /// says, like all that follows.
    pub mean: f64,
    /// Largest of them.
    pub worst: f64,
    /// What is minimised: the worst error, or the root of the mean square of all or of the worst part.
    pub objective: f64,
    /// No cams of this number and kind have a smaller objective; `None` where limits are not convex.
    pub bound: Option<f64>,
}

/// The covers of 1 to so many cams, as many as there are walkers at most. Every cam has the family and size of law that the scene
/// gives the cam of all.
///
/// # Errors
/// As of one cam; a force of one walker.
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
    people.points = bound::compressed(people.points_of_all()?);
    people.covers(cams)
}

/// Walkers, and what they would have alone.
pub(super) struct People<'a> {
    /// The scene with the law's family and size.
    pub(super) scene: Scene,
    pub(super) population: &'a Population,
    pub(super) problem: Problem,
    pub(super) search: &'a Search,
    /// Cycles of each walker.
    pub(super) cycles: Vec<Vec<usize>>,
    pub(super) shares: Vec<f64>,
    /// The cam for all.
    one: Design,
    /// The cam of each cycle alone; empty where no bound is sought.
    pub(super) points: Vec<Point>,
}

impl<'a> People<'a> {
    pub(super) fn of(
        scene: &Scene,
        population: &'a Population,
        search: &'a Search,
    ) -> Result<Self> {
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
        let mut columns = Columns::new();
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
            cover.bound = cover.bound.map(|b| b.max(least));
            least = cover.bound.unwrap_or_default();
        }
        Ok(out)
    }

    fn force(&self, group: &[usize]) -> Result<ForceCurve> {
        let cycles = group.iter().flat_map(|w| &self.cycles[*w]);
        let walkers: Vec<Walker> = cycles
            .map(|i| self.population.walkers[*i].clone())
            .collect();
        ForceCurve::of_walkers(walkers)
    }

    /// The cam of some walkers.
    pub(super) fn cam(&self, group: &[usize], objective: Robust) -> Result<Design> {
        let mut scene = self.scene.clone();
        scene.law.robust = objective;
        let problem = Problem::resolve(&scene, Some(&self.force(group)?))?;
        crate::synth::design(&problem, self.search)
    }

    /// The cover of a trial.
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

    /// What the root of a mean square counts as: percent, or newtons.
    fn unit(&self) -> f64 {
        match self.scene.law.error {
            ErrorMeasure::Relative => 100.0,
            ErrorMeasure::Absolute => self.problem.target_mean(),
        }
    }

    /// The mean square that no such cams beat; the cam of all has a proof of its own.
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
