//! Stop condition of a computation. The library does not read a clock. The caller supplies the condition, for example a time limit.

use std::fmt;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// Stop condition, polled by every iterative computation between its steps. When it is true, the computation returns its best result so
/// far.
///
/// ```
/// use gaitcam_base::halt::Halt;
/// use std::sync::Arc;
/// use std::sync::atomic::{AtomicBool, Ordering};
///
/// let cancelled = Arc::new(AtomicBool::new(false));
/// let asked = Arc::clone(&cancelled);
/// let halt = Halt::when(move || asked.load(Ordering::Relaxed));
/// assert!(!halt.is_asked());
/// cancelled.store(true, Ordering::Relaxed);
/// assert!(halt.is_asked() && !Halt::never().is_asked());
/// ```
#[derive(Clone, Default)]
pub struct Halt {
    asked: Option<Arc<dyn Fn() -> bool + Send + Sync>>,
    /// Whether the condition was true at any poll of this object or of a copy.
    was_heard: Arc<AtomicBool>,
}

impl Halt {
    /// A condition that never stops a computation.
    pub fn never() -> Self {
        Halt::default()
    }

    /// A condition that stops computations when `asked` returns true. `asked` is called often, from any thread.
    pub fn when(asked: impl Fn() -> bool + Send + Sync + 'static) -> Self {
        Halt {
            asked: Some(Arc::new(asked)),
            was_heard: Arc::default(),
        }
    }

    /// The condition with a limit on the number of polls. After `looks` polls it is always true.
    ///
    /// For the same input, a computation polls equally often on every machine. With this limit, the result does not depend on the speed of
    /// the machine.
    ///
    /// ```
    /// use gaitcam_base::halt::Halt;
    ///
    /// let halt = Halt::never().or_after(2);
    /// assert_eq!([(); 4].map(|()| halt.is_asked()), [false, false, true, true]);
    /// ```
    #[must_use]
    pub fn or_after(self, looks: usize) -> Self {
        let left = AtomicUsize::new(looks);
        let one_less = |n: usize| Some(n.saturating_sub(1));
        Halt::when(move || {
            let before = left.fetch_update(Ordering::Relaxed, Ordering::Relaxed, one_less);
            before == Ok(0) || self.is_asked()
        })
    }

    /// Polls the condition; true if the computation should stop.
    pub fn is_asked(&self) -> bool {
        let is_asked = self.asked.as_ref().is_some_and(|asked| asked());
        if is_asked {
            self.was_heard.store(true, Ordering::Relaxed);
        }
        is_asked
    }

    /// Whether the condition was true at any poll, so that a computation was stopped. Otherwise the result does not depend on time.
    ///
    /// ```
    /// use gaitcam_base::halt::Halt;
    ///
    /// let halt = Halt::when(|| true);
    /// assert!(!halt.was_heard());
    /// assert!(halt.clone().is_asked() && halt.was_heard());
    /// ```
    pub fn was_heard(&self) -> bool {
        self.was_heard.load(Ordering::Relaxed)
    }
}

impl fmt::Debug for Halt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if self.asked.is_some() {
            "Halt::when"
        } else {
            "Halt::never"
        })
    }
}
