//! Laws of the harmonics of a force, found without solving (theory §1): the inverse, and its figures for many
//! problems of one force.
//!
//! A load model is a Fourier series, so the distance of a law from it is what its other harmonics hold. Where the
//! drive is pure inertia the law itself is one fixed curve times a factor: all extremes of lift, velocity, acceleration,
//! jerk, force and flat-face curvature are those of the fixed curve, scaled. What
//! [`synthesise`](super::synthesise) finds piece by piece is a handful of multiplications here; tests compare the two
//! to 1e-9.

mod figures;
mod inverse;
mod series;
mod shape;

pub use figures::{figures, suits};
pub use inverse::{Spectral, invert};
pub use series::Series;

/// (cosine, sine) of harmonics 1, 2, …
type Waves = [(f64, f64)];
