//! Long computations without the interpreter's lock, interruptible by Ctrl-C.

use std::sync::{Arc, Mutex};
use std::thread::{ThreadId, current};
use std::time::{Duration, Instant};

use gaitcam::error::Result;
use gaitcam::halt::Halt;
use gaitcam::synth::Search;
use pyo3::prelude::*;

/// Time between two checks of Python's signals.
const LOOK: Duration = Duration::from_millis(50);
/// Longest time limit, s; longer ones are ignored.
const LONGEST_S: f64 = 1e9;

/// Callback that is called whenever Python's signals are checked. An error ends the search.
type Watch = Box<dyn Fn(Python<'_>) -> PyResult<()> + Send + Sync>;

/// End condition of a search: a time limit, or an exception of a signal handler or callback.
pub struct Interrupt {
    begun: Instant,
    limit: Duration,
    thread: ThreadId,
    watch: Option<Watch>,
    state: Mutex<State>,
}

struct State {
    looked: Instant,
    raised: Option<PyErr>,
}

impl Interrupt {
    /// End condition with a time limit from now, s.
    pub fn after(limit_s: f64) -> Arc<Interrupt> {
        Interrupt::watched(limit_s, None)
    }

    /// End condition with a time limit from now, s. `watch` is called at every check of Python's signals.
    pub fn watched(limit_s: f64, watch: Option<Watch>) -> Arc<Interrupt> {
        let begun = Instant::now();
        Arc::new(Interrupt {
            begun,
            limit: Duration::from_secs_f64(limit_s.clamp(0.0, LONGEST_S)),
            thread: current().id(),
            watch,
            state: Mutex::new(State {
                looked: begun,
                raised: None,
            }),
        })
    }

    /// Halt condition that searches poll.
    pub fn halt(self: &Arc<Self>) -> Halt {
        let own = Arc::clone(self);
        Halt::when(move || own.begun.elapsed() >= own.limit || own.is_raised())
    }

    /// Whether a signal handler has raised an exception. Signals are checked at most every 50 ms, from the calling thread only.
    pub fn is_raised(&self) -> bool {
        let Ok(mut state) = self.state.lock() else {
            return true;
        };
        if state.raised.is_some() {
            return true;
        }
        if current().id() != self.thread || state.looked.elapsed() < LOOK {
            return false;
        }
        state.looked = Instant::now();
        // A signal handler may run Python code that calls this function again, so the lock is released first.
        drop(state);
        let look = |py: Python<'_>| {
            py.check_signals()?;
            self.watch.as_ref().map_or(Ok(()), |watch| watch(py))
        };
        let raised = Python::attach(look).err();
        let is_raised = raised.is_some();
        if let Ok(mut state) = self.state.lock() {
            state.raised = raised;
        }
        is_raised
    }

    /// The exception that ended the work, if any.
    pub fn result(&self) -> PyResult<()> {
        let raised = self.state.lock().ok().and_then(|mut s| s.raised.take());
        raised.map_or(Ok(()), Err)
    }

    /// Time since the work began, s.
    pub fn elapsed_s(&self) -> f64 {
        self.begun.elapsed().as_secs_f64()
    }
}

/// Runs a search without the interpreter's lock.
///
/// # Errors
///
/// An invalid time limit; an exception of a signal handler. A fault of the search is the inner result.
pub fn run<T: Send>(
    py: Python<'_>,
    limit_s: f64,
    work: impl FnOnce(&Search) -> Result<T> + Send,
) -> PyResult<Result<T>> {
    let interrupt = Interrupt::after(limit(py, limit_s)?);
    let found = py.detach(|| work(&Search::until(interrupt.halt())));
    interrupt.result().map(|()| found)
}

/// Checks a time limit given by the user, s.
pub fn limit(py: Python<'_>, seconds: f64) -> PyResult<f64> {
    if seconds > 0.0 {
        return Ok(seconds);
    }
    let what = format!("{seconds} s is no time limit; give a positive number of seconds");
    Err(crate::error::argument(py, "time_limit", what))
}
