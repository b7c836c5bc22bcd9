//! What is minimised: peaks, the target, weighed sums.

mod peaks;
mod size;
mod targets;
mod trade;
