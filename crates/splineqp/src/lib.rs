//! Convex programs over periodic splines whose limits hold everywhere, not on samples; with certificates.
//!
//! ```text
//! minimise   ½ xᵀHx + gᵀx + cᵀy
//! such that  E x = e
//!            Σ wₖ s⁽ᵏ⁾(θ) + dᵀy ≤ bound + shape(θ)   for every θ of the limit's domain
//!            y₀ ≥ ‖(y₁, …, yₖ)‖                      for each cone
//!            √(2 q(x)) ≤ most                        for each limit on a root mean square
//! ```
//!
//! s(θ) = Σ xᵢBᵢ(θ) is a spline or a sum of harmonics; y are a few further variables with names (a minimised peak, sizes in a cone, ends of ranges).
//! A limit is infinitely many rows: the exact worst points of s come from the roots of its derivatives in Bernstein form and enter as rows until no
//! limit is exceeded between them. The multipliers of the active rows prove a lower bound of the objective ([`certificate`]).
//!
//! Limits and equalities have names of the caller's types ([`Names`]); `()` names them by text.
//!
//! | file | |
//! |---|---|
//! | `program` | the program, its limits, rows and solution |
//! | `variable` | variables beside the coefficients, and their cones |
//! | `basis` | B-splines or harmonics, rows on their coefficients |
//! | `objective` | H and g of a distance or an energy |
//! | `band` | Cholesky factor of a banded matrix with a border |
//! | `equality` | the optimum under equalities alone |
//! | `pieces` | derivatives in Bernstein form on all spans at once |
//! | `separation` | exact points at which a law violates its limits |
//! | `dual` | dual active-set method of Goldfarb and Idnani |
//! | `active_set` | its rounds with separation, on the banded factor |
//! | `proximal` | the same for a peak that is minimised |
//! | `frame` | active planes as an orthonormal basis and a triangle |
//! | `solve` | which method solves |
//! | `row_solver` | what the rounds ask of a solver of finitely many rows |
//! | `exchange` | rounds of separation and solution |
//! | `clarabel` | interior-point method, by Clarabel |
//! | `rms` | a limit on a root mean square, by the weight at which it holds with equality |
//! | `refine` | Newton's method on the contacts: the last digits of a solution and its proof |
//! | `settings` | every tuning constant with its reason |
//! | `squares` | weights of several squares at which the worst is least |
//! | `certificate` | duality gap, stationarity |

#![forbid(unsafe_code)]
#![deny(missing_docs)]
#![deny(clippy::missing_errors_doc)]
#![cfg_attr(not(test), warn(unused_crate_dependencies))]

mod band;
mod basis;
mod certificate;
mod equality;
mod frame;
mod objective;
pub mod poly;
mod program;
mod settings;
mod solve;
mod squares;

pub use basis::{Basis, Entries, apply, only};
pub use certificate::{Certificate, PROVED, certificate};
pub use equality::solve as solve_equalities;
pub use objective::{MeanSquare, Quadratic, pointwise};
pub use program::{
    ByVariable, Cone, Derivative, Equality, Failure, LeftSide, Limit, Limited, PEAK, Program,
    RmsLimit, Row, Solution, Stop, Values, Variable,
};
pub use settings::{Settings, TOLERANCE};
pub use solve::exchange::solve as solve_by_interior_point;
pub use squares::{LeastWorst, Square, least_worst};

/// Types of the caller's names of limits and equalities.
///
/// ```
/// use splineqp::Names;
///
/// #[derive(Debug, Clone, Copy, PartialEq)]
/// enum Axis { X, Y }
/// #[derive(Debug, Clone, Copy, PartialEq)]
/// struct Robot;
/// impl Names for Robot {
///     type Limit = Axis;
///     type Equality = (Axis, usize);
///     type Meaning = ();
/// }
/// ```
pub trait Names: std::fmt::Debug + Copy + PartialEq {
    /// Name of a limit.
    type Limit: std::fmt::Debug + Copy + PartialEq;
    /// Name of an equality.
    type Equality: std::fmt::Debug + Copy + PartialEq;
    /// Meaning of a bound to the caller, such as the number of which it is a function.
    type Meaning: std::fmt::Debug + Copy + PartialEq + Default;
}

impl Names for () {
    type Limit = &'static str;
    type Equality = &'static str;
    type Meaning = ();
}

/// The program in the README compiles and runs.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
