//! Scheduler of designs: bounded concurrency; the latest request of a page ends its earlier ones.

use std::collections::HashMap;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::time::{Duration, Instant};

use gaitcam::halt::Halt;

use crate::lock;

/// Pages whose latest request is kept; beyond this all are dropped, which at worst computes an outdated design.
const PAGES: usize = 256;
/// The longest search.
pub const LONGEST: Duration = Duration::from_secs(60);

/// The scheduler.
pub struct Scheduler {
    busy: Mutex<usize>,
    latest: Mutex<HashMap<String, Arc<AtomicU64>>>,
    freed: Condvar,
    most: usize,
}

/// The right to compute one design, released on drop.
pub struct Slot<'s> {
    scheduler: &'s Scheduler,
    ticket: Ticket,
}

/// A request of a page, with its number.
#[derive(Clone)]
pub struct Ticket {
    latest: Arc<AtomicU64>,
    number: u64,
}

impl Ticket {
    /// Whether the page has sent a newer request.
    pub fn is_outdated(&self) -> bool {
        self.latest.load(Ordering::Relaxed) > self.number
    }

    /// Ends the search once the request is outdated, or after [`LONGEST`].
    pub fn halt(&self) -> Halt {
        let (ticket, end) = (self.clone(), Instant::now() + LONGEST);
        Halt::when(move || ticket.is_outdated() || Instant::now() >= end)
    }
}

impl Slot<'_> {
    /// The request that holds the slot.
    pub fn ticket(&self) -> &Ticket {
        &self.ticket
    }
}

impl Scheduler {
    /// One slot more than the machine has processors, so that one long design does not block all.
    pub fn new() -> Scheduler {
        let processors = std::thread::available_parallelism().map_or(2, usize::from);
        Scheduler {
            busy: Mutex::new(0),
            latest: Mutex::default(),
            freed: Condvar::new(),
            most: processors.max(2) + 1,
        }
    }

    /// Registers a request and outdates the earlier ones of its page. Requests without a page are never outdated.
    pub fn register(&self, page: &str, number: u64) -> Ticket {
        let latest = match page {
            "" => Arc::default(),
            page => {
                let mut pages = lock(&self.latest);
                if pages.len() > PAGES {
                    pages.clear();
                }
                Arc::clone(pages.entry(page.to_string()).or_default())
            }
        };
        if !page.is_empty() {
            latest.fetch_max(number, Ordering::Relaxed);
            // Waiting requests of this page check whether they are outdated.
            self.freed.notify_all();
        }
        let number = if page.is_empty() { u64::MAX } else { number };
        Ticket { latest, number }
    }

    /// Waits for a slot; `None` if the request is outdated.
    pub fn acquire(&self, ticket: &Ticket) -> Option<Slot<'_>> {
        let mut busy = lock(&self.busy);
        loop {
            if ticket.is_outdated() {
                return None;
            }
            if *busy < self.most {
                *busy += 1;
                let (scheduler, ticket) = (self, ticket.clone());
                return Some(Slot { scheduler, ticket });
            }
            busy = self
                .freed
                .wait(busy)
                .unwrap_or_else(PoisonError::into_inner);
        }
    }
}

impl Drop for Slot<'_> {
    fn drop(&mut self) {
        *lock(&self.scheduler.busy) -= 1;
        self.scheduler.freed.notify_all();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_question_that_is_outdated_gets_no_place_and_its_search_ends() {
        let scheduler = Scheduler::new();
        let first = scheduler.register("a", 1);
        let halt = first.halt();
        assert!(scheduler.acquire(&first).is_some() && !halt.is_asked());
        let second = scheduler.register("a", 2);
        assert!(scheduler.acquire(&second).is_some());
        assert!(scheduler.acquire(&first).is_none() && halt.is_asked());
        assert!(scheduler.acquire(&scheduler.register("b", 1)).is_some());
        assert!(scheduler.acquire(&scheduler.register("", 0)).is_some());
    }

    #[test]
    fn slots_are_bounded_and_released() {
        let scheduler = Scheduler::new();
        let held: Vec<_> = (0..scheduler.most)
            .map(|k| scheduler.acquire(&scheduler.register(&k.to_string(), 1)))
            .collect();
        std::thread::scope(|scope| {
            let waiting =
                scope.spawn(|| scheduler.acquire(&scheduler.register("late", 1)).is_some());
            std::thread::sleep(Duration::from_millis(20));
            assert!(!waiting.is_finished());
            drop(held);
            assert!(waiting.join().unwrap());
        });
    }
}
