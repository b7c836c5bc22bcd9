//! Synthesis: from a wanted force to a law, a cam and its proof.

mod answer;
mod band;

pub use answer::{Binding, ForceReport, Infeasible, Relaxation, SolverReport, Synthesis, Tier};
