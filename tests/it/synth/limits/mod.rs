//! Limits: individual ones, on loads and machine, and relaxed ones.

mod every_limit;
mod loads;
mod machine;
mod power;
mod power_mean;
mod pressure_angle;
mod residual;
mod widened;
