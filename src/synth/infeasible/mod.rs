//! Diagnosis of infeasibility: a deletion filter on the program finds an irreducible infeasible set of limits. If the solver stops early,
//! infeasibility is not proved, and the report states this.

mod iis;
pub mod reasons;

pub use iis::{bore_against_size, explain};
