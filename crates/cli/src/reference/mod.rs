//! What there is: keys, scenes, laws, manual pages, completions.

#[cfg(feature = "shell")]
pub mod completions;
pub mod keys;
pub mod laws;
#[cfg(feature = "shell")]
pub mod manual;
