//! From a problem to a law: one file per family, and `choose` for problems that leave the family open.

mod choose;
mod demands;
mod double_harmonic;
mod formulation;
mod harmonic;
pub mod inverse;
mod polynomial;
mod program;
mod solved;
mod spline;

pub use solved::SolvedLaw;
pub use spline::{TELLING, WORTHWHILE, larger, stopped_at_noise};

use super::optimum::Sought;
use super::search::Search;
use crate::problem::Problem;
use crate::scene::Family;
use crate::synth::report::solver::SolverReport;
use choose::ClosedForm;

/// The law of the problem's family; a spline where the family is open and the closed form does not pass every check.
pub fn law(problem: &Problem, search: &Search) -> Sought<SolvedLaw> {
    let passed_over = match problem.law.family {
        Family::Polynomial => return Ok(Ok(polynomial::polynomial_law(problem)?)),
        Family::Program => return Ok(Ok(program::program_law(problem)?)),
        Family::DoubleHarmonic => return Ok(Ok(double_harmonic::double_harmonic_law(problem)?)),
        Family::Harmonic => return harmonic::harmonic_law(problem, search),
        Family::Spline => None,
        Family::Auto => match choose::closed_form(problem)? {
            ClosedForm::Passes(law) => return Ok(Ok(*law)),
            ClosedForm::Missed(passed_over) => passed_over,
        },
    };
    let law = spline::spline_law(problem, search)?;
    Ok(law.map(|law| {
        let solver = SolverReport {
            passed_over,
            ..law.solver
        };
        SolvedLaw { solver, ..law }
    }))
}
