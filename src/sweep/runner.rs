//! Computation of the rows of a sweep with one or several threads.

use std::ops::Range;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::Duration;

use gaitcam_base::threads;

use super::carried::Files;
use super::kernel::{Clock, Halts, Kernel};
use super::made::scatter::Samples;
use super::plan::Plan;
use super::table::records::Records;

/// Maximum number of rows in one part of the work. It limits the required memory.
const LARGEST_PART: u64 = 4096;
/// Number of parts of the work for each thread. With this number, the work is evenly distributed over the threads.
const PARTS_PER_THREAD: u64 = 16;
/// Maximum time between two calls of `stop` while the threads work.
const LOOK: Duration = Duration::from_millis(20);

/// Computes rows of a sweep in any order. Row i depends only on the plan and on i.
///
/// ```
/// use gaitcam::halt::Halt;
/// use gaitcam::scene;
/// use gaitcam::sweep::Sweep;
///
/// let scene = scene::built_in("footbridge")?.scene()?;
/// let sweep = Sweep::over(&scene, &["gait.body_weight=600 N:800 N:5"])?;
/// let runner = sweep.runner(&Halt::never, None)?;
/// assert_eq!(runner.run(1..3, 2, &|| false).len(), 2);
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
pub struct Runner<'a> {
    work: Work<'a>,
}

enum Work<'a> {
    Designs {
        plan: &'a Plan,
        /// Names of the base scenes; `None` if there is only one.
        scenes: Option<Vec<String>>,
        kernel: Kernel<'a>,
    },
    Samples(Samples),
}

impl<'a> Runner<'a> {
    pub(super) fn of_plan(
        plan: &'a Plan,
        files: &'a Files,
        halts: Halts<'a>,
        clock: Option<Clock<'a>>,
    ) -> Self {
        let work = Work::Designs {
            plan,
            scenes: plan.scene_names(),
            kernel: Kernel::new(plan, files, halts, clock),
        };
        Runner { work }
    }

    pub(super) fn of_samples(samples: Samples) -> Self {
        Runner {
            work: Work::Samples(samples),
        }
    }

    /// Computes a range of rows with `jobs` threads. If `stop` returns true, the result contains only the first rows of the range, up to
    /// the end of a part. `stop` is called only on the calling thread.
    pub fn run(&self, rows: Range<u64>, jobs: usize, stop: &dyn Fn() -> bool) -> Records {
        Records::joined(self.map(rows, jobs, stop, &|part| part))
    }

    /// Computes a range of rows in parts with `jobs` threads. `each` is applied to every part on the thread that computed this part. The
    /// results are in the order of the rows.
    pub fn map<T: Send>(
        &self,
        rows: Range<u64>,
        jobs: usize,
        stop: &dyn Fn() -> bool,
        each: &(dyn Fn(Records) -> T + Sync),
    ) -> Vec<T> {
        let parts = Parts::new(rows, jobs);
        let on_this_thread = || {
            let part = |k| self.part(parts.rows(k), stop).map(each);
            (0..parts.count).map_while(part).collect()
        };
        if jobs <= 1 {
            return on_this_thread();
        }
        let (next, ended) = (AtomicU64::new(0), AtomicBool::new(false));
        let is_ended = || ended.load(Ordering::Relaxed);
        let compute = || {
            let k = next.fetch_add(1, Ordering::Relaxed);
            let rows = (k < parts.count).then(|| parts.rows(k))?;
            Some((k, each(self.part(rows, &is_ended)?)))
        };
        let mut done: Vec<Option<T>> = (0..parts.count).map(|_| None).collect();
        let started = std::thread::scope(|scope| {
            let (send, receive) = channel();
            let compute = &compute;
            let work = move || {
                while let Some(part) = compute() {
                    if send.send(part).is_err() {
                        return;
                    }
                }
            };
            let count = (jobs as u64).min(parts.count) as usize;
            let started = threads::start(scope, count, work);
            loop {
                match receive.recv_timeout(LOOK) {
                    Ok((k, part)) => done[k as usize] = Some(part),
                    Err(RecvTimeoutError::Timeout) => {}
                    Err(RecvTimeoutError::Disconnected) => return started,
                }
                if stop() {
                    ended.store(true, Ordering::Relaxed);
                }
            }
        });
        if started == 0 {
            return on_this_thread();
        }
        done.into_iter().map_while(|part| part).collect()
    }

    /// Computes one part of the rows on the current thread; `None` if `stop` ended the computation early.
    fn part(&self, rows: Range<u64>, stop: &dyn Fn() -> bool) -> Option<Records> {
        match &self.work {
            Work::Designs {
                plan,
                scenes,
                kernel,
            } => {
                let batch = plan.batch(rows.start, (rows.end - rows.start) as usize);
                let results = kernel.run(&batch, stop)?;
                let (keys, scenes) = (kernel.keys(), scenes.as_deref());
                let records = Records::of(rows.start, keys, &batch, &results, scenes);
                Some(if kernel.has_clock() {
                    records.with_times(&results)
                } else {
                    records
                })
            }
            Work::Samples(samples) => (!stop()).then(|| samples.records(rows)),
        }
    }
}

/// Division of a range of rows into parts. All parts but the last have equal size. An empty range has one part, so that the table contains
/// its columns.
struct Parts {
    all: Range<u64>,
    size: u64,
    count: u64,
}

impl Parts {
    fn new(all: Range<u64>, jobs: usize) -> Parts {
        let rows = all.end - all.start;
        let parts = if jobs <= 1 {
            1
        } else {
            PARTS_PER_THREAD * jobs as u64
        };
        let size = (rows / parts).clamp(1, LARGEST_PART);
        let count = rows.div_ceil(size).max(1);
        Parts { all, size, count }
    }

    fn rows(&self, k: u64) -> Range<u64> {
        let start = self.all.start + k * self.size;
        start..(start + self.size).min(self.all.end)
    }
}
