//! Files that are read and written: result folders, links and pipes, streams, printed numbers.

mod folder;
mod foreign;
mod input_and_output;
mod inputs;
#[cfg(target_os = "linux")]
mod of_the_system;
mod polish;
