//! Limits: each on its own, on loads and machine, and widened.

mod every_limit;
mod loads;
mod machine;
mod power;
mod power_mean;
mod pressure_angle;
mod residual;
mod widened;
