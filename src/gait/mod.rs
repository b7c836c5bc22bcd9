//! Force curves: where the wanted vertical force comes from.

mod curve;

pub use curve::ForceCurve;
