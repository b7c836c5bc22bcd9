//! One connection: requests one after another, each within its limits.

use std::io::{self, Read, Write};
use std::net::{Shutdown, TcpStream};
use std::time::{Duration, Instant};

use super::{Head, Method, Request, Response, Service, Status, answered, socket};

/// Largest head, bytes.
const HEAD: usize = 16 << 10;
/// A request has this long to arrive, and an idle connection to ask again.
const PATIENCE: Duration = Duration::from_secs(20);
/// What is still being sent after a refusal is read away this long, so that the refusal arrives.
const FAREWELL: Duration = Duration::from_secs(5);

/// Serves a connection until one side ends it.
pub fn serve(mut stream: TcpStream, service: &impl Service) {
    let _ = stream.set_nodelay(true);
    let _ = stream.set_write_timeout(Some(PATIENCE));
    let mut buffer = Vec::new();
    while let Ok(true) = one(&mut stream, &mut buffer, service) {}
}

/// One request and its answer; whether the connection goes on.
fn one(stream: &mut TcpStream, buffer: &mut Vec<u8>, service: &impl Service) -> io::Result<bool> {
    let deadline = Instant::now() + PATIENCE;
    let (head, length) = match head(stream, buffer, deadline)? {
        Some(Ok(found)) => found,
        Some(Err(refusal)) => return refuse(stream, &refusal),
        None => return Ok(false),
    };
    buffer.drain(..length);
    if let Err(refusal) = service.admit(&head) {
        return refuse(stream, &refusal);
    }
    if let Some(key) = head.socket() {
        let key = key.to_string();
        socket::serve(stream, std::mem::take(buffer), head, &key, service)?;
        return Ok(false);
    }
    if head.length > service.most(&head) {
        return refuse(stream, &Response::refusal(Status::TooLarge));
    }
    if head.expects {
        stream.write_all(b"HTTP/1.1 100 Continue\r\n\r\n")?;
    }
    while buffer.len() < head.length {
        if more(stream, buffer, deadline)? == 0 {
            return Ok(false);
        }
    }
    let rest = buffer.split_off(head.length);
    let request = Request {
        head,
        body: std::mem::replace(buffer, rest),
    };
    let answer = answered(service, &request);
    let head = &request.head;
    answer.write(stream, head.closes, head.method != Method::Head)?;
    Ok(!head.closes)
}

type Found = Result<(Head, usize), Response>;

/// The next head; `None` where the other side has ended.
fn head(
    stream: &mut TcpStream,
    buffer: &mut Vec<u8>,
    deadline: Instant,
) -> io::Result<Option<Found>> {
    loop {
        match Head::read(buffer) {
            Ok(Some(found)) => return Ok(Some(Ok(found))),
            Err(refusal) => return Ok(Some(Err(refusal))),
            Ok(None) if buffer.len() > HEAD => {
                return Ok(Some(Err(Response::refusal(Status::HeadTooLarge))));
            }
            Ok(None) => {}
        }
        if more(stream, buffer, deadline)? == 0 {
            return Ok(None);
        }
    }
}

/// Reads what has arrived; 0 at the end.
fn more(stream: &mut TcpStream, buffer: &mut Vec<u8>, deadline: Instant) -> io::Result<usize> {
    let left = deadline.saturating_duration_since(Instant::now());
    if left.is_zero() {
        return Ok(0);
    }
    stream.set_read_timeout(Some(left))?;
    let mut piece = [0; 16 << 10];
    let read = stream.read(&mut piece)?;
    buffer.extend_from_slice(&piece[..read]);
    Ok(read)
}

/// Says no and ends the connection.
fn refuse(stream: &mut TcpStream, refusal: &Response) -> io::Result<bool> {
    refusal.write(stream, true, true)?;
    stream.shutdown(Shutdown::Write)?;
    let deadline = Instant::now() + FAREWELL;
    let mut thrown_away = Vec::new();
    while more(stream, &mut thrown_away, deadline)? > 0 {
        thrown_away.clear();
    }
    Ok(false)
}
