//! The spectral tier: the inverse, and its figures for many scenes of one force without solving anything twice.
//!
//! A harmonic law gives the force of its harmonics exactly, so its error depends on the force alone. Where
//! the drive is pure inertia or pure spring, the law itself is one fixed curve times a factor: all extremes
//! of lift, velocity, acceleration, jerk, force and flat-face curvature are those of the fixed curve, scaled.
//! What [`synthesise`](super::synthesise) finds piece by piece is a handful of multiplications here; tests
//! compare the two to 1e-9.

mod figures;
mod inverse;
mod limited_slopes;
mod machine;
mod target;

pub use figures::{figures, suits};
pub use inverse::{Spectral, invert};
pub use target::HarmonicTarget;
use target::{Fit, LawRanges, Terms};

/// Most harmonics that an automatic count takes.
const MOST_AUTO: usize = 60;

/// Smallest and largest value.
type Range = (f64, f64);
