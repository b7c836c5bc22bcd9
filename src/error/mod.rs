//! Errors in the input, each with message, location and suggested change.
//!
//! An error contains a location and a variant of an enum. The fields of the variant are the values in the message. Each file of this folder
//! contains the enum of one area, such as the cam or the law. The messages of an area are in `wording/en/AREA.ftl`. The attribute `.help` of
//! a message contains the suggested change.
//!
//! A cam that fails a check is not an error: its [`Verdict`](crate::cam::Verdict) is unacceptable. Infeasible limits are reported as
//! [`Infeasible`](crate::synth::Infeasible). A panic is an internal error.

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

pub use cam::CamInputError;
pub(crate) use cam::{ArmFault, CamError, CamLength};
pub use dynamics::DynamicsError;
pub use file::FileError;
pub use gaitcam_base::error::{Error, Fault, Place, Placed, Result, nearest};
pub use gaitcam_gait::error::{ForceError, ReadError};
pub(crate) use law::SegmentName;
pub use law::{JoinCure, JoinError, LawError};
pub(crate) use log::{LogError, NoNewCamError};
pub use scene::SceneError;
pub use sweep::SweepError;
pub(crate) use synth::NoDesignError;
pub use synth::SynthError;
pub use write::WriteError;

/// Implements [`Fault`] for the error enums. Each row contains the area, the enum, and whether the errors of this enum mean that no cam
/// satisfies the scene.
macro_rules! faults {
    ($($area:literal => $fault:ty, $answer:literal);* $(;)?) => {
        $(impl Fault for $fault {
            const AREA: &'static str = $area;
            const WORDS: &'static Catalogue = &WORDS;
            const IS_ANSWER: bool = $answer;
        })*
    };
}

faults! {
    "cam" => CamError, true;
    "cam" => CamInputError, false;
    "dynamics" => DynamicsError, false;
    "file" => FileError, false;
    "law" => JoinError, true;
    "law" => LawError, false;
    "log" => LogError, false;
    "log" => NoNewCamError, true;
    "scene" => SceneError, false;
    "sweep" => SweepError, false;
    "synth" => NoDesignError, true;
    "synth" => SynthError, false;
    "write" => WriteError, false;
}
