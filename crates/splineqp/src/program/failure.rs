//! Reasons why a program has no solution.

use crate::Names;
use serde::Serialize;

/// Reason why a program has no solution. Only the first two reasons prove infeasibility.
#[derive(Debug, Clone, PartialEq)]
pub enum Failure<N: Names> {
    /// The equalities contradict each other.
    Inconsistent {
        /// Names of the dependent equalities that contradict the other equalities.
        equalities: Vec<N::Equality>,
    },
    /// No law satisfies all limits.
    Infeasible,
    /// The solver stopped without a result.
    Numerical {
        /// Reason why the solver stopped.
        stop: Stop,
    },
}

/// Reason why a solver stopped without a result. It does not prove infeasibility.
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
    /// The matrix of the objective cannot be factorised.
    SingularObjective,
    /// The matrix of the equalities cannot be factorised.
    SingularEqualities,
    /// The caller stopped the search.
    OutOfTime,
    /// The maximum number of iterations was reached.
    IterationLimit,
    /// The exchange iterations made no progress.
    NoProgress,
    /// The objective has no lower bound.
    Unbounded,
    /// The iteration or its result is inaccurate because of rounding errors.
    NumericalError,
    /// The interior-point method rejected its settings or data.
    Refused,
}

impl<N: Names> From<Stop> for Failure<N> {
    fn from(stop: Stop) -> Self {
        Failure::Numerical { stop }
    }
}
