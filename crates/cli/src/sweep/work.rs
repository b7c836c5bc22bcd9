//! Doing the rows: waves of blocks over all threads, each wave on the disk while the next is computed.

use std::io::IsTerminal;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::sync_channel;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use rayon::prelude::*;

use super::journal::Journal;
use crate::exit_code::INTERRUPTED;
use gaitcam::error::{Error, Result};
use gaitcam::sweep::{Kernel, Plan, Results};

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
    // Without a handler Ctrl-C simply kills, and the journal is made for that.
    let _ = ctrlc::set_handler(move || {
        if flag.swap(true, Ordering::Relaxed) {
            std::process::exit(i32::from(INTERRUPTED));
        }
    });
    stop
}

/// A bar with rate and time left on a terminal, nothing in a pipe.
pub fn progress(what: &'static str, total: u64, done: u64) -> ProgressBar {
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

/// Computes the rows that the journal lacks, until done or stopped.
pub fn compute(
    plan: &Plan,
    kernel: &Kernel,
    pool: &rayon::ThreadPool,
    journal: &mut Journal,
    stop: &AtomicBool,
) -> Result<()> {
    let total = plan.rows() as u64;
    let mut next = journal.rows();
    let bar = progress("designs", total, next);
    let (send, receive) = sync_channel::<Results>(1);
    let written = std::thread::scope(|scope| {
        let bar = &bar;
        let writer = scope.spawn(move || -> Result<()> {
            for results in receive {
                journal.append(&results)?;
                bar.set_position(journal.rows());
            }
            Ok(())
        });
        let mut wave = FIRST_WAVE;
        while next < total && !stop.load(Ordering::Relaxed) {
            let rows = wave.min(total - next);
            let start = Instant::now();
            let results = one_wave(plan, kernel, pool, next, rows, stop);
            next += results.len() as u64;
            // The writer is gone only after a failure, which it returns.
            if results.is_empty() || send.send(results).is_err() {
                break;
            }
            let fits = rows as f64 * WAVE_S / start.elapsed().as_secs_f64().max(1e-6);
            wave = (fits as u64).clamp(1, 8 * rows).min(LARGEST_WAVE);
        }
        drop(send);
        writer.join()
    });
    bar.finish_and_clear();
    written.unwrap_or_else(|_| Err(Error::new("the journal's writer failed")))
}

/// Rows `first .. first + rows`, or as many of them from the start as were done when the stop came.
fn one_wave(
    plan: &Plan,
    kernel: &Kernel,
    pool: &rayon::ThreadPool,
    first: u64,
    rows: u64,
    stop: &AtomicBool,
) -> Results {
    let blocks = (pool.current_num_threads() as u64 * BLOCKS_PER_THREAD).clamp(1, rows);
    let parts: Vec<Option<Results>> = pool.install(|| {
        (0..blocks)
            .into_par_iter()
            .map(|b| {
                if stop.load(Ordering::Relaxed) {
                    return None;
                }
                let (from, to) = (b * rows / blocks, (b + 1) * rows / blocks);
                Some(kernel.run(&plan.batch(first + from, (to - from) as usize)))
            })
            .collect()
    });
    let mut all = Results::default();
    for part in parts.into_iter().map_while(|p| p) {
        all.append(part);
    }
    all
}
