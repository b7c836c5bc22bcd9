//! `gaitcam sweep --shard I/N`: one share of a sweep in blocks, for queues that start many processes.

use std::sync::atomic::Ordering;

use serde_json::json;

use super::format::Format;
use super::{SweepArgs, arguments, check_size, check_values, work};
use crate::console::exit_code::{BUILT, INTERRUPTED};
use crate::console::progress::Progress;
use crate::console::terminal::{self, print, print_json};
use crate::{console::language, console::words};
use gaitcam::sweep::{Plan, Study, Subject};
use gaitcam_app::blocks::{BLOCK_ROWS, SharedBlocks};

/// A share of equal shares. They may be counted from 0 or from 1: share 0 of N is share N.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shard {
    /// Which.
    pub part: u64,
    /// Of how many.
    pub parts: u64,
}

/// Reads `3/16`.
pub fn shard(typed: &str) -> Result<Shard, String> {
    let ends = typed.split_once('/');
    let number = |text: &str| text.trim().parse::<u64>().ok();
    ends.and_then(|(part, parts)| Some((number(part)?, number(parts)?)))
        .filter(|(part, parts)| *parts > 0 && part <= parts)
        .map(|(part, parts)| Shard { part, parts })
        .ok_or_else(|| crate::console::words::text("sweep-shard"))
}

/// Computes the blocks of the share that the folder lacks: Parquet where this build writes it, else CSV.
///
/// # Errors
/// As a sweep into one table; a folder that holds another sweep.
pub fn run(args: &SweepArgs, shard: Shard) -> gaitcam::error::Result<u8> {
    let sweep = arguments::plan(args)?;
    check_size(args, &sweep.plan)?;
    check_values(args, &sweep.plan)?;
    let subject = Subject::Designs(named_by_scene(sweep.plan));
    let study = Study::new(subject, |index| &sweep.files[index])?;
    let rows = args.block_rows.unwrap_or(BLOCK_ROWS);
    let blocks = SharedBlocks::open(
        &args.out,
        &study,
        rows,
        Format::SHARED.ending(),
        language::current(),
    )?;
    let metadata = study.metadata();
    let jobs = work::jobs(args.jobs);
    let stop = work::stop_on_ctrl_c();
    let halts = || args.time.of_row();
    let missing = blocks.missing_of(shard.part, shard.parts)?;
    let total = missing.iter().map(|r| r.end - r.start).sum();
    let progress = Progress::new(words::text("sweep-designs"), total, 0);
    for block in missing {
        let rows = block.clone();
        let stopped = || stop.load(Ordering::Relaxed);
        let Some(records) = study.run(block, jobs, &halts, &stopped)? else {
            let done = progress.done();
            drop(progress);
            let done = json!({"done": done.to_string(), "rows": total.to_string()});
            terminal::report(words::fill("sweep-stopped", &done));
            return Ok(INTERRUPTED);
        };
        let lines = Format::SHARED.lines(&records);
        let bytes = Format::SHARED.block(&records, &lines, &metadata)?;
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

/// A plan whose base scenes have their own names, not those of files, so that it is the same on every machine.
fn named_by_scene(mut plan: Plan) -> Plan {
    for scene in &mut plan.scenes {
        let own = scene.table.get("name").and_then(|name| name.as_str());
        scene.name = own.unwrap_or("cam").to_string();
    }
    plan
}
