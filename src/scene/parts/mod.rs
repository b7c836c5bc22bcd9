//! The sections of a scene file, with one type for each section.

mod cam;
mod drive;
mod floor;
mod gait;
mod harmonic;
mod law;
mod limits;
mod machine;
mod machine_floor;
mod population;

pub use cam::{CamSpec, KeywaySpec};
pub use drive::DriveSpec;
pub use gait::{Band, ForceScale, Gait, Phase, PhaseWeight, Source};
pub use harmonic::Harmonic;
pub use law::{Dwell, Family, LawPoint, LawSpec, Minimise, SegmentSpec, ShaftSpeed};
pub use limits::Limits;
pub use machine::{MachineSpec, MotorSpec};
pub use population::{Adjust, ErrorMeasure, Robust, StepFrequencies};
