//! `gaitcam sweep`: computes thousands of designs and stores them in one table.

mod arguments;
mod counts;
mod estimate;
mod format;
mod partial;
mod shard;
mod tolerance;
mod work;

use std::path::PathBuf;
use std::time::Instant;

use clap::Args;
use serde_json::json;

use crate::console::exit_code::{BUILT, INTERRUPTED, NO_SUCH_CAM};
use crate::console::terminal::{self, print, print_json};
use crate::console::words;
use crate::input::searching::TimeLimit;
use counts::Counts;
use format::Format;
use gaitcam::error::Result;
use gaitcam::sweep::Method;
use partial::PartialTable;
pub use partial::with_ending;
use work::Work;

const EXAMPLES: &str = "Examples:
  gaitcam sweep --vary 'limits.stroke=20 mm:60 mm:9' --out strokes.csv
  gaitcam sweep my.toml --vary law.family=spline,harmonic --vary 'drive.mass=5 kg:9 kg:5' --out grid.csv
  gaitcam sweep --sample 10000 --vary 'gait.step_frequency=1.5 Hz:2.4 Hz' --out sample.csv --estimate
  gaitcam sweep --sample 10000 --vary 'gait.step_frequency=1.5 Hz:2.4 Hz' --out sample.csv --resume
  gaitcam sweep scenes/measured_walk.toml --recordings data/gait_curves --out walks.csv
  gaitcam sweep --tolerance 'profile=0.02 mm' --band '2 %' --out made.csv
  gaitcam sweep big.toml --vary 'limits.stroke=20 mm:60 mm:1000000' --shard 3/16 --out blocks";

/// Arguments of `gaitcam sweep`.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct SweepArgs {
    /// Scene files (default: the built-in footbridge)
    pub scenes: Vec<PathBuf>,
    /// Change a value in every scene: --set 'limits.stroke=40 mm' (may be repeated)
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// Vary a value: 'gait.step_frequency=1.5 Hz:2.4 Hz:10' or law.family=spline,harmonic (may be repeated)
    #[arg(long, value_name = "KEY=VALUES")]
    pub vary: Vec<String>,
    /// List of combined values: a csv with keys in its header
    #[arg(long, value_name = "FILE.csv")]
    pub list: Option<PathBuf>,
    /// One design for each recording: files or folders (may be repeated)
    #[arg(long, value_name = "PATH")]
    pub recordings: Vec<PathBuf>,
    /// Sample N points of the varied ranges ('KEY=START:STOP') instead of a grid
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub sample: Option<u64>,
    /// Sampling method
    #[arg(long, default_value = "latin", value_parser = ["latin", "sobol"])]
    pub design: String,
    /// Seed of the random numbers of the sample
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// Output table: FILE.csv or FILE.parquet
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
    /// Compute one of N equal shares, in blocks of rows. --out is the common folder of all shares; only missing blocks
    /// are computed
    #[arg(long, value_name = "I/N", value_parser = shard::shard, conflicts_with_all = ["resume", "tolerance"])]
    pub shard: Option<shard::Shard>,
    /// Number of rows of a block (default 131072)
    #[arg(long, value_name = "N", requires = "shard", value_parser = clap::value_parser!(u64).range(1..))]
    pub block_rows: Option<u64>,
    /// Continue an interrupted sweep
    #[arg(long)]
    pub resume: bool,
    #[command(flatten)]
    pub time: TimeLimit,
    /// Number of threads (default: one per core)
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub jobs: Option<u16>,
    /// Write a line with rate and remaining time every 10 s if standard error is not a terminal
    #[arg(long, conflicts_with = "tolerance")]
    pub progress: bool,
    /// Only estimate the time of the sweep from the times of some rows; nothing is written
    #[arg(long, conflicts_with_all = ["resume", "shard", "tolerance", "progress"])]
    pub estimate: bool,
    /// Allow more than 100 million rows
    #[arg(long)]
    pub yes: bool,
    /// Manufacturing tolerance of one design: 'profile=0.02 mm', base_radius, mass, speed (may be repeated)
    #[arg(long, value_name = "PART=±VALUE")]
    pub tolerance: Vec<String>,
    /// Maximum force error of a manufactured cam, for the yield: '2 %' of the mean
    #[arg(long, requires = "tolerance")]
    pub band: Option<String>,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
}

impl SweepArgs {
    fn method(&self) -> Method {
        if self.design == "sobol" {
            Method::Sobol
        } else {
            Method::Latin
        }
    }
}

/// Runs the sweep. The exit code is 0 if the table is complete and contains an acceptable cam, and 3 if it contains none.
pub fn run(args: &SweepArgs) -> Result<u8> {
    if !args.tolerance.is_empty() {
        return tolerance::run(args);
    }
    if args.estimate {
        return estimate::run(args);
    }
    if let Some(share) = args.shard {
        return shard::run(args, share);
    }
    let start = Instant::now();
    let format = Format::of(&args.out)?;
    let (sweep, files) = arguments::sweep(args)?;
    let (rows, description) = (sweep.rows()?, arguments::description(&sweep, &files));
    let partial = PartialTable::open(&args.out, format, &description, args.resume)?;
    let Some(mut partial) = partial else {
        print(&words::fill("sweep-complete", &file(args)));
        return Ok(BUILT);
    };
    if let Some(damaged) = partial.damaged() {
        terminal::report(damaged);
    }
    let clock = || start.elapsed().as_secs_f64();
    let halts = || args.time.of_row();
    let work = Work {
        runner: sweep.runner(&halts, Some(&clock))?,
        format,
        metadata: Vec::new(),
        jobs: work::jobs(args.jobs),
        stop: work::stop_on_ctrl_c(),
        in_log: args.progress,
    };
    let before = partial.counts().rows;
    let computed = Instant::now();
    work.fill(rows, &mut partial)?;
    let seconds = computed.elapsed().as_secs_f64();
    let done = partial.counts().rows;
    if done < rows {
        let stopped = json!({"done": done.to_string(), "rows": rows.to_string()});
        terminal::report(words::fill("sweep-stopped", &stopped));
        return Ok(INTERRUPTED);
    }
    let counts = partial.finish(&description)?;
    report(args, &counts, rows - before, seconds);
    let some = counts.acceptable + counts.low_speed > 0;
    Ok(if some { BUILT } else { NO_SUCH_CAM })
}

/// Message argument with the path of the table.
fn file(args: &SweepArgs) -> serde_json::Value {
    json!({"file": args.out.display().to_string()})
}

fn report(args: &SweepArgs, counts: &Counts, computed: u64, seconds: f64) {
    let rate = computed as f64 / seconds.max(1e-9);
    if args.json {
        let object = serde_json::json!({
            "file": args.out.display().to_string(), "rows": counts.rows, "built": counts.built,
            "acceptable": counts.acceptable, "not_for_high_speed": counts.low_speed, "infeasible": counts.infeasible, "errors": counts.errors,
            "computed": computed, "seconds": seconds, "rows_per_s": rate,
        });
        print_json(&object);
        return;
    }
    let mut all = file(args);
    for (name, count) in [
        ("rows", counts.rows),
        ("built", counts.built),
        ("acceptable", counts.acceptable),
        ("slow", counts.low_speed),
        ("infeasible", counts.infeasible),
        ("errors", counts.errors),
    ] {
        all[name] = json!(count.to_string());
    }
    print(&words::fill("sweep-counts", &all));
    if computed > 0 {
        let rate = json!({"designs": computed.to_string(), "seconds": words::fixed(seconds, 2),
            "rate": words::fixed(rate, 0)});
        print(&words::fill("sweep-rate", &rate));
    }
    if let Some(first) = &counts.first_error {
        let first = json!({"row": first.0.to_string(), "fault": first.1});
        print(&words::fill("sweep-first-error", &first));
    }
}
