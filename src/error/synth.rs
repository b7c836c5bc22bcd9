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
/// use gaitcam::Scene;
/// use gaitcam::synth::synthesise;
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
#[allow(missing_docs)] // the fields are named in the messages
pub enum SynthError {
    /// The force curve was not read.
    ForceNotRead,
    /// The drive has neither spring, damper nor mass.
    NoLiftChangesForce,
    /// A value is needed where no force is given.
    ValueMissing,
    /// No mass rests on a cam under a negative mean force.
    MeanForceNegative { mean: Quantity },
    /// The force cannot be scaled to the weight.
    NotScalable { mean: Quantity, weight: Quantity },
    /// The target is one cycle and has no spread.
    NoSpread,
    /// A trade-off is between two quantities.
    PairIncomplete { pair: String, known: String },
    /// One quantity of a trade-off is the force error.
    PairWithoutForceError { known: String },
    /// Unknown quantity of a trade-off.
    PairUnknown { typed: String, known: String },
    /// The trade-off needs a target force.
    NoTarget,
    /// The trade-off is for splines.
    OnlySplines,
    /// The scene fixes the size of the cam.
    SizeFixed,
    /// The rounds between law and speed of the shaft do not contract.
    ShaftDiverges {
        inertia: Quantity,
        ripple: Quantity,
        calm: Quantity,
        contraction: f64,
    },
    /// What is given is to be set anew for each walker.
    AdjustsGiven { key: String },
    /// The mass of this drive carries no walker's weight.
    MassNotAdjustable,
    /// At another speed the force is no multiple of that at the reference speed.
    SpeedNotAdjustable,
    /// The setting has no form for several walkers.
    NotOfPopulation,
    /// Several cams for one walker.
    OneWalker,
    /// The solver failed.
    SearchFailed { fault: String },
    /// More harmonics than the samples of the force hold.
    TooManyHarmonics { samples: usize, most: usize },
    /// Spring and inertia cancel at a harmonic of the force.
    Resonance { harmonic: usize },
    /// The follower needs this key.
    FollowerNeeds,
    /// A range of angles is not within one turn.
    NoRange { start: Quantity, end: Quantity },
    /// More conditions than the degree of the polynomial admits.
    DegreeTooLow {
        conditions: usize,
        fixed: usize,
        degree: usize,
        excess: usize,
    },
    /// Fewer conditions than the degree of the polynomial needs.
    DegreeTooHigh {
        conditions: usize,
        fixed: usize,
        degree: usize,
        missing: usize,
    },
    /// More conditions than are solved.
    ManyDemands { given: usize, most: usize },
    /// The law does not close.
    LawOpen { rise: Quantity },
    /// The drive does not turn a force into a lift.
    ForceGivesNoLift,
    /// The points give no condition.
    PointsEmpty,
    /// The family follows a force.
    FamilyNeedsForce,
    /// No double harmonic comes nearer to the force than rest.
    DoubleHarmonicUseless,
    /// Two dwells overlap.
    DwellsOverlap,
    /// The dwells fill the whole turn.
    DwellsFillTurn,
    /// A point lies outside the turn.
    PointOutside { at: Quantity },
}

/// Why no cam does what a scene asks for.
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named in the messages
pub enum NoDesignError {
    /// No law exists even without the limits; the reason is a [`Reason`](crate::synth::Reason) as it serialises.
    NoLaw { reason: Value },
    /// The law does not keep a breadth.
    NoConstantBreadth {
        sum: Quantity,
        miss: Quantity,
        at: Quantity,
    },
    /// The breadth is smaller than base circle and lift need.
    BreadthTooSmall { breadth: Quantity, lift: Quantity },
    /// No prime circle is large enough.
    NoPrimeCircle,
    /// The search found no double harmonic law.
    NoDoubleHarmonic,
}
