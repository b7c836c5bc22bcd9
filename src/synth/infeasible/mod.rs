//! Why there is no cam: an irreducible infeasible set of limits, by a deletion filter on the program that has no solution. A
//! stop of the solver is no proof that limits leave nothing, and is reported as what it is.

mod iis;
pub mod reasons;

pub use iis::{bore_against_size, explain};
