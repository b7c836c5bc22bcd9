//! Designs: families, limits, certificates, relaxations.

mod arm;
mod cover;
mod double_harmonic;
mod families;
mod guard;
mod in_run;
mod limits;
mod objectives;
mod population;
mod problem;
mod proof;
mod random;
mod refusal;
mod scale;
mod spans;
mod verdict;
mod verdict_grid;
