//! Why a model was chosen, and notes on a run, as data; their sentences are in `wording/en/dynamics.ftl`.

use serde::Serialize;
use strum::VariantNames;

use crate::units::Quantity;
use crate::wording::{self, Language};

/// Reason for the choice of a model, with its numbers.
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)] // fields are named as in the sentences
pub enum ModelReason {
    /// The caller named the model.
    AskedFor,
    /// The rigid force comes near zero.
    LowForce {
        force: Quantity,
        part: Quantity,
        mean: Quantity,
        liftoff: LiftoffMargin,
    },
    /// The speed comes near lift-off.
    NearLiftoff { liftoff: LiftoffMargin },
    /// Only the contact model has the impacts between two cams.
    TwoCams,
    /// The follower is rigid.
    NothingVibrates { margin: ForceMargin },
    /// The vibrating follower would leave the cam.
    VibrationLosesContact {
        vibration: Vibration,
        force: Quantity,
    },
    /// Vibration changes the force by more than is allowed.
    Vibrates {
        vibration: Vibration,
        allowed: Quantity,
        margin: ForceMargin,
    },
    /// Vibration changes the force by less than is allowed.
    HardlyVibrates {
        vibration: Vibration,
        allowed: Quantity,
        margin: ForceMargin,
    },
}

impl ModelReason {
    /// The reason as a sentence.
    pub fn sentence(&self, language: Language) -> String {
        wording::sentence(language, "model", self)
    }
}

/// How far the speed is from lift-off.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[allow(missing_docs)] // fields are named as in the sentences
pub enum LiftoffMargin {
    HeldFromBothSides,
    NoLiftoff { speed: Quantity },
    MovingFloor { speed: Quantity },
    LiftoffAt { speed: Quantity, liftoff: Quantity },
}

/// How far the rigid force is from zero.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[allow(missing_docs)] // fields are named as in the sentences
pub enum ForceMargin {
    /// The drive has neither mass nor spring nor preload.
    NoForce,
    /// A pure inertia force has no mean to relate the margin to.
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
#[allow(missing_docs)] // fields are named as in the sentences
pub enum Vibration {
    /// Springs in series without mass: no vibration, but part of the lift deflects the train.
    NoMass,
    Harmonics {
        frequency: Quantity,
        ratio: f64,
        part: Quantity,
    },
}

/// A note on a run.
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)] // fields are named as in the sentences
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
    /// The motor changes the force by less than is allowed: constant speed is enough.
    SteadyShaft {
        ripple: Quantity,
        change: Quantity,
        allowed: Quantity,
    },
    /// The speed varies.
    ShaftVaries {
        ripple: Quantity,
        change: Quantity,
        found: Quantity,
    },
    /// The compliant follower is run at the mean speed.
    FlexibleAtMeanSpeed,
}

impl RunNote {
    /// The note as a sentence.
    pub fn sentence(&self, language: Language) -> String {
        wording::sentence(language, "run", self)
    }
}
