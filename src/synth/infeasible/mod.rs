//! Why there is no cam: an irreducible infeasible set of limits, and the smallest relaxation of each.
//!
//! `iis` finds the set by a deletion filter on the program that has no solution; `relaxation` designs the
//! whole cam with a changed value of every limit in turn. A stop of the solver is no proof that limits leave
//! nothing, and is reported as what it is.

mod beside;
mod by_size;
mod iis;
mod reasons;
mod relaxable;
mod relaxation;

pub use iis::{bore_against_size, explain};
pub use reasons::in_units;
