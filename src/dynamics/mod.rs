//! The cam in motion, with no more model than the scene needs.
//!
//! [`simulate()`] takes the emitted profile, recovers the smooth lift its points give the follower
//! ([`profile_curve`]) and runs it under one of three models:
//!
//! - [`rigid`]: F = F₀ + k s + c ω v + m ω² a, torque, what the parts must bear ([`hertz`], [`motor`]);
//! - [`flexible`]: what vibrates, in exact steady state ([`linear`], [`train`], [`shaft`]);
//! - [`contact`]: lift-off, flight, impact and rest, one event after the other ([`flight`], [`impact`]).
//!
//! [`choose`] picks the least that is enough and says why; [`design`] hands limits back to the synthesis,
//! [`polydyne`] shapes the cam so that a follower that gives ends where it should;
//! [`experiment`] runs the cams of Campillo de Blas (2017) again.

mod backwards;
pub mod choose;
pub mod contact;
mod contact_model;
pub mod design;
mod events;
pub mod flexible;
pub mod flight;
pub mod hertz;
pub mod impact;
pub mod linear;
pub mod load_cell;
mod models;
pub mod motor;
pub mod outcome;
pub mod piecewise_force;
pub mod polydyne;
pub mod profile_curve;
pub mod rigid;
mod rows;
pub mod shaft;
pub mod simulate;
mod slopes;
mod smoothing;
pub mod stance;
pub mod surface;
pub mod thesis;
pub mod touch;
pub mod train;
pub mod two_cams;

pub use outcome::{Model, Outcome};
pub use simulate::{Face, Machine, Run, simulate};
