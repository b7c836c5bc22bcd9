//! Figures of designs, recordings, simulations and sweeps.

pub mod cam;
pub mod cover;
pub mod curvature;
pub mod floor;
pub mod force;
pub(crate) mod identification;
pub mod inspection;
pub mod law;
pub mod overlay;
pub mod recording;
pub mod resonance;
pub mod run;
pub mod speeds;
pub mod sweep;
pub mod walkers;
