//! gaitcam: from a vertical walking force to the cam that reproduces it.
#![forbid(unsafe_code)]
#![deny(missing_docs)]

pub mod cam;
pub mod cli;
pub mod drive;
pub mod emit;
pub mod error;
pub mod gait;
pub mod law;
pub mod poly;
pub mod scene;
pub mod synth;
pub mod units;
