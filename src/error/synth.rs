//! Errors in the requirements of a design.

use serde::Serialize;
use serde_json::Value;
use strum::VariantNames;

use crate::units::Quantity;

/// Reasons why a design cannot be started.
///
/// ```
/// use gaitcam::error::SynthError;
/// use gaitcam::scene::Gait;
/// use gaitcam::Scene;
/// use gaitcam::synth::synthesise;
///
/// // The scene refers to a force, but the caller provides none.
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
    /// A value is required if no force is given.
    ValueMissing,
    /// The mean force is negative, so no mass has this weight.
    MeanForceNegative { mean: Quantity },
    /// The force cannot be scaled to the weight.
    NotScalable { mean: Quantity, weight: Quantity },
    /// The force band requires the step-to-step spread, but the target is a single cycle without spread.
    NoSpread,
    /// A trade-off does not consist of two quantities.
    PairIncomplete { pair: String, known: String },
    /// Neither quantity of a trade-off is the force error.
    PairWithoutForceError { known: String },
    /// A quantity of a trade-off is unknown.
    PairUnknown { typed: String, known: String },
    /// A trade-off is requested without a target force.
    NoTarget,
    /// A trade-off is requested for a family other than splines.
    OnlySplines,
    /// A trade-off with the size is requested, but the scene fixes the size of the cam.
    SizeFixed,
    /// The iteration that alternates between law design and shaft-speed simulation does not converge.
    ShaftDiverges {
        inertia: Quantity,
        ripple: Quantity,
        calm: Quantity,
    },
    /// A value is given in the scene, although `gait.adjust` sets this value for each walker.
    AdjustsGiven { key: String },
    /// The mass of this drive does not depend on the weight of a walker.
    MassNotAdjustable,
    /// The force of this drive does not scale with the speed. Its spring, damping and inertia forces depend on the speed in different ways.
    SpeedNotAdjustable,
    /// The setting is not supported for several walkers.
    NotOfPopulation,
    /// A design for several walkers includes neither motor nor floor.
    MachineOfPopulation,
    /// Several cams are requested for one walker.
    OneWalker,
    /// The solver failed with this error.
    SearchFailed { fault: String },
    /// The number of harmonics is too large for the samples of the force.
    TooManyHarmonics { samples: usize, most: usize },
    /// Spring and inertia cancel at a harmonic of the force.
    Resonance { harmonic: usize },
    /// A key that the kind of follower requires is missing.
    FollowerNeeds,
    /// A range of angles is not within one turn.
    NoRange { start: Quantity, end: Quantity },
    /// There are more conditions than the degree of the polynomial allows.
    DegreeTooLow {
        conditions: usize,
        fixed: usize,
        degree: usize,
        excess: usize,
    },
    /// There are fewer conditions than the degree of the polynomial requires.
    DegreeTooHigh {
        conditions: usize,
        fixed: usize,
        degree: usize,
        missing: usize,
    },
    /// The number of conditions exceeds the maximum.
    ManyDemands { given: usize, most: usize },
    /// The law is not closed: its last lift differs from its first lift.
    LawOpen { rise: Quantity },
    /// With this drive, a force does not determine a lift.
    ForceGivesNoLift,
    /// The points of the law prescribe no value.
    PointsEmpty,
    /// The family of the law requires a target force.
    FamilyNeedsForce,
    /// No double harmonic approximates the force better than a constant lift.
    DoubleHarmonicUseless,
    /// Two dwells overlap in cam angle.
    DwellsOverlap,
    /// The dwells fill the whole turn.
    DwellsFillTurn,
    /// A point lies outside the turn.
    PointOutside { at: Quantity },
}

/// Reasons why no cam satisfies a scene.
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named in the messages
pub enum NoDesignError {
    /// No law exists even without the limits. The reason is a serialised [`Reason`](crate::synth::Reason).
    NoLaw { reason: Value },
    /// The law does not have a constant breadth.
    NoConstantBreadth {
        sum: Quantity,
        miss: Quantity,
        at: Quantity,
    },
    /// The breadth is too small for base circle and lift.
    BreadthTooSmall { breadth: Quantity, lift: Quantity },
    /// No prime circle satisfies the limits.
    NoPrimeCircle,
    /// The search found no double harmonic law.
    NoDoubleHarmonic,
}
