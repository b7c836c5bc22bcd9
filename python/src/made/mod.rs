//! Manufactured cams: in motion, as measured, and as a machine has logged them.

pub mod inspect;
pub mod logs;
pub mod run;
