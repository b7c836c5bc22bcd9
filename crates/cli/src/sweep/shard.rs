//! `gaitcam sweep --shard I/N`: computes one share of a sweep in blocks, for job queues with many processes.

use serde_json::json;

use super::format::Format;
use super::work::{self, Work};
use super::{SweepArgs, arguments};
use crate::console::exit_code::{BUILT, INTERRUPTED};
use crate::console::progress::Progress;
use crate::console::terminal::{self, print, print_json};
use crate::{console::language, console::words};
use gaitcam_app::blocks::{BLOCK_ROWS, SharedBlocks};

/// One of several equal shares of a sweep. Shares may be counted from 0 or from 1, because share 0 of N is the same as share N.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shard {
    /// Number of this share, from 0 to `parts`.
    pub part: u64,
    /// Total number of shares.
    pub parts: u64,
}

/// Parses a share such as `3/16`.
pub fn shard(typed: &str) -> Result<Shard, String> {
    let ends = typed.split_once('/');
    let number = |text: &str| text.trim().parse::<u64>().ok();
    ends.and_then(|(part, parts)| Some((number(part)?, number(parts)?)))
        .filter(|(part, parts)| *parts > 0 && part <= parts)
        .map(|(part, parts)| Shard { part, parts })
        .ok_or_else(|| crate::console::words::text("sweep-shard"))
}

/// Computes the missing blocks of the share. They are written as Parquet if this build supports it, otherwise as CSV.
///
/// # Errors
///
/// As for a sweep into one table. In addition, the folder must not contain another sweep.
pub fn run(args: &SweepArgs, shard: Shard) -> gaitcam::error::Result<u8> {
    let (sweep, _) = arguments::sweep(args)?;
    let rows = args.block_rows.unwrap_or(BLOCK_ROWS);
    let ending = Format::SHARED.ending();
    let blocks = SharedBlocks::open(&args.out, &sweep, rows, ending, language::current())?;
    let halts = || args.time.of_row();
    let work = Work {
        runner: sweep.runner(&halts, None)?,
        format: Format::SHARED,
        metadata: sweep.metadata(),
        jobs: work::jobs(args.jobs),
        stop: work::stop_on_ctrl_c(),
        in_log: args.progress,
    };
    let missing = blocks.missing_of(shard.part, shard.parts)?;
    let total = missing.iter().map(|r| r.end - r.start).sum();
    let progress = Progress::new(words::text("sweep-designs"), total, 0, work.in_log);
    for rows in missing {
        let (records, bytes) = work.block(rows.clone())?;
        if (records.len() as u64) < rows.end - rows.start {
            let done = progress.done();
            drop(progress);
            let done = json!({"done": done.to_string(), "rows": total.to_string()});
            terminal::report(words::fill("sweep-stopped", &done));
            return Ok(INTERRUPTED);
        }
        blocks.blocks.put(&rows, &bytes)?;
        progress.add(records.len() as u64);
    }
    drop(progress);
    let folder = args.out.display().to_string();
    let left = blocks.missing()?.len();
    if args.json {
        print_json(&json!({"folder": folder, "rows": total, "missing_blocks": left}));
    } else {
        let summary = json!({"folder": folder, "rows": total.to_string(), "left": left});
        print(&words::fill("sweep-shard-done", &summary));
    }
    Ok(BUILT)
}
