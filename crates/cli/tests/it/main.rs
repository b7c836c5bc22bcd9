//! The command as users call it: files, messages, exit codes.

mod files;
mod gait;
mod refused;
mod result;
mod support;
mod sweep;
mod synth;
mod wording;
