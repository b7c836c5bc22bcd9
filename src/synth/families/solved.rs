//! A law with how it was found: the limits that shape it, and what relaxing them would buy.

use std::collections::HashMap;

use crate::cam::PrimeCircle;
use crate::law::Law;
use crate::problem::Problem;
use crate::scene::{Family, Minimise};
use crate::synth::optimum::{Optimum, easing};
use crate::synth::qp::{OFFSET, Program, RISE, Row, Solution};
use crate::synth::report::limited::{Binding, Easing, Minimised};
use crate::synth::report::parameters::Functions;
use crate::synth::report::solver::SolverReport;

/// A law with how it was found, before it has a cam.
#[derive(Clone)]
pub struct SolvedLaw {
    /// The law, its zero where the family puts it.
    pub law: Law,
    /// Family that answered.
    pub family: Family,
    /// Degree of its polynomials as users name it.
    pub degree: usize,
    /// Spans, without dwells, that are enough for a spline; 0 of another family.
    pub spans: usize,
    /// The functions that the coefficients belong to.
    pub functions: Functions,
    /// Parameters as `summary.json` lists them.
    pub coefficients: Vec<f64>,
    /// Prime circle and offset on which the program found it, where they are among its variables.
    pub circle: Option<PrimeCircle>,
    /// Limits that shape it.
    pub binding: Vec<Binding>,
    /// What relaxing them would buy.
    pub easing: Vec<Easing>,
    /// How it was found.
    pub solver: SolverReport,
}

/// The law of a solved program.
pub fn solved_law(
    problem: &Problem,
    optimum: &Optimum,
    family: Family,
    minimised: Minimise,
    solver: SolverReport,
) -> SolvedLaw {
    let (program, solution) = (&optimum.formulation.program, &optimum.solution);
    let binding = gathered(program, solution, optimum.formulation.pieces);
    let mut easing = easing::easings(program, solution, minimised);
    let of_force = |e: &&mut Easing| e.objective == Minimised::RmsError;
    for easing in easing.iter_mut().filter(of_force) {
        if problem.is_weighed() {
            easing.objective = Minimised::WeightedRmsError;
        }
    }
    SolvedLaw {
        law: optimum.law(),
        family,
        degree: 0,
        spans: 0,
        functions: Functions::of(&program.basis),
        coefficients: solution.x.clone(),
        circle: (!program.cones.is_empty()).then(|| circle(solution)),
        binding,
        easing,
        solver,
    }
}

/// The smallest prime circle of a solution's distance and offset.
fn circle(solution: &Solution) -> PrimeCircle {
    let offset = solution.extra[OFFSET];
    PrimeCircle {
        radius: solution.extra[RISE].hypot(offset),
        offset,
    }
}

/// Part of a limit's largest multiplier below which a row is what an interior point leaves of one that does not bind.
const BINDS: f64 = 1e-6;

/// Active rows as a user reads them: rows of one limit within half a piece are one contact.
fn gathered(program: &Program, solution: &Solution, pieces: usize) -> Vec<Binding> {
    let mut out: Vec<Binding> = Vec::new();
    let mut largest: HashMap<(Option<usize>, &str), f64> = HashMap::new();
    for row in &solution.active {
        let own = largest.entry((row.limit, row.name.name())).or_default();
        *own = own.max(row.multiplier);
    }
    let binds = |r: &&Row| r.multiplier > BINDS * largest[&(r.limit, r.name.name())];
    let mut rows: Vec<&Row> = solution.active.iter().filter(binds).collect();
    rows.sort_by(|a, b| {
        (a.limit, a.name.name(), a.peak.at)
            .partial_cmp(&(b.limit, b.name.name(), b.peak.at))
            .unwrap_or(std::cmp::Ordering::Equal)
    });
    let near = std::f64::consts::PI / pieces as f64;
    for row in rows {
        let limit = row.limit.map(|i| &program.limits[i]);
        let name = row.name;
        let rms = program.rms.iter().find(|l| l.is_tangent(row));
        let slope = (limit.map(|l| l.meaning.slope(l.bound)))
            .or_else(|| rms.map(|l| l.meaning.slope(l.most)));
        let multiplier = row.multiplier / slope.unwrap_or(1.0);
        match out.last_mut() {
            Some(last) if last.limit == name && (row.peak.at - last.at).abs() < near => {
                let both = last.multiplier + multiplier;
                last.at = (last.at * last.multiplier + row.peak.at * multiplier) / both;
                last.multiplier = both;
            }
            _ => out.push(Binding {
                limit: name,
                multiplier,
                at: row.peak.at,
            }),
        }
    }
    out
}
