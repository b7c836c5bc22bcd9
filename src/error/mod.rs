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
pub use scene::SceneError;
pub use sweep::SweepError;
pub use synth::SynthError;
pub use write::WriteError;

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
    "scene" => SceneError,
    "sweep" => SweepError,
    "synth" => SynthError,
    "write" => WriteError,
}
