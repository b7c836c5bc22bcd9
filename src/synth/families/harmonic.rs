//! Harmonic family: the spectral inverse (theory §1), or a convex program if the inverse violates a limit.

use super::formulation;
use super::inverse::invert;
use super::solved::{SolvedLaw, solved_law};
use crate::error::{Error, Placed, Result, SynthError};
use crate::problem::Problem;
use crate::scene::{Family, Minimise};
use crate::synth::optimum::{self, ForcePrice, Sought};
use crate::synth::report::method::Method;
use crate::synth::report::parameters::Functions;
use crate::synth::report::solver::{SolverReport, Tier};
use crate::synth::search::Search;
use crate::units::Quantity;

/// Spectral inverse without limits, and the RMS of the omitted harmonics of the force, N. The number of harmonics is `count`. Without `count` it
/// is the minimum number for which the RMS of the omitted harmonics is at most `wanted`, N.
pub fn inverted(problem: &Problem, count: Option<usize>, wanted: f64) -> Result<(SolvedLaw, f64)> {
    let target = problem.target.as_ref().ok_or_else(no_force)?;
    let spectral = invert(target, &problem.drive, count, wanted)?;
    let method = Method::Spectral {
        harmonics: spectral.count,
        rest: Quantity::force(spectral.left_over),
    };
    let solver = SolverReport::of(Tier::Spectral, method, 0);
    let law = SolvedLaw {
        law: spectral.law(),
        family: Family::Harmonic,
        degree: 0,
        spans: 0,
        functions: Functions::Fourier,
        coefficients: spectral.x.clone(),
        circle: None,
        binding: Vec::new(),
        easing: Vec::new(),
        solver,
        price: ForcePrice::unlimited(problem),
    };
    Ok((law, spectral.left_over))
}

/// Harmonic law of a problem: the spectral inverse, or the solution of a convex program if the inverse violates a limit.
pub fn harmonic_law(problem: &Problem, search: &Search) -> Sought<SolvedLaw> {
    let wanted = problem.asked_error();
    let (found, _) = inverted(problem, problem.law.harmonics, wanted)?;
    let count = found.law.waves(0).len();
    // If every limit holds, the spectral inverse is already the optimum (theory §1).
    let formulation = formulation::of_harmonics(problem, search, count, &found.law);
    if !formulation.is_broken_by(&found.coefficients) {
        return Ok(Ok(found));
    }
    let optimum = match optimum::at_best_angle(formulation) {
        Ok(optimum) => optimum,
        Err(refusal) => return Ok(Err(refusal)),
    };
    let solution = &optimum.solution;
    let method = Method::Harmonics {
        harmonics: count,
        rounds: solution.rounds,
        violation: solution.violation,
    };
    let report = optimum.proved(SolverReport::of(Tier::Qp, method, solution.iterations));
    Ok(Ok(solved_law(
        problem,
        &optimum,
        Family::Harmonic,
        Minimise::ForceError,
        report,
    )))
}

/// Error for families that require a target force.
pub fn no_force() -> Error {
    SynthError::FamilyNeedsForce.at_key("law.family")
}
