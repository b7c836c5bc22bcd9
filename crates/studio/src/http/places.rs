//! Limits on the number of connections. If too many connections wait for a request, the connection with the longest waiting time is closed.
//! Connections with a request in process are not closed.

use std::collections::VecDeque;
use std::net::{Shutdown, TcpStream};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};

use crate::lock;

/// Maximum number of connections without a complete and accepted request. If this number is exceeded, the oldest of these connections is closed.
const WAITING: usize = 64;
/// Maximum number of requests that are processed at the same time. It is sufficient for several pages with six connections each.
const ANSWERED: usize = 96;

/// Connections that wait for a request, and the number of requests in process.
#[derive(Default)]
pub struct Places {
    waiting: Mutex<VecDeque<Arc<TcpStream>>>,
    answered: AtomicUsize,
}

impl Places {
    /// Registers a connection that waits for a request. It is registered until the returned value is dropped.
    pub fn wait(&self, stream: &Arc<TcpStream>) -> Waiting<'_> {
        let mut waiting = lock(&self.waiting);
        waiting.push_back(Arc::clone(stream));
        if waiting.len() > WAITING
            && let Some(oldest) = waiting.pop_front()
        {
            // The thread of this connection then reads the end of the stream.
            let _ = oldest.shutdown(Shutdown::Both);
        }
        let (places, stream) = (self, Arc::clone(stream));
        Waiting { places, stream }
    }

    /// Registers a request that is being processed, until the returned value is dropped. `None` if the maximum number of requests are in
    /// process.
    pub fn answer(&self) -> Option<Answering<'_>> {
        let place = Answering(&self.answered);
        (self.answered.fetch_add(1, Ordering::SeqCst) < ANSWERED).then_some(place)
    }
}

/// Registration of a connection that waits for a request.
pub struct Waiting<'p> {
    places: &'p Places,
    stream: Arc<TcpStream>,
}

impl Drop for Waiting<'_> {
    fn drop(&mut self) {
        lock(&self.places.waiting).retain(|s| !Arc::ptr_eq(s, &self.stream));
    }
}

/// Registration of a request that is being processed.
pub struct Answering<'p>(&'p AtomicUsize);

impl Drop for Answering<'_> {
    fn drop(&mut self) {
        self.0.fetch_sub(1, Ordering::SeqCst);
    }
}
