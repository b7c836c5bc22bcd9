//! Manufactured cams: in motion, and as measured.

pub mod inspect;
pub mod run;
