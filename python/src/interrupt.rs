//! Long computations that release the lock of the interpreter (GIL) and can be stopped with Ctrl-C.

use std::sync::{Arc, Mutex};
use std::thread::{ThreadId, current};
use std::time::{Duration, Instant};

use gaitcam::error::Result;
use gaitcam::halt::Halt;
use gaitcam::synth::Search;
use pyo3::prelude::*;

/// Minimum time between two checks for Python signals.
const LOOK: Duration = Duration::from_millis(50);
/// Maximum time limit, s. A longer limit is reduced to this value.
const LONGEST_S: f64 = 1e9;

/// Callback that is called at every check for Python signals. An error of the callback ends the search.
type Watch = Box<dyn Fn(Python<'_>) -> PyResult<()> + Send + Sync>;

/// Stop condition of a search: a time limit, or an exception that a signal handler or the callback raised.
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
    /// Creates a stop condition with a time limit, s, that starts now.
    pub fn after(limit_s: f64) -> Arc<Interrupt> {
        Interrupt::watched(limit_s, None)
    }

    /// Creates a stop condition with a time limit, s, that starts now. `watch` is called at every check for Python signals.
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

    /// Stop condition as a [`Halt`], which searches check repeatedly.
    pub fn halt(self: &Arc<Self>) -> Halt {
        let own = Arc::clone(self);
        Halt::when(move || own.begun.elapsed() >= own.limit || own.is_raised())
    }

    /// Whether a signal handler or the callback has raised an exception. Signals are checked at most every 50 ms, and only on the calling thread.
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

    /// Returns the exception that ended the search as an error, if there is one.
    pub fn result(&self) -> PyResult<()> {
        let raised = self.state.lock().ok().and_then(|mut s| s.raised.take());
        raised.map_or(Ok(()), Err)
    }

    /// Time since the start of the search, s.
    pub fn elapsed_s(&self) -> f64 {
        self.begun.elapsed().as_secs_f64()
    }
}

/// Runs a search without the lock of the interpreter.
///
/// # Errors
///
/// The time limit is invalid, or a signal handler raised an exception. An error of the search itself is in the inner result.
pub fn run<T: Send>(
    py: Python<'_>,
    limit_s: f64,
    work: impl FnOnce(&Search) -> Result<T> + Send,
) -> PyResult<Result<T>> {
    let interrupt = Interrupt::after(limit(py, limit_s)?);
    let found = py.detach(|| work(&Search::until(interrupt.halt())));
    interrupt.result().map(|()| found)
}

/// Checks that a time limit, s, is positive.
pub fn limit(py: Python<'_>, seconds: f64) -> PyResult<f64> {
    if seconds > 0.0 {
        return Ok(seconds);
    }
    let what = format!("{seconds} s is no time limit; give a positive number of seconds");
    Err(crate::error::argument(py, "time_limit", what))
}
