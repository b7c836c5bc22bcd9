//! Reasons why a problem has no law.

use crate::criterion::Criterion;
use crate::error::Result;
use crate::scene::Family;
use crate::synth::limits::NonconvexLimits;
use crate::synth::qp::{Basis, Failure, Program};

/// A result, or the reason why the limits are infeasible; the outer error is a fault of the input.
pub type Sought<T> = Result<std::result::Result<T, Box<Refusal>>>;

/// A program without a solution.
pub struct Refusal {
    /// The program without a solution.
    pub program: Program,
    /// Reason of the solver's end.
    pub failure: Failure,
    /// The nonconvex limits, if the program has a solution that violates them and no feasible one was found.
    pub nonconvex: Option<NonconvexLimits>,
}

impl Refusal {
    /// A convex program without a solution.
    pub fn of(program: Program, failure: Failure) -> Box<Refusal> {
        Box::new(Refusal {
            program,
            failure,
            nonconvex: None,
        })
    }

    /// Whether infeasibility was found; otherwise the solver stopped early.
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
