//! What every front end of gaitcam does with files: scenes and recordings in, results and sweeps out.
//!
//! The library reads no file and writes none; the command and the Python package do both by these functions, so
//! that scenes and results are the same for every user.

#![forbid(unsafe_code)]
#![deny(missing_docs)]
#![cfg_attr(not(test), warn(unused_crate_dependencies))]

pub mod blocks;
mod contents;
pub mod design;
mod earlier;
pub mod files;
mod group;
pub mod lock;
pub mod population;
pub mod read;
pub mod result_folder;
pub mod scene;
pub mod target;
pub mod workshop;

pub use contents::{Contents, ROWS};
pub use files::Source;
pub use lock::{Lock, PATIENCE};
pub use result_folder::ResultFolder;
pub use scene::Input;
pub use workshop::{Remark, Workshop};
