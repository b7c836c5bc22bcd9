//! Synthesis: from a wanted force to a law, a cam and its proof.

mod answer;
mod band;
mod basis;
mod cones;
mod equality;
mod objective;
mod polish;
mod program;

pub use answer::{Binding, ForceReport, Infeasible, Relaxation, SolverReport, Synthesis, Tier};
