//! Scenes: key table compared with reader, writer, changes, sweeps and the schema for editors.

mod harmonics;
pub mod random;
mod table;
mod workshop;
