//! Times of repeated runs.

use std::hint::black_box;
use std::time::Instant;

/// Median and fastest of several runs, s.
#[derive(Clone, Copy)]
pub(crate) struct Times {
    pub(crate) median: f64,
    pub(crate) fastest: f64,
}

impl Times {
    /// The slower of two.
    pub(crate) fn or(self, other: Times) -> Times {
        if other.median > self.median {
            other
        } else {
            self
        }
    }
}

/// Runs after a warm-up: up to 101 in about half a second, at least five.
pub(crate) fn times<T>(mut run: impl FnMut() -> T) -> Times {
    black_box(run());
    let start = Instant::now();
    let mut all = Vec::new();
    while all.len() < 5 || (all.len() < 101 && start.elapsed().as_secs_f64() < 0.5) {
        let one = Instant::now();
        black_box(run());
        all.push(one.elapsed().as_secs_f64());
    }
    all.sort_by(f64::total_cmp);
    Times {
        median: all[all.len() / 2],
        fastest: all[0],
    }
}
