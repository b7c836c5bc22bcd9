//! What is minimised: peaks, the target, weighed sums.

mod peaks;
mod targets;
mod trade;
