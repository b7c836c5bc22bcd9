//! What a run of the cam found.

use serde::Serialize;

use super::contact::Impact;
use super::reason::{ModelReason, RunNote};
use super::rigid::hertz::LineContact;
use crate::error::Error;

/// Which model ran.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Model {
    /// Start rigid, go as far as the numbers ask.
    Auto,
    /// Rigid bodies that stay in contact.
    Rigid,
    /// A follower that gives, in steady vibration.
    Flexible,
    /// Contact that can be lost.
    Contact,
}

impl Model {
    /// The word users write after `--model`.
    pub fn name(self) -> &'static str {
        match self {
            Model::Auto => "auto",
            Model::Rigid => "rigid",
            Model::Flexible => "flexible",
            Model::Contact => "contact",
        }
    }

    /// The model of that name.
    pub fn parse(word: &str) -> Option<Self> {
        [Model::Auto, Model::Rigid, Model::Flexible, Model::Contact]
            .into_iter()
            .find(|m| m.name() == word)
    }
}

/// One row of `dynamics.csv`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Row {
    /// Cam angle, rad; over as many turns as the motion takes to repeat.
    pub theta: f64,
    /// Force along the follower's motion, N; 0 in flight.
    pub contact_force: f64,
    /// Torque of the shaft in the sense of growing θ, N·m.
    pub torque: f64,
    /// Power of the shaft, W.
    pub power: f64,
    /// Height of the moved mass over its place on the base circle, m.
    pub lift: f64,
    /// Gap between mass and cam, m.
    pub gap: f64,
    /// Force normal to the surfaces, N; of a barrel at the floor of its groove, where it is largest.
    pub normal_force: f64,
    /// Speed at which the cam rubs along the follower, m/s.
    pub sliding: f64,
    /// Mean speed of both surfaces relative to the contact, m/s.
    pub entraining: f64,
    /// Thrust across the guides, N.
    pub side_thrust: f64,
}

/// Extremes and error of the force, N.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Force {
    /// Smallest.
    pub min: f64,
    /// Largest; blows that take no time are not in it.
    pub max: f64,
    /// RMS distance to the target, where there is one.
    pub rms_error: Option<f64>,
}

/// Torque of the shaft, N·m.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Torque {
    /// Smallest.
    pub min: f64,
    /// Largest.
    pub max: f64,
    /// Mean over the repetition, blows included.
    pub mean: f64,
    /// Root mean square; blows are not in it.
    pub rms: f64,
}

/// What the next model up would change.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Difference {
    /// The model that was run for comparison.
    pub model: Model,
    /// Its smallest force less this one's, N.
    pub force_min: f64,
    /// Its largest force less this one's, N.
    pub force_max: f64,
    /// Its RMS error less this one's, N.
    pub rms_error: Option<f64>,
    /// Its lost fraction less this one's.
    pub lost_fraction: f64,
    /// Why it could not be run.
    pub failed: Option<Error>,
}

/// The highest line pressure and where it acts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pressure {
    /// Cam angle, rad.
    pub theta: f64,
    /// The contact there.
    pub contact: LineContact,
}

/// What a run found.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// The model whose numbers these are; never `Auto`.
    pub model: Model,
    /// The numbers that decided for it.
    pub why: ModelReason,
    /// Whether the follower leaves the cam.
    pub contact_lost: bool,
    /// Part of the motion without contact.
    pub lost_fraction: f64,
    /// Contact force.
    pub force: Force,
    /// Shaft torque.
    pub torque: Torque,
    /// Speed at which contact is first lost, rad/s; `None`: at no speed.
    pub liftoff_speed: Option<f64>,
    /// Turns before the motion repeats; `None`: it does not.
    pub settle_cycles: Option<usize>,
    /// Turns of one repetition.
    pub period_turns: usize,
    /// Landings of the whole run, settling included.
    pub impacts: Vec<Impact>,
    /// Highest line pressure of the rows, where the surfaces are known; blows are not in it.
    pub hertz: Option<Pressure>,
    /// What the next model would change, where `auto` chose.
    pub next: Option<Difference>,
    /// Largest distance between emitted points and the curve that was run, m.
    pub profile_mismatch: f64,
    /// Largest difference between the lift of the emitted points and the law's, m.
    pub law_mismatch: f64,
    /// Anything else a person should know.
    pub notes: Vec<RunNote>,
    /// One repetition at equal angles.
    pub rows: Vec<Row>,
}
