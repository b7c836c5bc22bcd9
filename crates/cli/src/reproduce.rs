//! `gaitcam reproduce`: every figure of the source papers, recomputed.

use std::path::PathBuf;

use clap::Args;

use crate::console::exit_code::BUILT;
use crate::console::terminal::print;
use gaitcam::error::Result;

const EXAMPLES: &str = "Examples:
  gaitcam reproduce
  gaitcam reproduce --out out/reproduced";

/// Where the report goes.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct ReproduceArgs {
    /// Folder for the report
    #[arg(long, value_name = "DIR", default_value = "reports")]
    out: PathBuf,
}

/// Recomputes and writes the report.
pub fn run(args: &ReproduceArgs) -> Result<u8> {
    gaitcam_evidence::reproduce::write(&args.out, &mut print)?;
    Ok(BUILT)
}
