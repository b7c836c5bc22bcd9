//! Reasons for the selection of a model, and notes on a run. The messages are in `wording/en/dynamics.ftl`.

use serde::Serialize;
use strum::VariantNames;

use crate::units::Quantity;
use crate::wording::{self, Language};

/// Reason for the selection of a model, with the relevant numbers.
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named in the messages
pub enum ModelReason {
    /// The user selected the model.
    AskedFor,
    /// The rigid force is close to zero.
    LowForce {
        force: Quantity,
        part: Quantity,
        mean: Quantity,
        liftoff: LiftoffMargin,
    },
    /// The speed is close to the lift-off speed.
    NearLiftoff { liftoff: LiftoffMargin },
    /// Only the contact model includes the impacts between two cams.
    TwoCams,
    /// The follower is rigid, so it does not vibrate.
    NothingVibrates { margin: ForceMargin },
    /// The vibrating follower would lose contact.
    VibrationLosesContact {
        vibration: Vibration,
        force: Quantity,
    },
    /// Vibration changes the force by more than the tolerance.
    Vibrates {
        vibration: Vibration,
        allowed: Quantity,
        margin: ForceMargin,
    },
    /// Vibration changes the force by no more than the tolerance.
    HardlyVibrates {
        vibration: Vibration,
        allowed: Quantity,
        margin: ForceMargin,
    },
}

impl ModelReason {
    /// Message that states the reason in a language.
    pub fn sentence(&self, language: Language) -> String {
        wording::sentence(language, "model", self)
    }
}

/// Distance of the speed from the lift-off speed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[allow(missing_docs)] // the fields are named in the messages
pub enum LiftoffMargin {
    HeldFromBothSides,
    NoLiftoff { speed: Quantity },
    MovingFloor { speed: Quantity },
    LiftoffAt { speed: Quantity, liftoff: Quantity },
}

/// Distance of the rigid force from zero, and of the speed from the lift-off speed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[allow(missing_docs)] // the fields are named in the messages
pub enum ForceMargin {
    /// The drive has neither mass nor spring nor preload.
    NoForce,
    /// The force is an inertia force without a mean, so there is no relative margin.
    InertiaOnly {
        low: Quantity,
        high: Quantity,
        liftoff: LiftoffMargin,
    },
    SmallestForce {
        force: Quantity,
        part: Quantity,
        liftoff: LiftoffMargin,
    },
}

/// Effect of the follower's vibration on the force.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[allow(missing_docs)] // the fields are named in the messages
pub enum Vibration {
    /// Springs in series without mass. There is no vibration, but a part of the lift deflects the train.
    NoMass,
    Harmonics {
        frequency: Quantity,
        ratio: Quantity,
        part: Quantity,
    },
}

/// Note on a run for the user.
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named in the messages
pub enum RunNote {
    SecondCamBears {
        part: Quantity,
        force: Quantity,
    },
    OtherWallBears {
        part: Quantity,
        force: Quantity,
    },
    RigidPulls,
    RigidWithoutImpacts,
    FlexiblePulls,
    Escapes,
    NotPeriodic {
        turns: usize,
        impacts: usize,
    },
    Swings,
    PairDistance {
        deviation: f64,
    },
    /// The motor changes the force by no more than the tolerance, so constant speed is sufficient.
    SteadyShaft {
        ripple: Quantity,
        change: Quantity,
        allowed: Quantity,
    },
    /// The speed of the shaft varies.
    ShaftVaries {
        ripple: Quantity,
        change: Quantity,
        found: Quantity,
    },
    /// The compliant follower is simulated at the mean speed.
    FlexibleAtMeanSpeed,
}

impl RunNote {
    /// Message that states the note in a language.
    pub fn sentence(&self, language: Language) -> String {
        wording::sentence(language, "run", self)
    }
}
