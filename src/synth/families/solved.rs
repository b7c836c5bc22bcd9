//! A law with the method of its solution, its active limits, and the gain from relaxing them.

use std::collections::HashMap;

use crate::cam::PrimeCircle;
use crate::law::Law;
use crate::problem::Problem;
use crate::scene::{Family, Minimise};
use crate::synth::optimum::{ForcePrice, Optimum, easing, force_price};
use crate::synth::qp::{OFFSET, Program, RISE, Row, Solution};
use crate::synth::report::limited::{Binding, Easing, Minimised};
use crate::synth::report::parameters::Functions;
use crate::synth::report::solver::SolverReport;

/// A law with the method of its solution, before the cam is determined.
#[derive(Clone)]
pub struct SolvedLaw {
    /// The law as computed for its family, before its minimum is shifted to the base circle.
    pub law: Law,
    /// Family of the law.
    pub family: Family,
    /// Degree of the polynomials for display; 0 for laws without polynomials.
    pub degree: usize,
    /// Sufficient number of spans of a spline without the dwells; 0 for other families.
    pub spans: usize,
    /// Basis functions to which the coefficients belong.
    pub functions: Functions,
    /// Parameters of the law, as in `summary.json`.
    pub coefficients: Vec<f64>,
    /// Prime circle and offset at the optimum, if they are variables of the program.
    pub circle: Option<PrimeCircle>,
    /// Active limits, with their multipliers.
    pub binding: Vec<Binding>,
    /// First-order gain from relaxing each active limit by 1 %.
    pub easing: Vec<Easing>,
    /// Report on the method of the solution and its certificate.
    pub solver: SolverReport,
    /// Derivative of the Lagrangian with respect to the force.
    pub price: ForcePrice,
}

/// Law of a solved program, with its active limits and the gains from relaxing them.
pub fn solved_law(
    problem: &Problem,
    optimum: &Optimum,
    family: Family,
    minimised: Minimise,
    solver: SolverReport,
) -> SolvedLaw {
    let program = &optimum.formulation.program;
    let solution = &force_price::on_floor(problem, &optimum.solution);
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
        price: ForcePrice::of(problem, optimum, solution),
    }
}

/// Prime circle and offset, m, of a solution.
fn circle(solution: &Solution) -> PrimeCircle {
    let offset = solution.extra[OFFSET];
    PrimeCircle {
        radius: libm::hypot(solution.extra[RISE], offset),
        offset,
    }
}

/// Fraction of the maximum multiplier of a limit, below which a row of this limit counts as inactive. Such small multipliers are rounding
/// errors of the interior-point method.
const BINDS: f64 = 1e-6;

/// Active limits for display. Active rows of one limit within half a span are combined.
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
