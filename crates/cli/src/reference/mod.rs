//! What there is: keys, scenes, laws, completions.

pub mod completions;
pub mod keys;
pub mod laws;
