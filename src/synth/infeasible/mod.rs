//! Diagnosis of infeasibility: a deletion filter on the program finds an irreducible infeasible set of limits. A solver that stops early does
//! not prove infeasibility, which is reported.

mod iis;
pub mod reasons;

pub use iis::{bore_against_size, explain};
