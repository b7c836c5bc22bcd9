//! Sweeps: one question asked of thousands of scenes.
//!
//! A [`Plan`] says which scenes: a grid, a list or a sample over scene keys; [`Sweep`] makes one in three lines. The
//! [`Runner`] computes its rows without side effects, so that any number of threads, processes or machines may share
//! the work. [`Records`] are the rows as a table. Reading and writing files is the caller's business.

mod difference;
mod front;
mod kernel;
mod made;
mod over;
mod plan;
mod runner;
mod study;
pub mod table;

pub use difference::{Difference, agree, differences};
pub use front::{Admission, Front, Objective, Point, objective};
pub use made::measured::{Behaviour, MadeCam};
pub use made::scatter::{SAMPLE_COLUMNS, Scattered};
pub use made::tolerance::{Made, Part, Scatter, Spread, Tolerance};
pub use over::Sweep;
pub use plan::axis::{Axis, AxisValue, Values};
pub use plan::key::Key;
pub use plan::sample::Method;
pub use plan::{List, NamedScene, Plan, Sampling};
pub use runner::Runner;
pub use study::{Files, Study, Subject};
pub use table::records::{Field, Records, Values as FieldValues, Words};
pub use table::results::{NUMBERS, Outcome, Row, TIME, WORDS};
