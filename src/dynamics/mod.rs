//! The cam in motion, with no more model than the scene needs.

pub mod flexible;
pub mod linear;
pub mod profile_curve;
pub mod rigid;
pub mod thesis;
