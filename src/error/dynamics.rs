//! Errors in the input of a simulation, and cases that its models do not support.

use serde::Serialize;
use strum::VariantNames;

use crate::units::Quantity;

/// Errors in a machine, in an output profile or in the requested model.
///
/// ```
/// use gaitcam::drive::Drive;
/// use gaitcam::dynamics::flexible::Train;
/// use gaitcam::error::DynamicsError;
///
/// // The natural frequency is undefined without a mass.
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
    /// A value of the machine data is out of range.
    Machine,
    /// The coefficient of friction is invalid.
    Friction { friction: f64 },
    /// The length of the line contact or a material constant is invalid.
    ContactLine,
    /// The target force is empty or not finite.
    Target,
    /// An open law cannot run backwards.
    SlideBackwards,
    /// Follower and law do not allow a second cam on the shaft.
    SecondCam,
    /// The coefficient of restitution is invalid.
    Restitution { restitution: f64 },
    /// The profile has too few points.
    FewRows { rows: usize },
    /// The angles of the profile points are not equally spaced.
    RowAngle {
        row: usize,
        at: Quantity,
        expected: Quantity,
    },
    /// The follower cannot touch a point of the profile.
    RowReach { row: usize, follower: &'static str },
    /// The profile is undercut or concave under a flat face.
    Concave { at: Quantity, radius: Quantity },
    /// The natural frequency or the damping ratio is invalid.
    Frequency { frequency: f64, ratio: f64 },
    /// A natural frequency is given, but the mass is zero, as for a column of fluid (`fluid`).
    FrequencyWithoutMass { fluid: bool },
    /// The stiffness or the damping is invalid.
    Train,
    /// The natural frequency of an undamped follower equals a harmonic of the cam's rotation.
    Resonance { cycles: f64 },
    /// The flexible model requires a stiffness.
    NoTrain,
    /// An open law has no steady vibration.
    OpenVibration,
    /// The groove constrains the roller from both sides, so the roller cannot lift off.
    HeldByGroove,
    /// The conjugate pair constrains the follower from both sides, so the follower cannot lift off.
    HeldByPair,
    /// The contact model requires a cam that turns once per cycle.
    NotOneTurn,
    /// A value of the motor data is out of range.
    Motor,
    /// A motor is combined with several cams or with a law that is not over one turn.
    MotorTurns,
    /// The shaft stops within a turn.
    Stalls { inertia: Quantity, needed: Quantity },
    /// The shaft stops within a turn for any inertia.
    StallsAnyway,
    /// The no-load speed of the motor is too low.
    NoLoadSpeed {
        nominal: Quantity,
        needed: Quantity,
        speed: Quantity,
    },
    /// A speed programme has too few rows.
    FewProgrammeRows { rows: usize },
    /// The time of a row of a speed programme does not increase, or its speed is not positive.
    ProgrammeRow { row: usize },
    /// A speed programme requires a rotating cam whose law closes in one turn.
    ProgrammeTurns,
    /// No speed programme satisfies the limit on the acceleration.
    ProgrammeAcceleration { most: Quantity },
    /// The follower loses contact, or the force is below its limit, at any speed of the programme.
    ProgrammeContact { least: Quantity, limit: Quantity },
    /// The motor cannot deliver the required torque at a speed of the programme.
    ProgrammeMotor {
        torque: Quantity,
        speed: Quantity,
        at: Quantity,
    },
    /// The shaft stops under a commanded speed.
    ProgrammeStops { at: Quantity },
    /// An undamped mode of the floor coincides with a harmonic of the force.
    FloorResonance {
        harmonic: usize,
        frequency: Quantity,
    },
    /// The contact model does not support a varying shaft speed.
    ContactUnderMotor,
    /// Only the rigid model supports a moving floor.
    FloorNotRigid,
    /// No common steady motion of shaft and floor was found.
    FloorAndShaft,
    /// A polydyne cam requires a closed law.
    OpenPolydyne,
    /// The target of a polydyne cam is not smooth enough.
    PolydyneJump {
        derivative: &'static str,
        at: Quantity,
    },
}
