//! From a problem to a law: one file per family, and `choose` for problems that leave the family open.

mod choose;
mod demands;
mod double_harmonic;
pub mod easing;
mod harmonic;
mod polynomial;
mod program;
mod spline;
mod spline_program;
mod spline_spans;
mod touching;

use choose::Simpler;
pub use spline::{SpanKey, at_own_size, stopped_at_noise};
pub use spline_program::{Objective, ObjectiveKey};

use std::collections::HashMap;

use super::design::method::Method;
use super::design::parameters::Functions;
use super::design::proof::{self, Doubt};
use super::design::{Binding, Easing, Minimised, SolverReport, Tier};
use super::limits::NonconvexLimits;
use super::qp::{Basis, Certificate, Failure, Program, Row, Solution};
use super::search::Search;
use crate::error::Error;
use crate::law::Law;
use crate::problem::Problem;
use crate::scene::{Family, Minimise};
use touching::Optimum;

/// A law with how it was found, before it has a cam.
#[derive(Clone)]
pub struct SolvedLaw {
    /// The law, its zero where the family puts it.
    pub law: Law,
    /// Family that answered.
    pub family: Family,
    /// Degree of its polynomials as users name it.
    pub degree: usize,
    /// The functions that the coefficients belong to.
    pub functions: Functions,
    /// Parameters as `summary.json` lists them.
    pub coefficients: Vec<f64>,
    /// Limits that shape it.
    pub binding: Vec<Binding>,
    /// What relaxing them would buy.
    pub easing: Vec<Easing>,
    /// How it was found.
    pub solver: SolverReport,
}

impl SolvedLaw {
    /// A law that no limit shapes.
    fn unlimited(
        law: Law,
        family: Family,
        (functions, coefficients): (Functions, Vec<f64>),
        solver: SolverReport,
    ) -> SolvedLaw {
        SolvedLaw {
            law,
            family,
            degree: 0,
            functions,
            coefficients,
            binding: Vec::new(),
            easing: Vec::new(),
            solver,
        }
    }
}

/// Why a problem has no law.
#[allow(clippy::large_enum_variant)] // a fault ends the run
pub enum NoLaw {
    /// The input is at fault.
    Fault(Error),
    /// No law keeps the demands and the limits.
    Refused(Box<Refusal>),
}

/// A program without solution.
pub struct Refusal {
    /// The program.
    pub program: Program,
    /// How the solver ended.
    pub failure: Failure,
    /// The nonconvex limits, where the program has a solution that breaks them and none was found that does not.
    pub nonconvex: Option<NonconvexLimits>,
}

impl Refusal {
    /// A convex program without solution.
    fn of(program: Program, failure: Failure) -> Box<Refusal> {
        Box::new(Refusal {
            program,
            failure,
            nonconvex: None,
        })
    }

    /// Family of the laws that it refuses.
    pub fn family(&self) -> Family {
        family_of(&self.program.basis)
    }
}

/// Family of the laws over these functions.
fn family_of(basis: &Basis) -> Family {
    match basis {
        Basis::Spline { .. } => Family::Spline,
        Basis::Harmonic { .. } => Family::Harmonic,
    }
}

impl From<Error> for NoLaw {
    fn from(error: Error) -> Self {
        NoLaw::Fault(error)
    }
}

impl From<Box<Refusal>> for NoLaw {
    fn from(refusal: Box<Refusal>) -> Self {
        NoLaw::Refused(refusal)
    }
}

/// The law of the problem's family; a spline where the family is open and no simpler one passes every check.
pub fn law(problem: &Problem, search: &Search) -> Result<SolvedLaw, NoLaw> {
    let passed_over = match problem.law.family {
        Family::Polynomial => return polynomial::law(problem, search),
        Family::Harmonic => return harmonic::law(problem, search),
        Family::Program => return program::law(problem, search),
        Family::DoubleHarmonic => return double_harmonic::law(problem, search),
        Family::Spline => Vec::new(),
        Family::Auto | Family::Ladder => match choose::simpler(problem, search)? {
            Simpler::Passes(law) => return Ok(*law),
            Simpler::Missed(passed_over) => passed_over,
        },
    };
    let mut law = spline::law(problem, search)?;
    law.solver.passed_over = passed_over;
    Ok(law)
}

fn report(tier: Tier, method: Method, iterations: usize) -> SolverReport {
    SolverReport {
        tier,
        method,
        passed_over: Vec::new(),
        iterations,
        certified: true,
        doubt: None,
        certificate: None,
        steps: Vec::new(),
    }
}

/// The law of a solved program: limits that shape it, what relaxing them would buy, and the proof.
fn solved(
    problem: &Problem,
    optimum: &Optimum,
    minimised: Minimise,
    pieces: usize,
    report: SolverReport,
    (certificate, doubt): (Certificate, Option<Doubt>),
) -> SolvedLaw {
    let (program, solution) = (&optimum.program, &optimum.solution);
    let mut easing = easing::easings(program, solution, minimised);
    let of_force = |e: &&mut Easing| e.objective == Minimised::RmsError;
    for easing in easing.iter_mut().filter(of_force) {
        if problem.is_weighed() {
            easing.objective = Minimised::WeightedRmsError;
        }
    }
    let functions = Functions::of(&program.basis);
    SolvedLaw {
        binding: gathered(program, solution, pieces),
        easing,
        ..SolvedLaw::unlimited(
            optimum.law(),
            family_of(&program.basis),
            (functions, solution.x.clone()),
            proved(report, certificate, doubt),
        )
    }
}

/// The report with its evidence, certified where that is a proof and nothing else is in doubt.
fn proved(report: SolverReport, certificate: Certificate, doubt: Option<Doubt>) -> SolverReport {
    let doubt = doubt.or_else(|| proof::doubt(&certificate));
    SolverReport {
        certified: doubt.is_none(),
        doubt,
        certificate: Some(certificate),
        ..report
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
        let multiplier = row.multiplier / limit.map_or(1.0, |l| l.meaning.slope(l.bound));
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
