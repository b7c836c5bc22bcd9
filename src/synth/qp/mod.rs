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
//! | `active_set` | dual active-set method on the banded factor |
//! | `frame` | active planes as an orthonormal basis and a triangle |
//! | `local_reduction` | Newton's method on the contact points |
//! | `exchange` | which method solves; rounds of separation and solution |
//! | `clarabel` | interior-point method, by Clarabel |
//! | `contacts` | Newton's method on the contacts, where variables stand beside the law or a proof is open |
//! | `quadratic_step` | its steps: small dense programs |
//! | `polish` | active rows solved as equalities, for the last digits |
//! | `nearest` | the last digits where limits leave a hair |
//! | `settings` | every tuning constant with its reason |
//! | `certificate` | duality gap, stationarity, sensitivities |

mod active_set;
mod band;
mod basis;
mod certificate;
mod clarabel;
mod contacts;
mod demand;
mod equality;
mod exchange;
mod frame;
mod local_reduction;
mod nearest;
mod objective;
mod pieces;
mod polish;
mod program;
mod quadratic_step;
mod separation;
mod settings;
#[cfg(test)]
mod tests;

pub use basis::{Basis, Entries, apply};
pub use certificate::{Certificate, Sensitivity, certificate, sensitivities};
pub use clarabel::{prepared as clarabel_prepared, run as clarabel_run};
pub use demand::{Demand, Given};
pub use equality::solve as solve_equalities;
pub use objective::Quadratic;
pub use program::{
    EXTRAS, Equality, FACE_END, Failure, LOWEST, Limit, Meaning, OFFSET, PEAK, Program, RADIUS,
    RISE, Row, SIZES, Solution, Stop,
};
pub use settings::{
    ActiveSetSettings, ContactSettings, EqualitySettings, ExchangeSettings, InteriorPointSettings,
    LocalReductionSettings, Settings, TOLERANCE,
};
