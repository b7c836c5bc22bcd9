//! Force curves: where the wanted vertical force comes from.

mod curve;
mod models;

pub use curve::ForceCurve;
pub use models::{Feet, ModelInfo, SAMPLES, Status, catalogue, model};
