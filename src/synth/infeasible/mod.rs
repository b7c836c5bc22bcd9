//! Diagnosis of infeasibility: an irreducible infeasible set of limits, by a deletion filter on the program. A solver that stops early does not prove
//! infeasibility; this is reported.

mod iis;
pub mod reasons;

pub use iis::{bore_against_size, explain};
