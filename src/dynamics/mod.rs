//! The cam in motion, with no more model than the scene needs.
//!
//! [`simulate()`] takes the emitted profile, recovers the smooth lift its points give the follower
//! ([`recover`]) and runs it under one of three models:
//!
//! - [`rigid`]: F = F₀ + k s + c ω v + m ω² a, torque, contact pressure ([`rigid::hertz`]);
//! - [`flexible`]: a compliant follower in exact steady vibration ([`flexible::linear`]);
//! - [`contact`]: lift-off, flight, impact and rest, one event after the other.
//!
//! [`choose`] picks the least that is enough and says why; [`flexible::polydyne`] shapes the cam so that
//! the end of a compliant follower moves as wanted.

pub mod choose;
pub mod contact;
pub mod flexible;
mod models;
pub mod outcome;
pub mod piecewise_force;
mod prepared;
mod reason;
pub mod recover;
pub mod report;
pub mod rigid;
mod rows;
mod run;
mod simulate;
pub mod surface;
pub mod thesis;

pub use flexible::Train;
pub use outcome::{Model, Outcome};
pub use reason::{ForceMargin, LiftoffMargin, ModelReason, RunNote, Vibration};
pub use rigid::hertz;
pub use run::{Face, Machine, Run};
pub use simulate::simulate;
