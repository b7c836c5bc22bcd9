//! What there is: keys, scenes, laws, manual pages, completions.

pub mod completions;
pub mod keys;
pub mod laws;
pub mod manual;
