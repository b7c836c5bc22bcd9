//! Sweeps: designs of thousands of scenes.
//!
//! A [`Plan`] defines the scenes as a grid, a list or a sample over scene keys. A [`Sweep`] is a plan with the content of its recordings.
//! It computes any range of its rows without side effects, so threads, processes or machines can share the work. [`Records`] contain the
//! rows as a table. The caller reads and writes files.

mod carried;
mod content;
pub(crate) mod difference;
mod front;
mod kernel;
mod made;
mod plan;
mod runner;
pub mod table;

pub use carried::Files;
pub use content::{Subject, Sweep};
pub use difference::agree;
pub use front::{Admission, Front, Objective, Point};
pub use made::measured::{Behaviour, MadeCam};
pub use made::scatter::Scattered;
pub use made::tolerance::{Part, Scatter, Spread, Tolerance, ToleranceSample};
pub use plan::axis::{Axis, Values};
pub use plan::key::Key;
pub use plan::sample::Method;
pub use plan::{List, NamedScene, Plan, Sampling};
pub use runner::Runner;
pub use table::records::{Field, Records, Values as FieldValues, Words};
pub use table::results::{NUMBERS, Outcome, Row, TIME, WORDS};
