//! One connection with consecutive requests. The size and the arrival time of each request are limited.

use std::io::{self, Read, Write};
use std::net::{Shutdown, TcpStream};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use super::places::Places;
use super::{Gone, Head, Method, Request, Response, Service, Status};
use crate::lock;

/// Maximum size of a request head, bytes.
const HEAD: usize = 16 << 10;
/// Maximum waiting time for the next request on an idle connection, and maximum time in which the body of an accepted request must arrive.
const PATIENCE: Duration = Duration::from_secs(20);
/// Maximum time in which a head must arrive, from its first byte.
const OF_HEAD: Duration = Duration::from_secs(5);
/// Time between two checks of whether the client is still connected.
const LOOK: Duration = Duration::from_millis(20);
/// Maximum time in which the rest of a rejected request is read. The client would not receive the rejection if the connection were closed earlier.
const FAREWELL: Duration = Duration::from_secs(5);

/// Connection with the bytes that have been received but not processed.
struct Connection {
    stream: Arc<TcpStream>,
    buffer: Vec<u8>,
}

/// Processes the requests of a connection until one side closes it.
pub fn serve(stream: TcpStream, service: &impl Service, places: &Places) {
    let _ = stream.set_nodelay(true);
    let _ = stream.set_write_timeout(Some(PATIENCE));
    let (stream, buffer) = (Arc::new(stream), Vec::new());
    let mut connection = Connection { stream, buffer };
    while let Ok(true) = connection.one(service, places) {}
}

impl Connection {
    /// Processes one request. Returns whether the connection remains open.
    fn one(&mut self, service: &impl Service, places: &Places) -> io::Result<bool> {
        let waiting = places.wait(&self.stream);
        let head = match self.head()? {
            Some(Ok(head)) => head,
            Some(Err(refusal)) => return self.refuse(&refusal),
            None => return Ok(false),
        };
        if let Err(refusal) = service.admit(&head) {
            return self.refuse(&refusal);
        }
        let Some(_place) = places.answer() else {
            return self.refuse(&Response::refusal(Status::Busy));
        };
        drop(waiting);
        if head.length > service.most(&head) {
            return self.refuse(&Response::refusal(Status::TooLarge));
        }
        let Some(body) = self.body(&head)? else {
            return Ok(false);
        };
        let request = Request { head, body };
        // A panic ends only this response.
        let gone = left(Arc::clone(&self.stream));
        let answer = catch_unwind(AssertUnwindSafe(|| service.answer(&request, gone)));
        let answer = answer.unwrap_or_else(|_| Response::refusal(Status::Internal));
        let head = &request.head;
        answer.write(&mut &*self.stream, head.closes, head.method != Method::Head)?;
        Ok(!head.closes)
    }

    /// Receives the next head. The result is a rejection for an invalid head. It is `None` if the client has closed the connection or the
    /// time limit is exceeded.
    fn head(&mut self) -> io::Result<Option<Result<Head, Response>>> {
        if self.buffer.is_empty() && self.more(Instant::now() + PATIENCE)? == 0 {
            return Ok(None);
        }
        let deadline = Instant::now() + OF_HEAD;
        loop {
            match Head::read(&self.buffer) {
                Ok(Some((head, length))) => {
                    self.buffer.drain(..length);
                    return Ok(Some(Ok(head)));
                }
                Err(refusal) => return Ok(Some(Err(refusal))),
                Ok(None) if self.buffer.len() > HEAD => {
                    return Ok(Some(Err(Response::refusal(Status::HeadTooLarge))));
                }
                Ok(None) => {}
            }
            if self.more(deadline)? == 0 {
                return Ok(None);
            }
        }
    }

    /// Receives the body of a request; `None` if the client has closed the connection or the time limit is exceeded.
    fn body(&mut self, head: &Head) -> io::Result<Option<Vec<u8>>> {
        let deadline = Instant::now() + PATIENCE;
        if head.expects {
            (&*self.stream).write_all(b"HTTP/1.1 100 Continue\r\n\r\n")?;
        }
        while self.buffer.len() < head.length {
            if self.more(deadline)? == 0 {
                return Ok(None);
            }
        }
        let rest = self.buffer.split_off(head.length);
        Ok(Some(std::mem::replace(&mut self.buffer, rest)))
    }

    /// Receives the available bytes and returns their number, which is 0 at the end of the stream or after the deadline.
    fn more(&mut self, deadline: Instant) -> io::Result<usize> {
        let left = deadline.saturating_duration_since(Instant::now());
        if left.is_zero() {
            return Ok(0);
        }
        self.stream.set_read_timeout(Some(left))?;
        let mut piece = [0; 16 << 10];
        let read = (&*self.stream).read(&mut piece)?;
        self.buffer.extend_from_slice(&piece[..read]);
        Ok(read)
    }

    /// Sends a rejection and closes the connection. Returns `false`, because the connection does not remain open.
    fn refuse(&mut self, refusal: &Response) -> io::Result<bool> {
        refusal.write(&mut &*self.stream, true, true)?;
        self.stream.shutdown(Shutdown::Write)?;
        let deadline = Instant::now() + FAREWELL;
        self.buffer.clear();
        while self.more(deadline)? > 0 {
            self.buffer.clear();
        }
        Ok(false)
    }
}

/// Function that checks whether the client has disconnected. The connection is checked at most once per [`LOOK`], because the check is a system
/// call.
fn left(stream: Arc<TcpStream>) -> Gone {
    let last = Mutex::new((Instant::now(), false));
    Arc::new(move || {
        let mut last = lock(&last);
        if !last.1 && last.0.elapsed() > LOOK {
            let is_end = |read: io::Result<usize>| match read {
                Ok(bytes) => bytes == 0,
                Err(e) => e.kind() != io::ErrorKind::WouldBlock,
            };
            let looked = stream.set_nonblocking(true).is_ok();
            let end = looked && is_end(stream.peek(&mut [0]));
            let _ = stream.set_nonblocking(false);
            *last = (Instant::now(), end);
        }
        last.1
    })
}
