//! Piecewise polynomials in Bernstein form, with exact derivatives, roots and extrema; B-splines; sums of harmonics.
//!
//! A polynomial of degree n on an interval is represented by its n + 1 Bernstein coefficients. The polynomial lies in the convex hull of
//! its coefficients. The Bernstein form is better conditioned than monomials (theory §9).

pub mod bernstein;
mod bspline;
mod cells;
mod extreme;
mod fourier;
mod gauss;
mod piecewise;
mod proxy;
mod trigonometric;
mod wave;

pub use bspline::{Span, SplineSpace};
pub use cells::{Cells, Distance};
pub use extreme::Extreme;
pub use fourier::{amplitudes, samples};
pub use gauss::gauss_legendre;
pub use piecewise::{Peak, PiecewisePoly};
pub use proxy::{stand_in, stand_ins_for_differences};
pub use trigonometric::{harmonic_extremes, harmonic_sums, harmonic_values};
pub use wave::{Wave, add_taylor, subdivide};
