//! Whose design is computed: a bounded number at a time, and of each page only its latest question.

use std::collections::HashMap;
use std::sync::{Condvar, Mutex};

use crate::lock;

/// Pages that are remembered; beyond it all are forgotten, which only costs an unneeded design.
const PAGES: usize = 256;

/// The places at the solver.
pub struct Turns {
    state: Mutex<State>,
    freed: Condvar,
    most: usize,
}

struct State {
    busy: usize,
    latest: HashMap<String, u64>,
}

/// A place, given back when it is dropped.
pub struct Turn<'t>(&'t Turns);

impl Turns {
    /// As many places as the machine has processors, two at least: one long design must not hold up all.
    pub fn new() -> Turns {
        let processors = std::thread::available_parallelism().map_or(2, usize::from);
        Turns {
            state: Mutex::new(State {
                busy: 0,
                latest: HashMap::new(),
            }),
            freed: Condvar::new(),
            most: processors.max(2) + 1,
        }
    }

    /// Waits for a place; `None` where the page has asked something newer meanwhile.
    pub fn take(&self, page: &str, number: u64) -> Option<Turn<'_>> {
        let mut state = lock(&self.state);
        if state.latest.len() > PAGES {
            state.latest.clear();
        }
        let latest = state.latest.entry(page.to_string()).or_default();
        *latest = number.max(*latest);
        if page.is_empty() {
            // Nobody counts these questions.
            state.latest.remove(page);
        }
        // Those that wait for this page look whether they are still wanted.
        self.freed.notify_all();
        loop {
            if state
                .latest
                .get(page)
                .is_some_and(|latest| *latest > number)
            {
                return None;
            }
            if state.busy < self.most {
                state.busy += 1;
                return Some(Turn(self));
            }
            state = self
                .freed
                .wait(state)
                .unwrap_or_else(std::sync::PoisonError::into_inner);
        }
    }
}

impl Drop for Turn<'_> {
    fn drop(&mut self) {
        lock(&self.0.state).busy -= 1;
        self.0.freed.notify_all();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_question_that_is_overtaken_gets_no_place() {
        let turns = Turns::new();
        assert!(turns.take("a", 2).is_some());
        assert!(turns.take("a", 1).is_none());
        assert!(turns.take("b", 1).is_some());
    }

    #[test]
    fn places_are_bounded_and_given_back() {
        let turns = Turns::new();
        let held: Vec<_> = (0..turns.most)
            .map(|k| turns.take(&k.to_string(), 1))
            .collect();
        std::thread::scope(|scope| {
            let waiting = scope.spawn(|| turns.take("late", 1).is_some());
            std::thread::sleep(std::time::Duration::from_millis(20));
            assert!(!waiting.is_finished());
            drop(held);
            assert!(waiting.join().unwrap());
        });
    }
}
