//! `gaitcam chart`: speed against accuracy, measured now on this machine.

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

/// Measures and writes the charts.
pub fn run(args: &ChartArgs) -> Result<u8> {
    gaitcam_evidence::measure::write(args.quick, &args.out, &mut print)?;
    Ok(BUILT)
}
