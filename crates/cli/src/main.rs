//! Entry point of the `gaitcam` command.
#![forbid(unsafe_code)]

use std::process::ExitCode;

fn main() -> ExitCode {
    ExitCode::from(gaitcam_cli::run(std::env::args_os()))
}
