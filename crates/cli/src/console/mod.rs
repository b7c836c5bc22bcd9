//! Console output: language, help, messages, errors of the command line, exit codes.

pub mod error;
pub mod exit_code;
pub mod help;
pub mod internal;
pub mod language;
pub mod lengths;
pub mod progress;
pub mod table;
pub mod terminal;
pub mod usage;
pub mod words;
