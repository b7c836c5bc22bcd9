//! Faults in the lengths of a cam and its follower: no cam has them.

use serde::Serialize;
use strum::VariantNames;

use crate::units::Quantity;

/// What is wrong with a follower, a size, a conjugate pair or a groove.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::error::CamError;
/// use gaitcam::law::Law;
///
/// // A roller as large as its prime circle leaves no cam.
/// let follower = Follower::RollerTranslating { prime_radius: 0.01, offset: 0.0, roller_radius: 0.01 };
/// let error = Cam::new(Law::harmonic(0.0, &[]), follower).unwrap_err();
/// let Some(CamError::RollerFillsCam { radius, .. }) = error.fault() else { panic!("{error}") };
/// assert_eq!(radius.value, 0.01);
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)] // the messages of wording/en/cam.ftl say what each field is
pub enum CamError {
    NotPositive {
        length: CamLength,
        value: Quantity,
    },
    NotFinite {
        length: CamLength,
    },
    RollerFillsCam {
        radius: Quantity,
        prime: Quantity,
    },
    Offset {
        offset: Quantity,
        prime: Quantity,
    },
    BelowCentre {
        lift: Quantity,
        height: Quantity,
        least: Quantity,
    },
    FaceReach {
        offset: Quantity,
        base: Quantity,
        pivot: Quantity,
        least: Quantity,
    },
    ArmReach {
        arm: Quantity,
        fault: ArmFault,
        prime: Quantity,
        pivot: Quantity,
        least: Quantity,
        most: Quantity,
    },
    Swing {
        from: Quantity,
        to: Quantity,
        dead: [Quantity; 2],
        start: Quantity,
        rise: Quantity,
        fall: Quantity,
    },
    FaceSpeed {
        at: Quantity,
        speed: f64,
    },
    PivotInside {
        pivot: Quantity,
        reach: Quantity,
        at: Quantity,
    },
    ArmsByDistance,
    SlidesByAngle,
    NoConjugateOf {
        follower: &'static str,
    },
    SecondCam {
        because: Box<CamError>,
    },
    NoConjugate {
        total: Quantity,
        reach: Quantity,
        least: Option<Quantity>,
        base: Option<Quantity>,
    },
    TranslatingHeight,
    NoSize {
        follower: &'static str,
    },
    GrooveDepth {
        floor: Quantity,
        surface: Quantity,
    },
    GrooveRollers {
        radius: Quantity,
        eccentricity: Quantity,
    },
    GrooveFloor {
        radius: Quantity,
        floor: Quantity,
    },
    MeasuredFew {
        points: usize,
        least: usize,
    },
    MeasuredNotFinite {
        row: usize,
    },
    MeasuredUnrolled {
        follower: &'static str,
    },
    MeasuredCircle,
    MeasuredOther {
        distance: Quantity,
        low: Quantity,
        high: Quantity,
    },
}

/// A length of a follower or cam.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::error::{CamError, CamLength};
/// use gaitcam::law::Law;
///
/// let follower = Follower::RollerTranslating { prime_radius: 0.05, offset: f64::NAN, roller_radius: 0.01 };
/// let error = Cam::new(Law::harmonic(0.0, &[]), follower).unwrap_err();
/// assert_eq!(error.fault(), Some(&CamError::NotFinite { length: CamLength::Offset }));
/// ```
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

/// Why an arm does not reach its prime circle.
///
/// ```
/// use gaitcam::cam::{Cam, Follower};
/// use gaitcam::error::{ArmFault, CamError};
/// use gaitcam::law::Law;
///
/// // An arm of 20 mm about a pivot 130 mm away does not reach a prime circle of 68 mm: it has to be 62 mm.
/// let follower = Follower::RollerOscillating { pivot_distance: 0.13, arm: 0.02, prime_radius: 0.068, roller_radius: 0.01 };
/// let error = Cam::new(Law::harmonic(0.0, &[]), follower).unwrap_err();
/// let Some(CamError::ArmReach { fault, least, .. }) = error.fault() else { panic!("{error}") };
/// assert_eq!(fault, &ArmFault::Short);
/// assert!((least.value - 0.062).abs() < 1e-12);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[allow(missing_docs)] // the names are the documentation
#[non_exhaustive]
pub enum ArmFault {
    Short,
    Long,
    Apart,
}
