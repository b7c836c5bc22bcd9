//! Commands that print reference information: keys, scenes, laws, completion scripts.

pub mod completions;
pub mod keys;
pub mod laws;
