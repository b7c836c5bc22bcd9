//! Computes the rows of a table, block by block.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use super::partial::PartialTable;
use crate::console::exit_code::INTERRUPTED;
use crate::console::progress::Progress;
use crate::console::words;
use gaitcam::error::Result;
use gaitcam::sweep::{Records, Runner};
use gaitcam_app::blocks::BLOCK_ROWS;

/// A block takes this time, or this share of the time so far where that is longer: no more is lost in a crash, and a
/// long sweep has a bounded number of blocks.
const BLOCK_S: f64 = 0.25;
const BLOCK_SHARE: f64 = 0.01;
/// Rows of the first block.
const FIRST_BLOCK: u64 = 8;

/// A flag that Ctrl-C sets; the second Ctrl-C ends at once, which loses nothing either.
pub fn stop_on_ctrl_c() -> Arc<AtomicBool> {
    let stop = Arc::new(AtomicBool::new(false));
    let flag = stop.clone();
    // Without a handler Ctrl-C kills the process, which the blocks survive.
    let _ = ctrlc::set_handler(move || {
        if flag.swap(true, Ordering::Relaxed) {
            std::process::exit(i32::from(INTERRUPTED));
        }
    });
    stop
}

/// Number of threads: as given, else one per core.
pub fn jobs(given: Option<u16>) -> usize {
    let cores = || std::thread::available_parallelism().map_or(1, usize::from);
    given.map_or_else(cores, usize::from)
}

/// Computes the rows that the table lacks, until done or stopped.
pub fn compute(
    runner: &Runner,
    total: u64,
    jobs: usize,
    partial: &mut PartialTable,
    stop: &AtomicBool,
) -> Result<()> {
    let progress = Progress::new(words::text("sweep-designs"), total, partial.counts().rows);
    let format = partial.format();
    // Lines are made by the threads: one thread alone would take as long for them as two for the rows.
    let part = |records: Records| (format.lines(&records), records);
    let stopped = || stop.load(Ordering::Relaxed);
    let begun = Instant::now();
    let mut rows = FIRST_BLOCK;
    while partial.counts().rows < total && !stopped() {
        let (first, start) = (partial.counts().rows, Instant::now());
        let parts = runner.map(first..(first + rows).min(total), jobs, &stopped, &part);
        if parts.is_empty() {
            break;
        }
        let (lines, records): (Vec<String>, Vec<Records>) = parts.into_iter().unzip();
        partial.append(&Records::joined(records), &lines.concat())?;
        progress.set(partial.counts().rows);
        let target_s = BLOCK_S.max(BLOCK_SHARE * begun.elapsed().as_secs_f64());
        let fits = rows as f64 * target_s / start.elapsed().as_secs_f64().max(1e-6);
        rows = (fits as u64).clamp(1, 8 * rows).min(BLOCK_ROWS);
    }
    Ok(())
}
