//! Why a problem has no law.

use crate::criterion::Criterion;
use crate::error::Result;
use crate::scene::Family;
use crate::synth::limits::NonconvexLimits;
use crate::synth::qp::{Basis, Failure, Program};

/// What is sought, or why the limits leave none; the outer error is a fault of the input.
pub type Sought<T> = Result<std::result::Result<T, Box<Refusal>>>;

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
    pub fn of(program: Program, failure: Failure) -> Box<Refusal> {
        Box::new(Refusal {
            program,
            failure,
            nonconvex: None,
        })
    }

    /// Whether the limits were found to leave no law; otherwise the solver stopped before an answer.
    pub fn is_found(&self) -> bool {
        !matches!(&self.failure, Failure::Numerical { .. })
    }

    /// Whether there is a law without the accuracy.
    pub fn is_of_accuracy(&self) -> bool {
        let open = self.program.of_least_rms(Criterion::Accuracy);
        self.nonconvex.is_none() && open.is_some_and(|open| open.solve().is_ok())
    }

    /// Family of the laws that it refuses.
    pub fn family(&self) -> Family {
        match &self.program.basis {
            Basis::Spline { .. } => Family::Spline,
            Basis::Harmonic { .. } => Family::Harmonic,
        }
    }
}
