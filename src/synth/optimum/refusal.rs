//! Reasons why a problem has no law.

use crate::criterion::Criterion;
use crate::error::Result;
use crate::scene::Family;
use crate::synth::limits::NonconvexLimits;
use crate::synth::qp::{Basis, Failure, Program};

/// Result of a design step, or the reason why the limits are infeasible. The outer error is an error of the input.
pub type Sought<T> = Result<std::result::Result<T, Box<Refusal>>>;

/// A program without a solution, and the reason.
pub struct Refusal {
    /// The program that has no solution.
    pub program: Program,
    /// Reason why the solver found no solution.
    pub failure: Failure,
    /// Non-convex limits, if the convex program has a solution but no law was found that also satisfies these limits.
    pub nonconvex: Option<NonconvexLimits>,
}

impl Refusal {
    /// Refusal for a convex program without a solution.
    pub fn of(program: Program, failure: Failure) -> Box<Refusal> {
        Box::new(Refusal {
            program,
            failure,
            nonconvex: None,
        })
    }

    /// Whether the solver found the limits to be infeasible. The result is `false` if the solver stopped early.
    pub fn is_found(&self) -> bool {
        !matches!(&self.failure, Failure::Numerical { .. })
    }

    /// Whether the limits are infeasible only because of the required accuracy: without this accuracy a law exists.
    pub fn is_of_accuracy(&self) -> bool {
        let open = self.program.of_least_rms(Criterion::Accuracy);
        self.nonconvex.is_none() && open.is_some_and(|open| open.solve().is_ok())
    }

    /// Family of the laws in the infeasible program.
    pub fn family(&self) -> Family {
        match &self.program.basis {
            Basis::Spline { .. } => Family::Spline,
            Basis::Harmonic { .. } => Family::Harmonic,
        }
    }
}
