//! Errors in writing a design: files, drawings and solids.

use serde::Serialize;
use strum::VariantNames;

use crate::units::Quantity;

/// Reasons why a file cannot be created or written.
///
/// ```
/// use gaitcam::error::{Placed, WriteError};
/// use gaitcam::units::Quantity;
///
/// let error = WriteError::PlateThickness { thickness: Quantity::length(0.0) }.in_file("cam.stl".as_ref());
/// assert_eq!(error.code(), "write-plate-thickness");
/// assert!(error.to_string().starts_with("cam.stl: "));
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, VariantNames)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named in the messages
pub enum WriteError {
    FolderRefuses {
        fault: String,
    },
    FileRefuses {
        fault: String,
    },
    NotPutTogether {
        fault: String,
    },
    PlateThickness {
        thickness: Quantity,
    },
    TooFewPoints {
        points: usize,
        least: usize,
    },
    OpenProfile,
    BarrelSolid,
    UndercutProfile,
    ProfileFolds,
    BoreTooLarge {
        bore: Quantity,
        free: Quantity,
    },
    CutterRadius {
        radius: Quantity,
    },
    DepthOfPass {
        pass: Quantity,
        least: Quantity,
    },
    TooSharp,
    NoCutterPath,
    GrooveCutter {
        radius: Quantity,
        roller: Quantity,
    },
    WireTooThick {
        radius: Quantity,
    },
    EcamIntervals {
        asked: usize,
        least: usize,
        most: usize,
    },
    EcamPoints {
        dialect: String,
        points: usize,
        error: Quantity,
        allowed: Quantity,
        better: usize,
        to: Quantity,
    },
    EcamLaw {
        dialect: String,
        points: usize,
        error: Quantity,
        allowed: Quantity,
    },
    EcamOfMotor,
    /// The controller does not accept the name.
    EcamName {
        name: String,
        longest: usize,
    },
}
