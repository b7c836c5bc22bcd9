//! Force curves: where the wanted vertical force comes from.

mod average;
mod catalogue;
mod clean;
mod contact;
mod curve;
mod cycle;
mod describe;
mod doubt;
mod feet;
mod models;
mod overlay;
mod read;
mod recording;
mod shape;
mod single_foot;
mod stance;
mod stride;
mod stride_time;
mod total;
mod verdict;

pub use catalogue::{ModelInfo, Status, catalogue};
pub use curve::ForceCurve;
pub use cycle::{Cycle, cycle};
pub use describe::{csv, cycle_json, cycle_table, json, spread_rms_n, table};
pub use doubt::doubt;
pub use feet::Feet;
pub use models::{SAMPLES, fourier, model};
pub use overlay::{Overlay, overlay};
pub use read::{force_curve, metadata_name, one_cycle, read};
pub use recording::{Channel, Foot, ForceUnit, ReadOptions, Recording, Row, Strike};
pub use stance::{Point, Rejected, Stance, Stances, Why, stances};
