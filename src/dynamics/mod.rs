//! Simulation of the cam, with the simplest sufficient model.
//!
//! [`simulate()`] recovers the smooth lift from the points of the output profile (`recover`) and simulates the cam with one of these
//! models:
//!
//! - `rigid`: F = F₀ + k s + c ω v + m ω² a (symbols as in the crate documentation), torque, contact pressure ([`hertz`]);
//! - [`flexible`]: a compliant follower in exact steady vibration ([`flexible::Linear`]);
//! - `machine_motion`: the rigid follower with a motor-driven shaft or a moving floor;
//! - [`contact`]: lift-off, flight, impact and rest, event by event.
//!
//! By default, the simplest sufficient model is selected, and the reason is reported.

pub mod contact;
pub(crate) mod fixed_point;
pub mod flexible;
pub(crate) mod floor;
pub(crate) mod machine_motion;
mod outcome;
pub(crate) mod reason;
pub(crate) mod recover;
pub(crate) mod rigid;
mod run;
pub(crate) mod shaft;
mod simulate;
pub(crate) mod surface;
mod walking;

pub(crate) use flexible::Train;
pub use floor::{Floor, FloorMode, FloorMotion};
pub use outcome::{Difference, Model, Outcome, Pressure, Row};
pub use recover::{Emitted, recover};
pub use rigid::touch::{FollowerContact, touch};
pub use rigid::{hertz, least_preload, liftoff_speed, torque_curve};
pub use run::{Face, Machine, Run};
pub(crate) use shaft::InTime;
pub use shaft::Shaft;
pub use simulate::simulate;
pub use surface::Surface;
pub use walking::{Bounds, Followed, Misfit, ProgrammeRun, RepeatedForce, SpeedProgramme};

/// Cams of a thesis, for tests. The file is compiled here again, because the types of `gaitcam-test-support` differ from those of the unit
/// tests.
#[cfg(test)]
#[path = "../../crates/test-support/src/thesis.rs"]
mod thesis;
