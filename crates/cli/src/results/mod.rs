//! Evaluation of several designs: comparison of results, and Pareto front of a table.

pub mod compare;
pub mod front;
