//! Faults in what a design is asked for: no cam can be sought.

use serde::Serialize;
use serde_json::Value;
use strum::VariantNames;

use crate::units::Quantity;

/// Why a design cannot be sought.
///
/// ```
/// use gaitcam::error::SynthError;
/// use gaitcam::scene::Gait;
/// use gaitcam::{Scene, synthesise};
///
/// // A scene that names a force wants one.
/// let scene = Scene { gait: Some(Gait::model("young")), ..Scene::default() };
/// let error = synthesise(&scene, None).unwrap_err();
/// assert_eq!(error.fault(), Some(&SynthError::ForceNotRead));
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)] // the messages of wording/en/synth.ftl say what each field is
pub enum SynthError {
    ForceNotRead,
    NoLiftChangesForce,
    ValueMissing,
    MeanForceNegative {
        mean: Quantity,
    },
    NotScalable {
        mean: Quantity,
        weight: Quantity,
    },
    NoSpread,
    PairIncomplete {
        pair: String,
        known: String,
    },
    PairWithoutForceError {
        known: String,
    },
    PairUnknown {
        typed: String,
        known: String,
    },
    NoTarget,
    OnlySplines,
    SizeFixed,
    /// No law even without the limits; a [`Reason`](crate::synth::Reason) as it serialises.
    NoLaw {
        reason: Value,
    },
    SearchFailed {
        fault: String,
    },
    TooManyHarmonics {
        samples: usize,
        most: usize,
    },
    Resonance {
        harmonic: usize,
    },
    NoConstantBreadth {
        sum: Quantity,
        miss: Quantity,
        at: Quantity,
    },
    BreadthTooSmall {
        breadth: Quantity,
        lift: Quantity,
    },
    NoPrimeCircle,
    FollowerNeeds,
    NoRange {
        start: Quantity,
        end: Quantity,
    },
    DegreeTooLow {
        conditions: usize,
        fixed: usize,
        degree: usize,
        excess: usize,
    },
    DegreeTooHigh {
        conditions: usize,
        fixed: usize,
        degree: usize,
        missing: usize,
    },
    ManyDemands {
        given: usize,
        most: usize,
    },
    LawOpen {
        rise: Quantity,
    },
    ForceGivesNoLift,
    PointsEmpty,
    FamilyNeedsForce,
    NoDoubleHarmonic,
    DoubleHarmonicUseless,
    DwellsOverlap,
    DwellsFillTurn,
    PointOutside {
        at: Quantity,
    },
}
