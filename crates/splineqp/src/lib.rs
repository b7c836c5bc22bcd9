//! Convex programs over periodic splines. The limits hold at every point, not only at samples, and each solution has a certificate.
//!
//! ```text
//! minimise   ½ xᵀHx + gᵀx + cᵀy
//! such that  E x = e
//!            Σ wₖ s⁽ᵏ⁾(θ) + dᵀy ≤ bound + shape(θ)   for every θ of the limit's domain
//!            y₀ ≥ ‖(y₁, …, yₖ)‖                      for each cone
//!            √(2 q(x)) ≤ most                        for each limit on a root mean square
//! ```
//!
//! The law s(θ) = Σ xᵢBᵢ(θ) is a spline or a sum of harmonics with the basis functions Bᵢ and the coefficients x. The further variables y
//! have names. They are, for example, a minimised peak, a radius, or the lower end of a range of values. The matrices H and E, the vectors
//! c, d, e and g, and the weights wₖ are constant. The function q is half a mean square of the law.
//!
//! A limit is equivalent to infinitely many rows, one linear inequality for each θ. The points at which s exceeds a limit most are computed
//! exactly, from the roots of derivatives in Bernstein form. They are added as rows until no limit is exceeded at any θ. The multipliers of
//! the active rows prove a lower bound of the objective ([`certificate`]).
//!
//! The caller chooses the types of the names of limits and equalities ([`Names`]). With `()`, the names are strings.
//!
//! | file | content |
//! |---|---|
//! | `program` | program, limits, rows and solution |
//! | `variable` | further variables and their cones |
//! | `basis` | B-splines or harmonics, and rows of their coefficients |
//! | `objective` | H and g of a distance or an energy |
//! | `band` | Cholesky factor of a banded matrix with a border |
//! | `equality` | optimum with only equalities |
//! | `pieces` | derivatives in Bernstein form on all spans |
//! | `separation` | exact points at which a law violates its limits |
//! | `dual` | dual active-set method of Goldfarb and Idnani |
//! | `active_set` | active-set method with separation, on the banded factor |
//! | `proximal` | active-set method for minimising a peak |
//! | `frame` | QR factors of the normals of the active planes |
//! | `solve` | selection of the method |
//! | `row_solver` | interface to a solver of programs with finitely many rows |
//! | `exchange` | iterations of separation and solution |
//! | `clarabel` | interior-point method, by Clarabel |
//! | `rms` | limit on a root mean square, by a search for its multiplier |
//! | `refine` | refinement of solution and certificate to rounding, by Newton's method |
//! | `settings` | tuning constants with reasons |
//! | `squares` | minimum of the maximum of several squares over a convex hull |
//! | `certificate` | duality gap and stationarity |

#![forbid(unsafe_code)]
#![cfg_attr(not(test), deny(clippy::disallowed_methods))]
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

/// Types, chosen by the caller, for the names of limits and equalities.
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
    /// Type of the names of limits.
    type Limit: std::fmt::Debug + Copy + PartialEq;
    /// Type of the names of equalities.
    type Equality: std::fmt::Debug + Copy + PartialEq;
    /// Type that records for the caller what a bound means, such as the quantity from which the bound is computed.
    type Meaning: std::fmt::Debug + Copy + PartialEq + Default;
}

impl Names for () {
    type Limit = &'static str;
    type Equality = &'static str;
    type Meaning = ();
}

/// Compiles and runs the program in the README as a doctest.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
