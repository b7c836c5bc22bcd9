//! Errors of a force curve, a load model or a mean cycle.

use serde::Serialize;
use strum::VariantNames;

use super::Fault;
use crate::units::Quantity;
use crate::wording::{Catalogue, WORDS};

/// Errors for which no force curve can be computed.
///
/// ```
/// use gaitcam_gait::ForceCurve;
/// use gaitcam_gait::error::ForceError;
///
/// let error = ForceCurve::from_samples("short", 1.0, vec![700.0; 3]).unwrap_err();
/// assert_eq!(error.fault(), Some(&ForceError::FewSamples { samples: 3 }));
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named in the messages
pub enum ForceError {
    /// A cycle has fewer than four samples.
    FewSamples { samples: usize },
    /// The numbers of times and forces differ.
    Lengths { times: usize, forces: usize },
    /// A sample is not a finite number.
    SampleNotFinite { sample: usize },
    /// The period is not positive.
    PeriodNotPositive { period: Quantity },
    /// The word is not a name of feet, such as `both` or `left`.
    UnknownFeet { word: String },
    /// The word is not a kind of movement, such as `walking`.
    UnknownKind { word: String },
    /// The word does not name a question that the user may accept: `kind`, `clock` or `mass`.
    UnknownDoubt { word: String },
    /// No recording contains a cycle that the joint mean can include.
    NoJointMean { trials: usize },
    /// The unit of force is unknown.
    UnknownUnit { word: String },
    /// The load model is unknown.
    UnknownModel { name: String, known: String },
    /// The load model is unknown, but a model with a similar name exists.
    MisspeltModel { name: String, near: String },
    /// The body weight is not positive.
    WeightNotPositive { weight: Quantity },
    /// The step frequency is outside the range of the load model.
    FrequencyOutOfRange {
        model: String,
        frequency: Quantity,
        low: Quantity,
        high: Quantity,
    },
    /// The load model requires a step frequency.
    FrequencyMissing { model: String },
    /// The load model describes only both feet together.
    BothFeetOnly { model: String },
    /// The unit of the time column was assumed, but the resulting stride time is implausible.
    ClockImplausible { period: Quantity },
    /// The recording shows running, which was not requested.
    Running { duration: Quantity },
    /// The recording shows a movement other than walking or running.
    NotWalking {
        movement: &'static str,
        duration: Quantity,
    },
    /// The column contains the total of both feet, but one foot was requested.
    TotalOfBothFeet { duration: Quantity },
    /// No contact of the recording is a whole walking stance.
    NoStance {
        duration: Quantity,
        contacts: usize,
        from: Quantity,
        to: Quantity,
        reason: &'static str,
    },
    /// The file contains fewer rows or frames than announced, and no whole stance.
    NoStanceFileCut {
        duration: Quantity,
        announced: usize,
        found: usize,
        reason: &'static str,
    },
    /// There is no contact. The maximum reading suggests newtons per kilogram instead of newtons.
    ForceTooLow { duration: Quantity, peak: Quantity },
    /// Every channel is unloaded, constant or empty.
    NoLiveChannel { duration: Quantity },
    /// The force of no channel exceeds the contact threshold.
    NoContact { duration: Quantity },
    /// The population has no walkers.
    NoWalkers,
    /// The statistical weight or the mean force of a walker is not positive.
    WalkerImpossible { walker: String },
    /// A table of walkers lacks a column.
    WalkerColumnMissing { column: &'static str },
    /// A value in a table of walkers is not a number.
    WalkerValue { column: String, value: String },
    /// All stances belong to the foot that was not requested.
    NoStanceOfFoot { foot: &'static str },
    /// The left or the right foot was requested, but the feet of the stances are unknown.
    FeetNotNamed { foot: &'static str },
}

impl Fault for ForceError {
    const AREA: &'static str = "force";
    const WORDS: &'static Catalogue = &WORDS;
}
