//! Profiles, curvature, pressure angles, sizes, and cams that cannot be made.

mod geometry;
mod papers;
mod put_back;
mod random;
mod refused;
