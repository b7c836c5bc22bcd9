//! Scenes: the key table against the reader, the writer, changes, sweeps and the editors' schema.

mod harmonics;
pub mod random;
mod table;
