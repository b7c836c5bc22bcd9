//! Application layer of gaitcam: reading of scenes and recordings, writing of results and sweeps, and requests of the page.
//!
//! The library `gaitcam` does not access files. The command, the Python package and the page all read and write files with the functions of this
//! crate. The same scene therefore gives the same results in every user interface.

#![deny(unsafe_code, missing_docs)]
#![cfg_attr(not(test), deny(clippy::disallowed_methods))]
#![cfg_attr(not(test), warn(unused_crate_dependencies))]

#[cfg(target_family = "wasm")]
mod allocator;
pub mod blocks;
mod contents;
pub mod design;
pub mod disk;
pub mod doctor;
mod earlier;
pub mod files;
pub mod folder;
mod group;
pub mod inputs;
pub mod lock;
pub mod measured;
pub mod page;
pub mod read;
pub mod recordings;
pub mod result_folder;
pub mod scene;
pub mod sweep;
pub mod workshop;

pub use contents::{Contents, ROWS};
pub use disk::Disk;
pub use files::Source;
pub use lock::{Lock, PATIENCE};
pub use result_folder::ResultFolder;
pub use scene::Input;
pub use sweep::{SweepQuestion, Varied, completed};
pub use workshop::{Remark, Workshop};
