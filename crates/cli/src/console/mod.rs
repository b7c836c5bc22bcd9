//! What the user reads: language, help, messages, faults of the command line, exit codes.

pub mod error;
pub mod exit_code;
pub mod help;
pub mod internal;
pub mod language;
pub mod progress;
pub mod table;
pub mod terminal;
pub mod usage;
pub mod words;
