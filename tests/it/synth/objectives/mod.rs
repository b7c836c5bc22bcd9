//! Objectives: peaks, target, weighted sums.

mod peaks;
mod size;
mod targets;
mod trade;
