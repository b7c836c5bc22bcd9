//! Profiles, curvature, pressure angles, sizes, and cams that cannot be made.

mod body;
mod geometry;
mod inspect;
mod papers;
mod put_back;
mod random;
mod refused;
