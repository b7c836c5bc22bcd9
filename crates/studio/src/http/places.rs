//! Bounds on connections: those that wait for a request make room for newer ones, those being answered do not.

use std::collections::VecDeque;
use std::net::{Shutdown, TcpStream};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};

use crate::lock;

/// Connections without a request, or with one that is not complete or not admitted, at most; one more ends the one
/// that has waited longest.
const WAITING: usize = 64;
/// Requests that are answered at a time at most: a few pages of six connections each.
const ANSWERED: usize = 96;

/// The open connections.
#[derive(Default)]
pub struct Places {
    waiting: Mutex<VecDeque<Arc<TcpStream>>>,
    answered: AtomicUsize,
}

impl Places {
    /// Enters a connection among those that wait, until what is returned is dropped.
    pub fn wait(&self, stream: &Arc<TcpStream>) -> Waiting<'_> {
        let mut waiting = lock(&self.waiting);
        waiting.push_back(Arc::clone(stream));
        if waiting.len() > WAITING
            && let Some(oldest) = waiting.pop_front()
        {
            // Its thread reads the end.
            let _ = oldest.shutdown(Shutdown::Both);
        }
        let (places, stream) = (self, Arc::clone(stream));
        Waiting { places, stream }
    }

    /// A place among the requests that are answered, until it is dropped; `None` where all are taken.
    pub fn answer(&self) -> Option<Answering<'_>> {
        let place = Answering(&self.answered);
        (self.answered.fetch_add(1, Ordering::SeqCst) < ANSWERED).then_some(place)
    }
}

/// A connection that waits for a request.
pub struct Waiting<'p> {
    places: &'p Places,
    stream: Arc<TcpStream>,
}

impl Drop for Waiting<'_> {
    fn drop(&mut self) {
        lock(&self.places.waiting).retain(|s| !Arc::ptr_eq(s, &self.stream));
    }
}

/// A request that is answered.
pub struct Answering<'p>(&'p AtomicUsize);

impl Drop for Answering<'_> {
    fn drop(&mut self) {
        self.0.fetch_sub(1, Ordering::SeqCst);
    }
}
