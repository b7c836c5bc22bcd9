//! Whose design is computed: a bounded number at a time, and of each page only its latest question. A search that is
//! overtaken ends where it stands.

use std::collections::HashMap;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::time::{Duration, Instant};

use gaitcam::halt::Halt;

use crate::lock;

/// Pages that are remembered; beyond it all are forgotten, which only costs an unneeded design.
const PAGES: usize = 256;
/// The longest search.
pub const LONGEST: Duration = Duration::from_secs(60);

/// The places at the solver.
pub struct Turns {
    busy: Mutex<usize>,
    latest: Mutex<HashMap<String, Arc<AtomicU64>>>,
    freed: Condvar,
    most: usize,
}

/// A place, given back when it is dropped.
pub struct Turn<'t> {
    turns: &'t Turns,
    asked: Asked,
}

/// A question of a page.
#[derive(Clone)]
pub struct Asked {
    latest: Arc<AtomicU64>,
    number: u64,
}

impl Asked {
    /// Whether the page has asked something newer.
    pub fn is_overtaken(&self) -> bool {
        self.latest.load(Ordering::Relaxed) > self.number
    }

    /// Ends the search once the question is overtaken, or after a minute.
    pub fn halt(&self) -> Halt {
        let (asked, end) = (self.clone(), Instant::now() + LONGEST);
        Halt::when(move || asked.is_overtaken() || Instant::now() >= end)
    }
}

impl Turn<'_> {
    /// The question that has the place.
    pub fn asked(&self) -> &Asked {
        &self.asked
    }
}

impl Turns {
    /// As many places as the machine has processors and one more: one long design must not hold up all.
    pub fn new() -> Turns {
        let processors = std::thread::available_parallelism().map_or(2, usize::from);
        Turns {
            busy: Mutex::new(0),
            latest: Mutex::default(),
            freed: Condvar::new(),
            most: processors.max(2) + 1,
        }
    }

    /// A question; whatever the page asked before is overtaken. Nobody counts the questions of a page without
    /// a name.
    pub fn ask(&self, page: &str, number: u64) -> Asked {
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
            // Those that wait for this page look whether they are still wanted.
            self.freed.notify_all();
        }
        let number = if page.is_empty() { u64::MAX } else { number };
        Asked { latest, number }
    }

    /// Waits for a place; `None` where the page has asked something newer meanwhile.
    pub fn take(&self, asked: &Asked) -> Option<Turn<'_>> {
        let mut busy = lock(&self.busy);
        loop {
            if asked.is_overtaken() {
                return None;
            }
            if *busy < self.most {
                *busy += 1;
                let asked = asked.clone();
                return Some(Turn { turns: self, asked });
            }
            busy = self
                .freed
                .wait(busy)
                .unwrap_or_else(PoisonError::into_inner);
        }
    }
}

impl Drop for Turn<'_> {
    fn drop(&mut self) {
        *lock(&self.turns.busy) -= 1;
        self.turns.freed.notify_all();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_question_that_is_overtaken_gets_no_place_and_its_search_ends() {
        let turns = Turns::new();
        let first = turns.ask("a", 1);
        let halt = first.halt();
        assert!(turns.take(&first).is_some() && !halt.is_asked());
        let second = turns.ask("a", 2);
        assert!(turns.take(&second).is_some());
        assert!(turns.take(&first).is_none() && halt.is_asked());
        assert!(turns.take(&turns.ask("b", 1)).is_some());
        assert!(turns.take(&turns.ask("", 0)).is_some());
    }

    #[test]
    fn places_are_bounded_and_given_back() {
        let turns = Turns::new();
        let held: Vec<_> = (0..turns.most)
            .map(|k| turns.take(&turns.ask(&k.to_string(), 1)))
            .collect();
        std::thread::scope(|scope| {
            let waiting = scope.spawn(|| turns.take(&turns.ask("late", 1)).is_some());
            std::thread::sleep(Duration::from_millis(20));
            assert!(!waiting.is_finished());
            drop(held);
            assert!(waiting.join().unwrap());
        });
    }
}
