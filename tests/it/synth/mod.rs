//! Designs: families, limits, certificates, relaxations.

mod certificate;
mod coefficients;
mod every_limit;
mod families;
mod guard;
mod interruption;
mod loads;
mod machine;
mod out_of_reach;
mod peaks;
mod power;
mod problem;
mod random;
mod relaxations;
mod residual;
mod scale;
mod spans;
mod targets;
mod trade;
mod verdict;
mod verdict_grid;
mod widened;
mod witness;
