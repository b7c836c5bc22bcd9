//! Simulation of the cam, with the simplest sufficient model.
//!
//! [`simulate()`] takes the emitted profile, recovers the smooth lift its points give the follower
//! ([`mod@recover`]) and runs it under one of three models:
//!
//! - [`rigid`]: F = F₀ + k s + c ω v + m ω² a, torque, contact pressure ([`rigid::hertz`]);
//! - [`flexible`]: a compliant follower in exact steady vibration ([`flexible::Linear`]);
//! - `machine_motion`: the rigid follower on a shaft whose speed its motor and its inertia give, on a floor that moves;
//! - [`contact`]: lift-off, flight, impact and rest, one event after the other.
//!
//! The simplest sufficient model is chosen automatically, with its reason.

pub mod contact;
pub(crate) mod fixed_point;
pub mod flexible;
pub(crate) mod floor;
pub(crate) mod machine_motion;
mod outcome;
mod reason;
pub mod recover;
pub mod rigid;
mod run;
pub(crate) mod shaft;
mod simulate;
pub mod surface;

pub use contact::impact::Pulse;
pub use contact::{Impact, Limits as ContactLimits};
pub use flexible::Train;
pub use flexible::polydyne::Miss;
pub use floor::{Comfort, Floor, FloorMode, FloorMotion};
pub use outcome::{Difference, Force, Loads, Model, Outcome, Pressure, Row, Torque};
pub use reason::{ForceMargin, LiftoffMargin, ModelReason, RunNote, Vibration};
pub use recover::{Emitted, recover};
pub use rigid::hertz;
pub use rigid::touch::{FollowerContact, Touch, touch};
pub use run::{Face, Machine, Run};
pub use shaft::{InTime, Shaft};
pub use simulate::simulate;

/// Cams of a thesis that the tests run; unit tests of this crate compile them with its own types.
#[cfg(test)]
#[path = "../../crates/test-support/src/thesis.rs"]
mod thesis;
