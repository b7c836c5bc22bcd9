//! The harmonic family: the spectral inverse (theory §1), or a program where it violates a limit.

use super::spline_program::force_distance;
use super::touching;
use super::{NoLaw, SolvedLaw, report, solved};
use crate::error::{Error, Placed, Result, SynthError};
use crate::law::Law;
use crate::problem::Problem;
use crate::scene::{Family, Minimise};
use crate::synth::design::Tier;
use crate::synth::design::method::Method;
use crate::synth::design::parameters::Functions;
use crate::synth::limits;
use crate::synth::qp::{Basis, Program};
use crate::synth::search::Search;
use crate::synth::spectral::invert;
use crate::units::Quantity;

/// The force's harmonics inverted, without a look at the limits, and what lies in the rest, N RMS: `count`
/// of them, or the fewest that leave no more than `wanted`.
pub fn inverted(problem: &Problem, count: Option<usize>, wanted: f64) -> Result<(SolvedLaw, f64)> {
    let target = problem.target.as_ref().ok_or_else(no_force)?;
    let spectral = invert(&target.curve, &problem.drive, count, wanted)?;
    let method = Method::Spectral {
        harmonics: spectral.count,
        rest: Quantity::force(spectral.left_over),
    };
    let solver = report(Tier::Spectral, method, 0);
    let parameters = (Functions::Fourier, spectral.x.clone());
    let law = SolvedLaw::unlimited(spectral.law(), Family::Harmonic, parameters, solver);
    Ok((law, spectral.left_over))
}

/// The harmonics that the problem asks for, inverted, or solved for with the limits where those are broken.
pub fn law(problem: &Problem, search: &Search) -> std::result::Result<SolvedLaw, NoLaw> {
    let wanted = problem.asked_error();
    let (found, _) = inverted(problem, problem.law.harmonics, wanted)?;
    let count = found.law.waves(0).len();
    // When every limit holds the spectral inverse is already the optimum (theory §1).
    let program = harmonic_program(problem, search, count, &found.law);
    if program.limits.is_empty() || !breaks_a_limit(&program, &found) {
        return Ok(found);
    }
    let optimum = touching::solve(problem, program)?;
    let solution = &optimum.solution;
    let method = Method::Harmonics {
        harmonics: count,
        rounds: solution.rounds,
        violation: solution.violation,
    };
    let report = report(Tier::Qp, method, solution.iterations);
    let evidence = optimum.evidence();
    let force_error = Minimise::ForceError;
    Ok(solved(
        problem,
        &optimum,
        force_error,
        2 * count,
        report,
        evidence,
    ))
}

/// Whether the spectral law breaks a limit, its lowest point standing on the base circle.
fn breaks_a_limit(program: &Program, found: &SolvedLaw) -> bool {
    let mut x = found.coefficients.clone();
    if program.constant_is_free() {
        x[0] -= found.law.extremes(0).0.value;
    }
    !program.broken(&x, &program.windows(&x)).is_empty()
}

/// The force fit in a given number of harmonics with the scene's limits. `unlimited` is the law without
/// them: where nothing fixes the lift, it touches the base circle where it is lowest.
fn harmonic_program(problem: &Problem, search: &Search, count: usize, unlimited: &Law) -> Program {
    let basis = Basis::Harmonic { count };
    let force = force_distance(problem, &basis);
    let mut program = Program::new(basis, force, Vec::new(), problem.length);
    program.halt = search.halt.clone();
    program.limits = limits::rows(problem);
    if !problem.level_is_known() {
        program.touch_at(unlimited.extremes(0).0.at);
    }
    program
}

/// The refusal of families that follow a force where there is none.
pub fn no_force() -> Error {
    SynthError::FamilyNeedsForce.at_key("law.family")
}
