//! Faults in the lengths of a cam and its follower: no cam has them.

use serde::Serialize;
use strum::VariantNames;

use crate::quantity::Quantity;

/// What is wrong with a follower, a size, a conjugate pair or a groove.
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
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[allow(missing_docs)] // the names are the documentation
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

/// Why an arm does not lie on its prime circle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[allow(missing_docs)] // the names are the documentation
pub enum ArmFault {
    Short,
    Long,
    Apart,
}
