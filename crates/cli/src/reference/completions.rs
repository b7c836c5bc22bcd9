//! `gaitcam completions SHELL`: completion script of a shell.

use clap::Args;
use clap_complete::Shell;

use crate::console::exit_code::BUILT;
use crate::console::language;
use crate::console::terminal::print;
use gaitcam::error::Result;

/// Arguments of `gaitcam completions`.
#[derive(Args, Debug)]
pub struct CompletionsArgs {
    shell: Shell,
}

/// Prints the completion script.
pub fn run(args: &CompletionsArgs) -> Result<u8> {
    let mut script = Vec::new();
    clap_complete::generate(
        args.shell,
        &mut crate::console::help::command(language::current()),
        "gaitcam",
        &mut script,
    );
    print(String::from_utf8_lossy(&script).trim_end());
    Ok(BUILT)
}
