//! Cams as manufactured: random errors within tolerances, and measured profiles.

pub(super) mod measured;
mod over_time;
pub(super) mod scatter;
pub(super) mod tolerance;
