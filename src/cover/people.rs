//! Walkers of a population, their individual cams, and the cam of any group of walkers.

use std::collections::HashMap;

use crate::error::Result;
use crate::force::{ForceCurve, Population, Walker};
use crate::problem::Problem;
use crate::scene::{ErrorMeasure, Robust, Scene};
use crate::synth::population::{alone::Point, hold};
use crate::synth::{Design, Search, design};

/// Walkers of a population, with the common cam and the individual cams.
pub struct People<'a> {
    /// Scene with the family and size of the law of the common cam.
    pub scene: Scene,
    pub population: &'a Population,
    pub problem: Problem,
    pub search: &'a Search,
    /// Indices of the cycles of each walker.
    pub cycles: Vec<Vec<usize>>,
    pub shares: Vec<f64>,
    /// The common cam of all walkers.
    pub one: Design,
    /// Force of the individual cam of each cycle, with its mean square error and an error bound. The list is empty if no lower bound is
    /// required.
    pub points: Vec<Point>,
}

impl<'a> People<'a> {
    pub fn of(scene: &Scene, population: &'a Population, search: &'a Search) -> Result<Self> {
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
        let one = design(&Problem::resolve(scene, Some(&force))?, search)?;
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

    fn force(&self, group: &[usize]) -> Result<ForceCurve> {
        let cycles = group.iter().flat_map(|w| &self.cycles[*w]);
        let walkers: Vec<Walker> = cycles
            .map(|i| self.population.walkers[*i].clone())
            .collect();
        ForceCurve::of_walkers(walkers)
    }

    /// Designs the cam of a group of walkers with the given objective.
    pub fn cam(&self, group: &[usize], objective: Robust) -> Result<Design> {
        let mut scene = self.scene.clone();
        scene.law.robust = objective;
        let problem = Problem::resolve(&scene, Some(&self.force(group)?))?;
        design(&problem, self.search)
    }

    /// Factor that converts the root of a mean square error to percent or to newtons.
    pub fn unit(&self) -> f64 {
        match self.scene.law.error {
            ErrorMeasure::Relative => 100.0,
            ErrorMeasure::Absolute => self.problem.target_mean(),
        }
    }
}

/// Scene with the family and size of the law taken from a design.
fn of_size(scene: &Scene, design: &Design) -> Scene {
    let mut out = scene.clone();
    hold(
        &mut out.law,
        design.family,
        &design.cam.law,
        design.coefficients.len(),
    );
    out
}
