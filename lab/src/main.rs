//! The command `gaitcam-lab`: measurements and reports on gaitcam itself.
#![forbid(unsafe_code)]

use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Parser, Subcommand};
use gaitcam::error::Result;
use gaitcam::wording::Language;
use gaitcam_lab::{benchmarks, measure, reproduce, twins};

/// How we know that gaitcam is right and fast: papers, charts, benchmarks, test machines.
#[derive(Parser)]
#[command(name = "gaitcam-lab", version)]
struct Lab {
    #[command(subcommand)]
    command: Command,
    /// Folder for reports and pictures
    #[arg(long, global = true, value_name = "DIR", default_value = "reports")]
    out: PathBuf,
}

#[derive(Subcommand)]
enum Command {
    /// Measure speed against accuracy on this machine and draw the charts
    Chart {
        /// Fewer repetitions and sizes: under a minute
        #[arg(long)]
        quick: bool,
    },
    /// Recompute numbers of the source papers: published, recomputed, agreement
    Reproduce,
    /// Measure the times, rates and ratios of reports/benchmarks.md
    Benchmarks,
    /// Identify and correct test machines with hidden parameters (about ten minutes)
    Twins,
}

fn main() -> ExitCode {
    match run(&Lab::parse()) {
        Ok(code) => code,
        Err(error) => {
            eprintln!("{}", error.sentence(Language::En));
            ExitCode::FAILURE
        }
    }
}

fn run(lab: &Lab) -> Result<ExitCode> {
    let say = &mut |line: &str| println!("{line}");
    match &lab.command {
        Command::Chart { quick } => measure::write(*quick, &lab.out, say)?,
        Command::Reproduce => reproduce::write(&lab.out, say)?,
        Command::Twins => twins::report::run(&lab.out)?,
        Command::Benchmarks => {
            let unexplained = benchmarks::write(&lab.out, say)?;
            if !unexplained.is_empty() {
                eprintln!("Outside the limit without a reason in the table: {unexplained:?}");
                return Ok(ExitCode::FAILURE);
            }
        }
    }
    Ok(ExitCode::SUCCESS)
}
