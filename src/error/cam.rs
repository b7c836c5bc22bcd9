//! Errors in the dimensions of a cam and its follower.

use serde::Serialize;
use serde_json::Value;
use strum::VariantNames;

use crate::units::Quantity;

/// Reasons why a follower, a size, a conjugate pair or a groove is impossible.
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named in the messages
pub enum CamError {
    /// The radius of the roller or arc is not smaller than the prime radius.
    RollerFillsCam { radius: Quantity, prime: Quantity },
    /// The offset is not smaller than the prime radius.
    Offset { offset: Quantity, prime: Quantity },
    /// The law reaches a position below the centre of the cam.
    BelowCentre {
        lift: Quantity,
        height: Quantity,
        least: Quantity,
    },
    /// An oscillating flat face cannot touch its base circle.
    FaceReach {
        offset: Quantity,
        base: Quantity,
        pivot: Quantity,
        least: Quantity,
    },
    /// An arm does not reach its prime circle.
    ArmReach {
        arm: Quantity,
        fault: ArmFault,
        prime: Quantity,
        pivot: Quantity,
        least: Quantity,
        most: Quantity,
    },
    /// The arm swings beyond its dead-centre positions.
    Swing {
        from: Quantity,
        to: Quantity,
        dead: [Quantity; 2],
        start: Quantity,
        rise: Quantity,
        fall: Quantity,
    },
    /// The arm of a flat face turns at least as fast as the cam.
    FaceSpeed { at: Quantity, speed: f64 },
    /// The pivot lies inside the cam.
    PivotInside {
        pivot: Quantity,
        reach: Quantity,
        at: Quantity,
    },
    /// The second cam of a pair does not exist. `because` is the serialised error of the second cam.
    SecondCam { because: Value },
    /// No second cam exists for this total distance or angle of the pair.
    NoConjugate {
        total: Quantity,
        reach: Quantity,
        least: Option<Quantity>,
        base: Option<Quantity>,
    },
    /// No base radius satisfies the limits.
    NoSize { follower: &'static str },
    /// The floor of a groove is not below the surface of the barrel.
    GrooveDepth { floor: Quantity, surface: Quantity },
    /// The radius or the eccentricity of the rollers is invalid for a groove.
    GrooveRollers {
        radius: Quantity,
        eccentricity: Quantity,
    },
    /// The radius of the roller is too large for the floor radius of its groove.
    GrooveFloor { radius: Quantity, floor: Quantity },
}

/// Errors in dimensions given by the user, or in measured profile points.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::error::CamInputError;
/// use gaitcam::law::Law;
///
/// let follower = Follower::RollerTranslating { prime_radius: -0.05, offset: 0.0, roller_radius: 0.01 };
/// let error = Cam::new(Law::harmonic(0.0, &[]), follower).unwrap_err();
/// assert!(matches!(error.fault(), Some(CamInputError::NotPositive { .. })));
/// assert!(!error.is_answer());
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named in the messages
pub enum CamInputError {
    /// A length is not positive.
    NotPositive { length: CamLength, value: Quantity },
    /// A length is not a finite number.
    NotFinite { length: CamLength },
    /// A pair of oscillating followers is given by a distance instead of an angle.
    ArmsByDistance,
    /// A pair of translating followers is given by an angle instead of a distance.
    SlidesByAngle,
    /// There is no conjugate cam for this kind of follower.
    NoConjugateOf { follower: &'static str },
    /// The base height of a translating cam has no minimum, because curvature and pressure angle do not depend on this height.
    TranslatingHeight,
    /// There are too few measured points.
    MeasuredFew { points: usize, least: usize },
    /// A measured point is not finite.
    MeasuredNotFinite { row: usize },
    /// The cam does not rotate. Only the profile of a rotating cam can be fitted to measured points.
    MeasuredUnrolled { follower: &'static str },
    /// The measured points are on a circle, so they do not determine the zero angle.
    MeasuredCircle,
    /// The points fit the mirror image of the cam.
    MeasuredMirror {
        distance: Quantity,
        mirrored: Quantity,
    },
    /// The measured points do not belong to this cam, because their distance from its profile is too large.
    MeasuredOther {
        distance: Quantity,
        low: Quantity,
        high: Quantity,
    },
}

/// Dimension of a follower or cam that a message names, such as the roller radius.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[allow(missing_docs)] // the names are the documentation
#[non_exhaustive]
pub enum CamLength {
    RollerRadius,
    ArcRadius,
    PivotDistance,
    Arm,
    BaseHeight,
    BarrelRadius,
    PrimeRadius,
    Offset,
    FaceOffset,
}

/// Reasons why an arm does not reach its prime circle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[allow(missing_docs)] // the names are the documentation
#[non_exhaustive]
pub enum ArmFault {
    Short,
    Long,
    Apart,
}
