//! Progress display of a long computation: one updated line on a terminal, or separate lines in a log.

use std::io::{IsTerminal, Write, stderr};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread::{Builder, JoinHandle};
use std::time::{Duration, Instant};

use serde_json::json;

use crate::console::words;

/// Delay before the progress line appears, and interval between its updates.
const EVERY: Duration = Duration::from_millis(500);

/// Interval between the progress lines of a log.
const EVERY_LOGGED: Duration = Duration::from_secs(10);

/// A thread that displays the progress until this value is dropped.
pub struct Watch {
    done: Option<Sender<()>>,
    thread: Option<JoinHandle<()>>,
}

impl Watch {
    /// Starts a thread that runs `work`. The receiver passed to `work` is disconnected when the returned value is dropped. If the system
    /// cannot start a thread, no progress is displayed.
    pub fn new(work: impl FnOnce(Receiver<()>) + Send + 'static) -> Watch {
        let (done, waits) = channel();
        Watch {
            done: Some(done),
            thread: Builder::new().spawn(move || work(waits)).ok(),
        }
    }
}

impl Drop for Watch {
    fn drop(&mut self) {
        drop(self.done.take());
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}

/// Shows a progress line on a terminal until the returned value is dropped. `line` returns the text of the line for the elapsed time, s.
pub fn shown(line: impl Fn(f64) -> String + Send + 'static) -> Option<Watch> {
    stderr().is_terminal().then(|| {
        Watch::new(move |waits| {
            let begun = Instant::now();
            let mut width = 0;
            while waits.recv_timeout(EVERY) == Err(RecvTimeoutError::Timeout) {
                let text = line(begun.elapsed().as_secs_f64());
                // Spaces overwrite the rest of a longer previous line.
                put(&format!("\r{text:<width$}"));
                width = text.chars().count();
            }
            put(&format!("\r{:width$}\r", ""));
        })
    })
}

/// Writes a progress line to standard error every ten seconds until the returned value is dropped.
fn logged(line: impl Fn(f64) -> String + Send + 'static) -> Watch {
    Watch::new(move |waits| {
        let begun = Instant::now();
        while waits.recv_timeout(EVERY_LOGGED) == Err(RecvTimeoutError::Timeout) {
            put(&format!("{}\n", line(begun.elapsed().as_secs_f64())));
        }
    })
}

/// Writes text to standard error. Errors are ignored.
fn put(text: &str) {
    let mut terminal = stderr().lock();
    let _ = terminal.write_all(text.as_bytes());
    let _ = terminal.flush();
}

/// Counter of finished items. It displays their number, the rate and the remaining time.
pub struct Progress {
    done: Arc<AtomicU64>,
    _watch: Option<Watch>,
}

impl Progress {
    /// Starts a counter with `done` of `total` items finished. If `in_log` is set, progress lines are also written when standard error is
    /// not a terminal.
    pub fn new(what: String, total: u64, done: u64, in_log: bool) -> Progress {
        let now = Arc::new(AtomicU64::new(done));
        let counted = now.clone();
        let text = move |elapsed| {
            let items = [done, counted.load(Ordering::Relaxed)];
            line(&what, total, items, elapsed)
        };
        let in_log = in_log && !stderr().is_terminal();
        Progress {
            done: now,
            _watch: if in_log {
                Some(logged(text))
            } else {
                shown(text)
            },
        }
    }

    /// Sets the number of finished items.
    pub fn set(&self, done: u64) {
        self.done.store(done, Ordering::Relaxed);
    }

    /// Adds `more` to the number of finished items.
    pub fn add(&self, more: u64) {
        self.done.fetch_add(more, Ordering::Relaxed);
    }

    /// Number of finished items.
    pub fn done(&self) -> u64 {
        self.done.load(Ordering::Relaxed)
    }
}

/// Duration, given in s, as text: `95 s`, `12 min`, `30 h`, `12 d`. Values that are not whole have at least two significant digits.
pub fn duration(seconds: f64) -> String {
    let (unit, size) = [("d", 86_400.0), ("h", 3600.0), ("min", 60.0)]
        .into_iter()
        .find(|(_, size)| seconds >= 2.0 * size)
        .unwrap_or(("s", 1.0));
    let value = seconds / size;
    let decimals = if value < 9.95 && seconds != value.round() * size {
        1
    } else {
        0
    };
    format!("{} {unit}", words::fixed(value, decimals))
}

/// Progress text after `elapsed` seconds. `before` is the number of finished items at the start, `done` the present number.
fn line(what: &str, total: u64, [before, done]: [u64; 2], elapsed: f64) -> String {
    let rate = (done - before) as f64 / elapsed;
    let left = match rate > 0.0 {
        true => duration((total.saturating_sub(done) as f64 / rate).ceil()),
        false => "?".to_string(),
    };
    let state = json!({"what": what, "done": done.to_string(), "total": total.to_string(),
        "rate": words::fixed(rate, 0), "left": left});
    words::fill("sweep-progress", &state)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn durations_have_the_largest_unit_that_fits_twice() {
        let shown = [0.25, 7.0, 100.0, 390.0, 7260.0, 43_000.0, 1e6].map(duration);
        assert_eq!(
            shown,
            ["0.2 s", "7 s", "100 s", "6.5 min", "2.0 h", "12 h", "12 d"]
        );
    }

    #[test]
    fn the_line_says_rate_and_time_left_of_what_this_run_has_done() {
        let after_two_seconds = line("designs", 1000, [100, 300], 2.0);
        assert_eq!(after_two_seconds, "300/1000 designs, 100/s, 7 s left");
        let nothing_yet = line("designs", 10, [0, 0], 0.5);
        assert_eq!(nothing_yet, "0/10 designs, 0/s, ? left");
    }
}
