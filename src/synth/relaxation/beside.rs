//! Parallel searches on all cores, while the calling thread polls its stop condition ([`Halt`]).

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{self, Thread};
use std::time::Duration;

use gaitcam_base::threads;

use crate::halt::Halt;

/// Time between two polls of the stop condition of the caller.
const LOOK: Duration = Duration::from_millis(10);

/// Results of `search` for all items, in the order of the items. The searches do not depend on each other.
///
/// The stop condition of the caller may work only in the thread of the caller, as in Python. This thread therefore polls the condition, and sets
/// a flag that the searches poll.
pub fn beside<T: Sync, R: Send>(
    items: &[T],
    halt: &Halt,
    search: impl Fn(&T, &Halt) -> R + Sync,
) -> Vec<R> {
    let on_this_thread = || items.iter().map(|item| search(item, halt)).collect();
    // In a thread pool all cores are already busy, and a module in a browser has only one thread.
    if items.len() < 2 || rayon::current_thread_index().is_some() || cfg!(target_family = "wasm") {
        return on_this_thread();
    }
    let asked = Arc::new(AtomicBool::new(false));
    let told = Arc::clone(&asked);
    let own = Halt::when(move || told.load(Ordering::Relaxed));
    let caller = thread::current();
    let (next, done) = (AtomicUsize::new(0), AtomicUsize::new(0));
    let found = Mutex::new(Vec::with_capacity(items.len()));
    // Separate threads are used, because in a shared thread pool a search may have to wait for unrelated work.
    let work = || {
        let _end = End {
            done: &done,
            caller: &caller,
        };
        loop {
            let at = next.fetch_add(1, Ordering::Relaxed);
            let Some(item) = items.get(at) else { break };
            let result = search(item, &own);
            if let Ok(mut found) = found.lock() {
                found.push((at, result));
            }
        }
    };
    let count = thread::available_parallelism().map_or(1, usize::from);
    let started = thread::scope(|scope| {
        let started = threads::start(scope, count.min(items.len()), work);
        while done.load(Ordering::Acquire) < started {
            if halt.is_asked() {
                asked.store(true, Ordering::Relaxed);
            }
            thread::park_timeout(LOOK);
        }
        started
    });
    if started == 0 {
        return on_this_thread();
    }
    let mut found = found.into_inner().unwrap_or_else(PoisonError::into_inner);
    found.sort_by_key(|&(at, _)| at);
    found.into_iter().map(|(_, result)| result).collect()
}

/// Signals the end of a search thread, also after a panic.
struct End<'a> {
    done: &'a AtomicUsize,
    caller: &'a Thread,
}

impl Drop for End<'_> {
    fn drop(&mut self) {
        self.done.fetch_add(1, Ordering::Release);
        self.caller.unpark();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_stand_in_the_order_of_the_items() {
        let items: Vec<u64> = (0..100).collect();
        let squares = beside(&items, &Halt::never(), |&i, _| i * i);
        assert!(
            squares
                .iter()
                .enumerate()
                .all(|(i, &s)| s == (i * i) as u64)
        );
    }

    #[test]
    fn a_halt_that_only_the_callers_thread_hears_ends_every_search() {
        let caller = thread::current().id();
        let halt = Halt::when(move || thread::current().id() == caller);
        let until_told = |_: &i32, halt: &Halt| {
            while !halt.is_asked() {
                thread::yield_now();
            }
            thread::current().id() != caller
        };
        assert!(beside(&[1, 2, 3], &halt, until_told).iter().all(|&b| b));
    }

    #[test]
    #[should_panic(expected = "a scoped thread panicked")]
    fn a_panic_of_a_search_is_the_callers() {
        beside(&[1, 2], &Halt::never(), |_, _| panic!("what a search says"));
    }

    #[test]
    fn a_thread_of_a_pool_searches_by_itself() {
        let own = |_: &i32, _: &Halt| thread::current().id();
        let (here, found) = rayon::scope(|_| {
            let found = beside(&[1, 2, 3], &Halt::never(), own);
            (thread::current().id(), found)
        });
        assert!(found.iter().all(|&thread| thread == here));
    }
}
