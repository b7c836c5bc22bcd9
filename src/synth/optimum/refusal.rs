//! Why a problem has no law.

use crate::criterion::Criterion;
use crate::error::Error;
use crate::scene::Family;
use crate::synth::limits::NonconvexLimits;
use crate::synth::qp::{Basis, Failure, Program};

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
    pub fn of(program: Program, failure: Failure) -> Box<Refusal> {
        Box::new(Refusal {
            program,
            failure,
            nonconvex: None,
        })
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
