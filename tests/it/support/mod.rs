//! Helpers of several tests.

pub mod c3d;
