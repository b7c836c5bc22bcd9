//! Why a model was chosen, and what to know of a run: data whose sentences stand in `wording/en/dynamics.ftl`.

use serde::Serialize;
use strum::VariantNames;

use super::prepared::Prepared;
use crate::cam::Measures;
use crate::quantity::{Dimension, Quantity};
use crate::wording::{self, Language};

/// The numbers that decided for a model.
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
    /// Only the contact model knows the impacts between two cams.
    TwoCams,
    /// Nothing elastic is given.
    NothingVibrates { margin: ForceMargin },
    /// The vibrating follower would leave the cam.
    VibrationLosesContact {
        vibration: Vibration,
        force: Quantity,
    },
    /// Vibration moves the force by more than is allowed.
    Vibrates {
        vibration: Vibration,
        allowed: Quantity,
        margin: ForceMargin,
    },
    /// It does not.
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
    /// Inertia alone has no mean to be a part of.
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

/// What the follower's own vibration would do to the force.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[allow(missing_docs)] // fields are named as in the sentences
pub enum Vibration {
    /// Springs in series without mass: nothing vibrates, but the lift is shared.
    NoMass,
    NoSpectrum,
    Harmonics {
        frequency: Quantity,
        ratio: f64,
        part: Quantity,
    },
}

/// What to know of a run.
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)] // fields are named as in the sentences
pub enum RunNote {
    SecondCamBears { part: Quantity, force: Quantity },
    OtherWallBears { part: Quantity, force: Quantity },
    RigidPulls,
    RigidWithoutImpacts,
    FlexiblePulls,
    Escapes,
    NotPeriodic { turns: usize, impacts: usize },
    Swings,
    PairDistance { deviation: f64 },
}

impl RunNote {
    /// The note as a sentence.
    pub fn sentence(&self, language: Language) -> String {
        wording::sentence(language, "run", self)
    }
}

/// A contact force, or the moment of an arm.
pub(super) fn load(p: &Prepared, value: f64) -> Quantity {
    let dimension = match p.measures {
        Measures::Oscillating => Dimension::Torque,
        _ => Dimension::Force,
    };
    Quantity::new(value, dimension)
}
