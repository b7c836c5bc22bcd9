//! `gaitcam man DIR`: the manual pages, one for each verb.

use std::path::PathBuf;

use clap::{Args, Command};
use clap_mangen::Man;
use gaitcam::error::{Placed, Result};
use gaitcam_output::folder::Folder;

use crate::console::error::CliError;
use crate::console::exit_code::BUILT;
use crate::console::help;
use crate::console::language;
use crate::console::terminal::print;

const EXAMPLES: &str = "Examples:
  gaitcam man ~/.local/share/man/man1";

/// Where to.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct ManArgs {
    /// Folder for the pages gaitcam.1, gaitcam-synth.1 …
    dir: PathBuf,
}

/// Writes the pages.
pub fn run(args: &ManArgs) -> Result<u8> {
    let folder = Folder::open(&args.dir)?;
    let command = help::command(language::current());
    let mut pages = vec![command.clone()];
    pages.extend(verbs(&command));
    for page in pages {
        let name = format!("{}.1", page.get_display_name().unwrap_or(page.get_name()));
        let mut text = Vec::new();
        Man::new(page).render(&mut text).map_err(|e| {
            let fault = e.to_string();
            CliError::CannotWrite { fault }.in_file(&args.dir.join(&name))
        })?;
        folder.write(&name, &text)?;
    }
    print(&folder.path().display().to_string());
    Ok(BUILT)
}

fn verbs(command: &Command) -> impl Iterator<Item = Command> {
    let verbs = command.get_subcommands().filter(|c| c.get_name() != "help");
    verbs.cloned()
}
