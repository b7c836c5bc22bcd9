//! Manufactured cams: simulation, inspection, and logs of their machines.

pub mod inspect;
pub mod logs;
pub mod run;
