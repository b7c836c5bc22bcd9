//! Reasons why a problem has no law.

use crate::criterion::Criterion;
use crate::error::Result;
use crate::scene::Family;
use crate::synth::limits::NonconvexLimits;
use crate::synth::qp::{Basis, Failure, Program};

/// A result, or the reason for which the limits are infeasible. The outer error is an error of the input.
pub type Sought<T> = Result<std::result::Result<T, Box<Refusal>>>;

/// A program without a solution.
pub struct Refusal {
    /// The program without a solution.
    pub program: Program,
    /// Reason why the solver ended.
    pub failure: Failure,
    /// Non-convex limits, if the program has a solution that violates them and no feasible one was found.
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

    /// Whether the limits were found to be infeasible; otherwise the solver stopped early.
    pub fn is_found(&self) -> bool {
        !matches!(&self.failure, Failure::Numerical { .. })
    }

    /// Whether a law without the accuracy exists.
    pub fn is_of_accuracy(&self) -> bool {
        let open = self.program.of_least_rms(Criterion::Accuracy);
        self.nonconvex.is_none() && open.is_some_and(|open| open.solve().is_ok())
    }

    /// Family of the rejected laws.
    pub fn family(&self) -> Family {
        match &self.program.basis {
            Basis::Spline { .. } => Family::Spline,
            Basis::Harmonic { .. } => Family::Harmonic,
        }
    }
}
