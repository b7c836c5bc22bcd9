//! Times of repeated runs.

use std::hint::black_box;
use std::time::{Duration, Instant};

/// Median, quartiles and minimum of several runs, s.
#[derive(Clone, Copy)]
pub(crate) struct Times {
    pub(crate) median: f64,
    pub(crate) quartiles: (f64, f64),
    pub(crate) fastest: f64,
    pub(crate) runs: usize,
}

impl Times {
    /// Time that was measured elsewhere.
    pub(crate) fn known(seconds: f64) -> Times {
        Times {
            median: seconds,
            quartiles: (seconds, seconds),
            fastest: seconds,
            runs: 1,
        }
    }

    /// The longer one of two times.
    pub(crate) fn or(self, other: Times) -> Times {
        if other.median > self.median {
            other
        } else {
            self
        }
    }
}

/// Settings of the time measurements: number of runs and total duration.
pub(crate) struct Watch {
    /// Whether few repetitions and sizes are sufficient.
    pub(crate) quick: bool,
    budget: Duration,
    most: usize,
}

/// Minimum duration of a timed batch, so that the resolution of the clock has no influence.
const BATCH: Duration = Duration::from_micros(100);

impl Watch {
    /// Settings for up to 101 runs in 0.4 s, or up to 15 in 0.03 s; at least three.
    pub(crate) fn new(quick: bool) -> Watch {
        let (budget, most) = if quick {
            (Duration::from_millis(30), 15)
        } else {
            (Duration::from_millis(400), 101)
        };
        Watch {
            quick,
            budget,
            most,
        }
    }

    /// Result of `f` and its duration: one warm-up, then batches until the time is used.
    pub(crate) fn time<T>(&self, mut f: impl FnMut() -> T) -> (T, Times) {
        let answer = f();
        let once = Instant::now();
        black_box(f());
        let once = once.elapsed().max(Duration::from_nanos(10));
        let inner = (BATCH.as_nanos() / once.as_nanos()).max(1) as usize;
        let mut times = Vec::new();
        let start = Instant::now();
        while times.len() < 3 || (times.len() < self.most && start.elapsed() < self.budget) {
            let batch = Instant::now();
            for _ in 0..inner {
                black_box(f());
            }
            times.push(batch.elapsed().as_secs_f64() / inner as f64);
        }
        times.sort_by(f64::total_cmp);
        let at = |share: f64| times[((times.len() - 1) as f64 * share).round() as usize];
        let found = Times {
            median: at(0.5),
            quartiles: (at(0.25), at(0.75)),
            fastest: times[0],
            runs: times.len(),
        };
        (answer, found)
    }
}

/// Times of `f` with the full settings.
pub(crate) fn times<T>(f: impl FnMut() -> T) -> Times {
    Watch::new(false).time(f).1
}
