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

pub use spline::{SpanKey, at_own_size, stopped_at_noise};
pub use spline_program::{Objective, ObjectiveKey};

use std::collections::HashMap;

use super::design::method::Method;
use super::design::parameters::Functions;
use super::design::proof::{self, Doubt};
use super::design::{Binding, Easing, SolverReport, Tier};
use super::limits::NonconvexLimits;
use super::qp::{Basis, Certificate, Failure, Program, Row, Solution};
use super::search::Search;
use crate::error::Error;
use crate::law::Law;
use crate::problem::Problem;
use crate::scene::Family;

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
        match self.program.basis {
            Basis::Spline { .. } => Family::Spline,
            Basis::Harmonic { .. } => Family::Harmonic,
        }
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

/// How a family answers a problem.
type FamilyLaw = fn(&Problem, &Search) -> Result<SolvedLaw, NoLaw>;

/// The law of the problem's family, or of the family that suits it.
pub fn law(problem: &Problem, search: &Search) -> Result<SolvedLaw, NoLaw> {
    match problem.law.family {
        Family::Spline => spline::law(problem, search),
        Family::Auto => choose::simplest(problem, search),
        Family::Ladder => choose::ladder(problem, search),
        Family::Polynomial => polynomial::law(problem, search),
        Family::Harmonic => harmonic::law(problem, search),
        Family::Program => program::law(problem, search),
        Family::DoubleHarmonic => double_harmonic::law(problem, search),
    }
}

/// Where nothing fixes the lift, the lowest point of the law stands on the base circle.
pub fn on_base_circle(problem: &Problem, search: &Search, law: &Law) -> Law {
    if problem.level_is_known() {
        return law.clone();
    }
    (search.cache.raised).get(law.clone(), |law| law.raised(-law.extremes(0).0.value))
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
