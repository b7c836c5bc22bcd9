//! Sweeps: one question asked of thousands of scenes.
//!
//! A [`Plan`] says which scenes: a grid, a list or a sample over scene keys. The [`Kernel`] turns a
//! [`Batch`] of parameters into [`Results`], row by row and without side effects, so that any number of
//! threads, processes or machines may share the work. [`table`] writes
//! results down. Reading and writing files is the command's business.

mod axis;
mod batch;
mod difference;
mod front;
mod kernel;
mod key;
mod measured;
mod over;
mod plan;
mod records;
mod results;
mod runner;
mod sample;
mod scatter;
mod study;
pub mod table;
mod tolerance;

pub use axis::{Axis, AxisValue, Values};
pub use difference::{Difference, agree, differences};
pub use front::{Admission, Front, Objective, Point, objective};
pub use key::Key;
pub use measured::{Behaviour, MadeCam};
pub use over::Sweep;
pub use plan::{List, NamedScene, Plan, Sampling};
pub use records::{Field, Records, Values as FieldValues, Words};
pub use results::{NUMBERS, Outcome, Row, TIME, WORDS};
pub use runner::Runner;
pub use sample::Method;
pub use scatter::{SAMPLE_COLUMNS, Scattered};
pub use study::{Files, Study, Subject};
pub use tolerance::{Made, Part, Scatter, Spread, Tolerance};
