//! Faults in the input: what is wrong, where it is, and what would be right.
//!
//! An error is data: a place and a fault with fields. Each area of the library has a file here with its faults;
//! their sentences stand in `wording/en/AREA.ftl`, the help as the attribute `.help`. A bad cam is not an error but a
//! [`Verdict`](crate::cam::Verdict), an impossible one is an [`Infeasible`](crate::synth::Infeasible) answer, and a panic is
//! an internal error.

mod cam;
mod dynamics;
mod file;
mod law;
mod log;
mod scene;
mod sweep;
mod synth;
mod write;

use crate::wording::{Catalogue, WORDS};

pub use cam::{ArmFault, CamError, CamLength};
pub use dynamics::DynamicsError;
pub use file::FileError;
pub use gaitcam_base::error::{Error, Fault, Place, Placed, Result, UnitsError, nearest};
pub use gaitcam_gait::error::{CycleColumn, FileKind, ForceError, ReadError};
pub use law::{JoinCure, LawError, SegmentName};
pub use log::LogError;
pub use scene::SceneError;
pub use sweep::SweepError;
pub use synth::SynthError;
pub use write::WriteError;

/// Whether an error says that no cam does what a scene asks, or that no new one would be better, rather than that the input
/// cannot be read.
///
/// ```
/// use gaitcam::error::is_no_cam;
/// use gaitcam::scene;
///
/// // The arm would swing beyond the line through pivot and cam centre.
/// let arm = scene::built_in("camdas_02_oscillating_roller")?.scene()?;
/// let impossible = arm.with("law.segment.1.lift", "170 deg")?.with("law.segment.3.lift", "-170 deg")?;
/// assert!(is_no_cam(&impossible.design().unwrap_err()));
/// assert!(!is_no_cam(&arm.with("law.segment.1.lift", "long").unwrap_err()));
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
pub fn is_no_cam(error: &Error) -> bool {
    use {CamError as C, LawError as L, SynthError as S};
    let of_cam = |fault: &C| {
        matches!(
            fault,
            C::RollerFillsCam { .. }
                | C::Offset { .. }
                | C::BelowCentre { .. }
                | C::FaceReach { .. }
                | C::ArmReach { .. }
                | C::Swing { .. }
                | C::FaceSpeed { .. }
                | C::PivotInside { .. }
                | C::SecondCam { .. }
                | C::NoConjugate { .. }
                | C::NoSize { .. }
                | C::GrooveDepth { .. }
                | C::GrooveRollers { .. }
                | C::GrooveFloor { .. }
        )
    };
    let of_law = |fault: &L| {
        matches!(
            fault,
            L::LiftJump { .. } | L::VelocityJump { .. } | L::BelowBaseCircle { .. }
        )
    };
    let of_synthesis = |fault: &S| {
        matches!(
            fault,
            S::NoLaw { .. }
                | S::NoConstantBreadth { .. }
                | S::BreadthTooSmall { .. }
                | S::NoPrimeCircle
                | S::NoDoubleHarmonic
        )
    };
    let of_log = |fault: &LogError| matches!(fault, LogError::Noise { .. });
    error.fault().is_some_and(of_cam)
        || error.fault().is_some_and(of_log)
        || error.fault().is_some_and(of_law)
        || error.fault().is_some_and(of_synthesis)
}

/// Areas of faults with their enums.
macro_rules! faults {
    ($($area:literal => $fault:ty),* $(,)?) => {
        $(impl Fault for $fault {
            const AREA: &'static str = $area;
            const WORDS: &'static Catalogue = &WORDS;
        })*
    };
}

faults! {
    "cam" => CamError,
    "dynamics" => DynamicsError,
    "file" => FileError,
    "law" => LawError,
    "log" => LogError,
    "scene" => SceneError,
    "sweep" => SweepError,
    "synth" => SynthError,
    "write" => WriteError,
}
