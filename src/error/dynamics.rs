//! Faults in the input of a simulation, and cases outside its models.

use serde::Serialize;
use strum::VariantNames;

use crate::units::Quantity;

/// Faults of a machine, an emitted profile or the requested model.
///
/// ```
/// use gaitcam::drive::Drive;
/// use gaitcam::dynamics::flexible::Train;
/// use gaitcam::error::DynamicsError;
///
/// // Without a mass nothing has a natural frequency.
/// let weightless = Drive::fixed_axis(0.0, 1000.0, 10.0);
/// let error = Train::from_frequency(&weightless, 50.0, 0.05).unwrap_err();
/// assert_eq!(error.fault(), Some(&DynamicsError::FrequencyWithoutMass { fluid: false }));
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named in the messages
pub enum DynamicsError {
    /// Machine data out of range.
    Machine,
    /// Invalid coefficient of friction.
    Friction { friction: f64 },
    /// Invalid contact line or material.
    ContactLine,
    /// The target force is empty or not finite.
    Target,
    /// An open law cannot run backwards.
    SlideBackwards,
    /// Follower and law do not allow a second cam on the shaft.
    SecondCam,
    /// Invalid coefficient of restitution.
    Restitution { restitution: f64 },
    /// Too few points of a profile.
    FewRows { rows: usize },
    /// A point of the profile deviates from its equal step.
    RowAngle {
        row: usize,
        at: Quantity,
        expected: Quantity,
    },
    /// The follower cannot touch a point of the profile.
    RowReach { row: usize, follower: &'static str },
    /// The profile is undercut or concave under a flat face.
    Concave { at: Quantity, radius: Quantity },
    /// Invalid natural frequency or damping ratio.
    Frequency { frequency: f64, ratio: f64 },
    /// A natural frequency needs a mass, but a column of fluid has none.
    FrequencyWithoutMass { fluid: bool },
    /// Invalid stiffness or damping.
    Train,
    /// An undamped natural frequency equals a harmonic.
    Resonance { cycles: f64 },
    /// The flexible model needs a stiffness.
    NoTrain,
    /// An open law has no steady vibration.
    OpenVibration,
    /// A groove holds the roller from both sides.
    HeldByGroove,
    /// A conjugate pair holds the follower from both sides.
    HeldByPair,
    /// The contact model needs a law of one turn.
    NotOneTurn,
    /// Motor data out of range.
    Motor,
    /// A motor supports only one cam with a law of one turn.
    MotorTurns,
    /// The shaft does not keep turning.
    Stalls { inertia: Quantity, needed: Quantity },
    /// The shaft does not keep turning with any inertia.
    StallsAnyway,
    /// The no-load speed of the motor is too low.
    NoLoadSpeed {
        nominal: Quantity,
        needed: Quantity,
        speed: Quantity,
    },
    /// An undamped mode of the floor coincides with a harmonic of the force.
    FloorResonance {
        harmonic: usize,
        frequency: Quantity,
    },
    /// The contact model does not support a varying shaft speed.
    ContactUnderMotor,
    /// Only the rigid model supports a moving floor.
    FloorNotRigid,
    /// No steady motion of shaft and floor was found.
    FloorAndShaft,
    /// A polydyne cam needs a closed law.
    OpenPolydyne,
    /// The target of a polydyne cam is not smooth enough.
    PolydyneJump {
        derivative: &'static str,
        at: Quantity,
    },
}
