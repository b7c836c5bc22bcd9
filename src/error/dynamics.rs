//! Faults in what a simulation is given, and what its models cannot answer.

use serde::Serialize;
use strum::VariantNames;

use crate::units::Quantity;

/// What is wrong with a machine, an emitted profile or the model asked for.
///
/// ```
/// use gaitcam::drive::Drive;
/// use gaitcam::dynamics::Train;
/// use gaitcam::error::DynamicsError;
///
/// // Without a mass nothing has a natural frequency.
/// let weightless = Drive::fixed_axis(0.0, 1000.0, 10.0);
/// let error = Train::from_frequency(&weightless, 50.0, 0.05).unwrap_err();
/// assert_eq!(error.fault(), Some(&DynamicsError::FrequencyWithoutMass));
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)] // the messages of wording/en/dynamics.ftl say what each field is
pub enum DynamicsError {
    Machine,
    Friction {
        friction: f64,
    },
    ContactLine,
    Target,
    SlideBackwards,
    SecondCam,
    Restitution {
        restitution: f64,
    },
    FewRows {
        rows: usize,
    },
    RowAngle {
        row: usize,
        at: Quantity,
        expected: Quantity,
    },
    RowReach {
        row: usize,
        follower: &'static str,
    },
    Concave {
        at: Quantity,
        radius: Quantity,
    },
    Frequency {
        frequency: f64,
        ratio: f64,
    },
    FrequencyWithoutMass,
    Train,
    Resonance {
        cycles: f64,
    },
    NoTrain,
    OpenVibration,
    HeldByGroove,
    HeldByPair,
    NotOneTurn,
    OpenPolydyne,
    PolydyneJump {
        derivative: &'static str,
        at: Quantity,
    },
}
