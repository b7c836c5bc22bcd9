//! Functions for a manufactured cam: simulation, inspection, and evaluation of machine logs.

pub mod inspect;
pub mod logs;
pub mod run;
