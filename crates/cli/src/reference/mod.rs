//! Reference output: keys, scenes, laws, completions.

pub mod completions;
pub mod keys;
pub mod laws;
