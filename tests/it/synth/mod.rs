//! Designs: families, limits, certificates, relaxations.

mod certificate;
mod families;
mod loads;
mod machine;
mod random;
mod relaxations;
mod targets;
