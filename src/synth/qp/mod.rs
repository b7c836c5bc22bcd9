//! Convex programs over the coefficients of a law, with limits that hold on the continuum.
//!
//! ```text
//! minimise   ½ xᵀHx + gᵀx + cᵀy
//! such that  E x = e
//!            Σ wₖ s⁽ᵏ⁾(θ) + dᵀy ≤ bound + shape(θ)   for every θ of the limit's domain
//!            R ≥ ‖(D, e)‖                            where the size is among the variables y
//! ```
//!
//! The room knows piecewise polynomials and laws, and nothing of scenes, forces or cams.
//!
//! | file | |
//! |---|---|
//! | `program` | the program, its limits, rows and solution |
//! | `basis` | B-splines or harmonics, rows on their coefficients |
//! | `objective` | H and g of a distance or an energy |
//! | `band` | Cholesky factor of a banded matrix with a border |
//! | `equality` | the optimum under equalities alone |
//! | `pieces` | derivatives in Bernstein form on all spans at once |
//! | `separation` | exact points at which a law violates its limits |
//! | `dual` | dual active-set method of Goldfarb and Idnani |
//! | `active_set` | its rounds with separation, on the banded factor |
//! | `frame` | active planes as an orthonormal basis and a triangle |
//! | `solve` | which method solves |
//! | `exchange` | rounds of separation and solution |
//! | `clarabel` | interior-point method, by Clarabel |
//! | `refine` | Newton's method on the contacts: the last digits of a solution and its proof |
//! | `settings` | every tuning constant with its reason |
//! | `certificate` | duality gap, stationarity, sensitivities |

mod active_set;
mod band;
mod basis;
mod certificate;
mod clarabel;
mod demand;
mod dual;
mod equality;
mod exchange;
mod frame;
mod objective;
mod pieces;
mod program;
mod refine;
mod separation;
mod settings;
mod solve;
#[cfg(test)]
mod tests;

pub use basis::{Basis, Entries, apply};
pub use certificate::{Certificate, Sensitivity, certificate, sensitivities};
pub use clarabel::{prepared as clarabel_prepared, run as clarabel_run};
pub use demand::{Demand, Given};
pub use equality::solve as solve_equalities;
pub use exchange::solve as solve_by_interior_point;
pub use objective::Quadratic;
pub use program::{
    EXTRAS, Equality, FACE_END, Failure, LOWEST, Limit, Meaning, OFFSET, PEAK, Program, RADIUS,
    RISE, Row, SIZES, Solution, Stop,
};
pub use settings::{Settings, TOLERANCE};
