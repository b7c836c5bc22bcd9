//! Sweeps: one question asked of thousands of scenes.
//!
//! A [`Plan`] says which scenes: a grid, a list or a sample over scene keys. The [`Kernel`] turns a
//! [`Batch`] of parameters into [`Results`], row by row and without side effects, so that any number of
//! threads, processes or machines may share the work. [`table`] writes
//! results down. Reading and writing files is the command's business.

mod axis;
mod batch;
mod front;
mod kernel;
mod key;
mod plan;
mod results;
mod sample;
pub mod table;
mod tolerance;

pub use axis::{Axis, AxisValue, Values};
pub use batch::{Batch, Column};
pub use front::{Front, Point, objective};
pub use kernel::{Clock, Halts, Kernel, Targets};
pub use key::Key;
pub use plan::{Difference, List, NamedScene, Plan, Sampling, differences};
pub use results::{NUMBERS, Outcome, Results, Row, TIME, WORDS};
pub use sample::Method;
pub use tolerance::{Made, Part, Scatter, Spread, Tolerance};
