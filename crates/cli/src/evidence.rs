//! `gaitcam chart` and `gaitcam reproduce`: how exact and how fast the program is, measured now.

use std::path::PathBuf;

use clap::Args;

use crate::console::exit_code::BUILT;
use crate::console::terminal::print;
use gaitcam::error::Result;

/// How much to measure, and where the charts go.
#[derive(Args, Debug)]
pub struct ChartArgs {
    /// Fewer repetitions and sizes: under a minute
    #[arg(long)]
    quick: bool,
    /// Folder for tables and pictures
    #[arg(long, value_name = "DIR", default_value = "reports")]
    out: PathBuf,
}

/// Measures speed against accuracy and writes the charts.
pub fn chart(args: &ChartArgs) -> Result<u8> {
    gaitcam_evidence::measure::write(args.quick, &args.out, &mut print)?;
    Ok(BUILT)
}

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

/// Recomputes every figure of the source papers and writes the report.
pub fn reproduce(args: &ReproduceArgs) -> Result<u8> {
    gaitcam_evidence::reproduce::write(&args.out, &mut print)?;
    Ok(BUILT)
}
