//! Scenes without a law: reasons, relaxations, and interruption by the user.

mod in_motion;
mod interruption;
mod out_of_reach;
pub mod relaxations;
mod smallest;
