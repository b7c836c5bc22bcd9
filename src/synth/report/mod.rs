//! Report on a design as plain data: method and certificate, active limits, conflicts, reasons for the verdict.

pub mod end;
pub mod force;
pub mod limited;
pub mod method;
pub mod named;
pub mod parameters;
pub mod proof;
pub mod reason;
pub mod shaft;
pub mod solver;
pub mod walkers;
