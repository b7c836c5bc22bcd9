//! Computes the rows of a table block by block.

use std::ops::Range;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use super::format::Format;
use super::partial::PartialTable;
use crate::console::exit_code::INTERRUPTED;
use crate::console::progress::Progress;
use crate::console::words;
use gaitcam::error::Result;
use gaitcam::sweep::{Records, Runner};
use gaitcam_app::blocks::BLOCK_ROWS;

/// The target duration of a block is the larger of `BLOCK_S`, s, and the fraction `BLOCK_SHARE` of the elapsed time. The first value
/// limits the number of blocks of a short sweep. The second value limits the number of blocks of a long sweep and the loss in a crash.
const BLOCK_S: f64 = 0.25;
const BLOCK_SHARE: f64 = 0.01;
/// Number of rows of the first block.
const FIRST_BLOCK: u64 = 8;

/// Installs a handler for Ctrl-C that sets the returned flag. A second Ctrl-C ends the program at once. Complete blocks are kept.
pub fn stop_on_ctrl_c() -> Arc<AtomicBool> {
    let stop = Arc::new(AtomicBool::new(false));
    let flag = stop.clone();
    // If no handler can be installed, Ctrl-C ends the process at once. Complete blocks are kept.
    let _ = ctrlc::set_handler(move || {
        if flag.swap(true, Ordering::Relaxed) {
            std::process::exit(i32::from(INTERRUPTED));
        }
    });
    stop
}

/// Number of threads: the given number, otherwise one per core.
pub fn jobs(given: Option<u16>) -> usize {
    let cores = || std::thread::available_parallelism().map_or(1, usize::from);
    given.map_or_else(cores, usize::from)
}

/// Computes blocks of rows with several threads.
pub struct Work<'a> {
    /// Runner that computes the rows of the sweep.
    pub runner: Runner<'a>,
    /// File format of the blocks.
    pub format: Format,
    /// Description of the sweep that is stored in each block.
    pub metadata: Vec<(String, String)>,
    /// Number of worker threads.
    pub jobs: usize,
    /// Flag that is set when the user stops the computation.
    pub stop: Arc<AtomicBool>,
    /// Whether progress is also displayed if standard error is not a terminal.
    pub in_log: bool,
}

impl Work<'_> {
    fn is_stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }

    /// Computes the rows of a range, and the content of the block file for these rows. If the user stops the computation, only the first
    /// rows of the range are computed.
    pub fn block(&self, rows: Range<u64>) -> Result<(Records, Vec<u8>)> {
        // Each thread formats the lines of its rows. A single thread would need as much time for the lines as two threads for the rows.
        let part = |records: Records| (self.format.lines(&records), records);
        let parts = (self.runner).map(rows, self.jobs, &|| self.is_stopped(), &part);
        let (lines, records): (Vec<String>, Vec<Records>) = parts.into_iter().unzip();
        let records = Records::joined(records);
        let bytes = (self.format).block(&records, &lines.concat(), &self.metadata)?;
        Ok((records, bytes))
    }

    /// Computes the missing rows of a table until all rows are complete or the user stops the computation.
    pub fn fill(&self, total: u64, partial: &mut PartialTable) -> Result<()> {
        let (what, done) = (words::text("sweep-designs"), partial.counts().rows);
        let progress = Progress::new(what, total, done, self.in_log);
        let begun = Instant::now();
        let mut rows = FIRST_BLOCK;
        while partial.counts().rows < total && !self.is_stopped() {
            let (first, start) = (partial.counts().rows, Instant::now());
            let (records, bytes) = self.block(first..(first + rows).min(total))?;
            if records.is_empty() {
                break;
            }
            partial.append(&records, &bytes)?;
            progress.set(partial.counts().rows);
            let target_s = BLOCK_S.max(BLOCK_SHARE * begun.elapsed().as_secs_f64());
            let fits = rows as f64 * target_s / start.elapsed().as_secs_f64().max(1e-6);
            rows = (fits as u64).clamp(1, 8 * rows).min(BLOCK_ROWS);
        }
        Ok(())
    }
}
