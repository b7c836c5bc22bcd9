//! gaitcam: from a vertical walking force to the cam that reproduces it.
#![forbid(unsafe_code)]
#![deny(missing_docs)]

pub mod error;
pub mod units;

pub mod poly;

pub mod gait;

pub mod drive;

pub mod law;

pub mod cam;

pub mod dynamics;

pub mod scene;

pub mod synth;

pub mod emit;

pub mod sweep;

pub mod cli;
