//! Why a program has no solution.

use crate::Names;
use serde::Serialize;

/// Why there is no solution. Only the first two are proofs that there is none.
#[derive(Debug, Clone, PartialEq)]
pub enum Failure<N: Names> {
    /// The equalities contradict each other.
    Inconsistent {
        /// Names of those that do not follow from the others.
        equalities: Vec<N::Equality>,
    },
    /// The limits leave nothing.
    Infeasible,
    /// The solver stopped without an answer.
    Numerical {
        /// How it stopped.
        stop: Stop,
    },
}

/// How a solver stopped without an answer; says nothing about whether there is one.
///
/// ```
/// use splineqp::{Failure, Stop};
///
/// let failure: Failure<()> = Stop::IterationLimit.into();
/// assert_ne!(failure, Failure::Infeasible);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Stop {
    /// The objective's matrix has no factor.
    SingularObjective,
    /// The equalities' matrix has no factor.
    SingularEqualities,
    /// The caller ended it.
    OutOfTime,
    /// As many iterations as are allowed were taken.
    IterationLimit,
    /// Rounds of exchange no longer came nearer.
    NoProgress,
    /// The objective has no lower bound.
    Unbounded,
    /// Rounding spoilt the iteration or its result.
    NumericalError,
    /// The interior-point method refused its settings or data.
    Refused,
}

impl<N: Names> From<Stop> for Failure<N> {
    fn from(stop: Stop) -> Self {
        Failure::Numerical { stop }
    }
}
