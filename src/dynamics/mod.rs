//! The cam in motion, with no more model than the scene needs.

pub mod choose;
pub mod contact;
pub mod design;
pub mod flexible;
pub mod flight;
pub mod hertz;
pub mod impact;
pub mod linear;
pub mod load_cell;
pub mod motor;
pub mod outcome;
pub mod piecewise_force;
pub mod profile_curve;
pub mod rigid;
pub mod shaft;
pub mod simulate;
pub mod surface;
pub mod thesis;
pub mod two_cams;

pub use outcome::{Model, Outcome};
pub use simulate::{Machine, Run, simulate};
