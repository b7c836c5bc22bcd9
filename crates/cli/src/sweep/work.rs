//! Doing the rows: waves of blocks over all threads, each wave on the disk while the next is computed.

use std::io::IsTerminal;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::sync_channel;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use rayon::prelude::*;

use super::partial::{Counts, PartialTable};
use crate::console::error::CliError;
use crate::console::exit_code::INTERRUPTED;
use crate::console::words;
use gaitcam::error::Result;
use gaitcam::sweep::{Kernel, Plan, table};

/// A wave aims at this much time: no more than this is lost in a crash.
const WAVE_S: f64 = 0.25;
/// Rows of the first wave.
const FIRST_WAVE: u64 = 8;
/// Most rows of a wave: bounds the memory.
const LARGEST_WAVE: u64 = 131_072;
/// Blocks per thread and wave: enough that no thread waits long for another.
const BLOCKS_PER_THREAD: u64 = 16;

/// A flag that Ctrl-C sets; the second Ctrl-C ends at once, which loses nothing either.
pub fn stop_on_ctrl_c() -> Arc<AtomicBool> {
    let stop = Arc::new(AtomicBool::new(false));
    let flag = stop.clone();
    // Without a handler Ctrl-C simply kills, which the partial table survives.
    let _ = ctrlc::set_handler(move || {
        if flag.swap(true, Ordering::Relaxed) {
            std::process::exit(i32::from(INTERRUPTED));
        }
    });
    stop
}

/// One thread per core where nobody says how many.
#[cfg(feature = "parquet")]
pub fn cores() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}

/// A bar with rate and time left on a terminal, nothing in a pipe.
pub fn progress(what: String, total: u64, done: u64) -> ProgressBar {
    if !std::io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template(
        "{msg} {wide_bar} {human_pos}/{human_len} {per_sec} {eta} left",
    )
    .unwrap_or_else(|_| ProgressStyle::default_bar());
    let bar = ProgressBar::with_draw_target(Some(total), ProgressDrawTarget::stderr())
        .with_style(style)
        .with_message(what)
        .with_position(done);
    bar.reset_eta();
    bar.enable_steady_tick(Duration::from_millis(500));
    bar
}

/// Rows that one task has computed, in order.
struct Block {
    counts: Counts,
    lines: String,
}

/// Computes the rows that the table lacks, until done or stopped.
pub fn compute(
    plan: &Plan,
    kernel: &Kernel,
    pool: &rayon::ThreadPool,
    partial: &mut PartialTable,
    stop: &AtomicBool,
) -> Result<()> {
    let total = plan.rows() as u64;
    let mut next = partial.counts().rows;
    let bar = progress(words::text("sweep-designs"), total, next);
    let (send, receive) = sync_channel::<Vec<Block>>(1);
    let written = std::thread::scope(|scope| {
        let bar = &bar;
        let writer = scope.spawn(move || -> Result<()> {
            for blocks in receive {
                let mut counts = Counts::default();
                let mut lines = String::new();
                for block in blocks {
                    lines.push_str(&block.lines);
                    counts.add(block.counts);
                }
                partial.append(&lines, counts)?;
                bar.set_position(partial.counts().rows);
            }
            Ok(())
        });
        let names = plan.scene_names();
        let mut wave = FIRST_WAVE;
        while next < total && !stop.load(Ordering::Relaxed) {
            let rows = wave.min(total - next);
            let start = Instant::now();
            let one = |first, count| block(plan, kernel, names.as_deref(), first, count);
            let blocks = one_wave(pool, next, rows, stop, &one);
            next += blocks.iter().map(|b| b.counts.rows).sum::<u64>();
            // The writer is gone only after a failure, which it returns.
            if blocks.is_empty() || send.send(blocks).is_err() {
                break;
            }
            let fits = rows as f64 * WAVE_S / start.elapsed().as_secs_f64().max(1e-6);
            wave = (fits as u64).clamp(1, 8 * rows).min(LARGEST_WAVE);
        }
        drop(send);
        writer.join()
    });
    bar.finish_and_clear();
    written.unwrap_or_else(|_| Err(CliError::WriterFailed.into()))
}

/// Rows `first .. first + rows`, or as many blocks of them from the start as were done when the stop came.
fn one_wave(
    pool: &rayon::ThreadPool,
    first: u64,
    rows: u64,
    stop: &AtomicBool,
    block: &(impl Fn(u64, usize) -> Block + Sync),
) -> Vec<Block> {
    let blocks = (pool.current_num_threads() as u64 * BLOCKS_PER_THREAD).clamp(1, rows);
    let parts: Vec<Option<Block>> = pool.install(|| {
        (0..blocks)
            .into_par_iter()
            .map(|b| {
                if stop.load(Ordering::Relaxed) {
                    return None;
                }
                let (from, to) = (b * rows / blocks, (b + 1) * rows / blocks);
                Some(block(first + from, (to - from) as usize))
            })
            .collect()
    });
    parts.into_iter().map_while(|p| p).collect()
}

fn block(
    plan: &Plan,
    kernel: &Kernel,
    names: Option<&[String]>,
    first: u64,
    count: usize,
) -> Block {
    let batch = plan.batch(first, count);
    let results = kernel.run(&batch);
    Block {
        counts: Counts::of(first, &results),
        lines: table::csv_rows(first, &batch, &results, names),
    }
}
