//! Start of threads on systems that may reject them.

use std::thread::{Builder, Scope};

/// Starts up to `count` threads that run `work` in a scope, as many as the system permits. Returns the number of started threads.
///
/// ```
/// use gaitcam_base::threads::start;
/// use std::sync::atomic::{AtomicUsize, Ordering};
///
/// let ended = AtomicUsize::new(0);
/// let started = std::thread::scope(|scope| {
///     start(scope, 3, || drop(ended.fetch_add(1, Ordering::Relaxed)))
/// });
/// assert_eq!(ended.into_inner(), started);
/// ```
pub fn start<'scope, F>(scope: &'scope Scope<'scope, '_>, count: usize, work: F) -> usize
where
    F: FnOnce() + Clone + Send + 'scope,
{
    let begins = |_: &usize| Builder::new().spawn_scoped(scope, work.clone()).is_ok();
    (0..count).take_while(begins).count()
}
