//! A WebSocket (RFC 6455) at the address of a question: every text is the body of a question to that address, and its
//! answer's body comes back as a text. A browser spends ten milliseconds less on a message than on a request.

use std::io::{self, Read, Write};
use std::net::TcpStream;

use data_encoding::BASE64;
use sha1_smol::Sha1;

use super::frame::{self, Kind, Reason};
use super::{Head, Request, Service, Status, answered};

/// What section 1.3 of the standard adds to a client's key.
const SUFFIX: &str = "258EAFA5-E914-47DA-95CA-C5AB0DC85B11";

/// Serves the WebSocket on a connection whose head asked for it with `key`, until one side ends it. `buffer` holds
/// what has come after the head.
pub fn serve(
    stream: &mut TcpStream,
    mut buffer: Vec<u8>,
    head: Head,
    key: &str,
    service: &impl Service,
) -> io::Result<()> {
    stream.write_all(handshake(key).as_bytes())?;
    // A page may be left open over night.
    stream.set_read_timeout(None)?;
    let mut request = Request {
        head: head.into_question(),
        body: Vec::new(),
    };
    let most = service.most(&request.head);
    loop {
        match text(stream, &mut buffer, most)? {
            Ok(text) => request.body = text,
            Err(reason) => return close(stream, reason),
        }
        let answer = answered(service, &request);
        if !matches!(answer.status, Status::Ok | Status::BadRequest) {
            return close(stream, Reason::Internal);
        }
        stream.write_all(&frame::written(Kind::Text, &answer.body))?;
    }
}

/// The answer that makes a connection a WebSocket.
fn handshake(key: &str) -> String {
    let mut digest = Sha1::new();
    digest.update(key.as_bytes());
    digest.update(SUFFIX.as_bytes());
    let accept = BASE64.encode(&digest.digest().bytes());
    format!(
        "HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n\
         Sec-WebSocket-Accept: {accept}\r\n\r\n"
    )
}

/// The next text, or why there is none.
fn text(
    stream: &mut TcpStream,
    buffer: &mut Vec<u8>,
    most: usize,
) -> io::Result<Result<Vec<u8>, Reason>> {
    let mut begun: Option<Vec<u8>> = None;
    loop {
        let frame = match frame::read(buffer, most) {
            Ok(Some((frame, length))) => {
                buffer.drain(..length);
                frame
            }
            Ok(None) => {
                more(stream, buffer)?;
                continue;
            }
            Err(reason) => return Ok(Err(reason)),
        };
        match (frame.kind, begun.as_mut()) {
            (Kind::Text, None) => begun = Some(frame.data),
            (Kind::Continued, Some(text)) => text.extend(frame.data),
            (Kind::Text | Kind::Continued, _) => return Ok(Err(Reason::NoFrame)),
            (Kind::Ping, _) => stream.write_all(&frame::written(Kind::Pong, &frame.data))?,
            (Kind::Pong, _) => {}
            (Kind::Close, _) => return Ok(Err(Reason::Done)),
        }
        if begun.as_ref().is_some_and(|text| text.len() > most) {
            return Ok(Err(Reason::TooLarge));
        }
        let is_part = matches!(frame.kind, Kind::Text | Kind::Continued);
        if let Some(text) = begun.take_if(|_| is_part && frame.ends) {
            let checked = String::from_utf8(text).map(String::into_bytes);
            return Ok(checked.map_err(|_| Reason::NotUtf8));
        }
    }
}

/// Reads what has arrived.
fn more(stream: &mut TcpStream, buffer: &mut Vec<u8>) -> io::Result<()> {
    let mut piece = [0; 16 << 10];
    let read = stream.read(&mut piece)?;
    if read == 0 {
        return Err(io::ErrorKind::UnexpectedEof.into());
    }
    buffer.extend_from_slice(&piece[..read]);
    Ok(())
}

/// Says why and ends.
fn close(stream: &mut TcpStream, reason: Reason) -> io::Result<()> {
    let code = (reason as u16).to_be_bytes();
    stream.write_all(&frame::written(Kind::Close, &code))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_key_of_the_standards_example_is_accepted_as_it_says() {
        let answer = handshake("dGhlIHNhbXBsZSBub25jZQ==");
        assert!(answer.contains("Sec-WebSocket-Accept: s3pPLMBiTxaQ9kYGzzhZRbK+xOo=\r\n"));
    }
}
