//! Laws of the harmonics of a force, found without solving (theory §1): the inverse, and its figures for many
//! problems of one force.
//!
//! Where the drive is pure inertia the law is one fixed curve times a factor: all extremes of lift, velocity, acceleration,
//! jerk, force and flat-face curvature are those of the fixed curve, scaled. What
//! [`synthesise`](super::synthesise) finds piece by piece is a handful of multiplications here; tests compare the two
//! to 1e-9.

mod figures;
mod inverse;

pub use figures::figures;
pub use inverse::{Spectral, invert};
