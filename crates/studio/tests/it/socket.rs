//! The same questions over a WebSocket.

use std::io::{Read, Write};
use std::net::TcpStream;
use std::time::Duration;

use serde_json::{Value, json};

use super::client::Running;
use gaitcam::scene::DEFAULT;

/// A client that speaks in frames of its own making.
struct Socket(TcpStream);

impl Socket {
    /// Asks for a WebSocket and gives it with the first line of the answer.
    fn connect(studio: &Running, target: &str, more: &str) -> (Socket, String) {
        let mut stream = TcpStream::connect(("127.0.0.1", studio.port)).unwrap();
        let patience = Some(Duration::from_secs(30));
        stream.set_read_timeout(patience).unwrap();
        let host = studio.host();
        let head = format!(
            "GET {target} HTTP/1.1\r\nHost: {host}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n\
             Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n{more}\r\n"
        );
        stream.write_all(head.as_bytes()).unwrap();
        let mut answer = Vec::new();
        while !answer.ends_with(b"\r\n\r\n") {
            let mut byte = [0];
            stream.read_exact(&mut byte).unwrap();
            answer.extend(byte);
        }
        let answer = String::from_utf8(answer).unwrap();
        (Socket(stream), answer.lines().next().unwrap().to_string())
    }

    fn open(studio: &Running) -> Socket {
        let target = format!("/{}/design?language=en", studio.token);
        let (socket, line) = Socket::connect(studio, &target, "");
        assert_eq!(line, "HTTP/1.1 101 Switching Protocols");
        socket
    }

    fn sends(&mut self, first: u8, data: &[u8]) {
        let mask = [0x12, 0x34, 0x56, 0x78];
        let mut bytes = vec![first, 0x80 | 127];
        bytes.extend((data.len() as u64).to_be_bytes());
        if data.len() <= 125 {
            bytes = vec![first, 0x80 | data.len() as u8];
        }
        bytes.extend(mask);
        bytes.extend(data.iter().zip(mask.iter().cycle()).map(|(d, m)| d ^ m));
        self.0.write_all(&bytes).unwrap();
    }

    /// The next frame: its first byte and its contents.
    fn receives(&mut self) -> (u8, Vec<u8>) {
        let mut head = [0; 2];
        self.0.read_exact(&mut head).unwrap();
        let wide = match head[1] {
            126 => 2,
            127 => 8,
            _ => 0,
        };
        let mut long = [0; 8];
        self.0.read_exact(&mut long[8 - wide..]).unwrap();
        let long = u64::from_be_bytes(long) as usize;
        let length = if wide > 0 { long } else { head[1] as usize };
        let mut data = vec![0; length];
        self.0.read_exact(&mut data).unwrap();
        (head[0], data)
    }

    fn asks(&mut self, question: &Value) -> Value {
        self.sends(0x81, question.to_string().as_bytes());
        let (first, data) = self.receives();
        assert_eq!(first, 0x81);
        serde_json::from_slice(&data).unwrap()
    }
}

/// Names of what differs between two answers, but for their own names and times.
fn different(one: &Value, other: &Value) -> Vec<String> {
    let (one, other) = (one.as_object().unwrap(), other.as_object().unwrap());
    assert!(one.keys().eq(other.keys()));
    let own = ["id", "server_ms", "tables"];
    let names = one.keys().filter(|name| one[*name] != other[*name]);
    names
        .filter(|n| !own.contains(&n.as_str()))
        .cloned()
        .collect()
}

#[test]
fn an_answer_is_the_same_as_to_a_request() {
    let studio = Running::new();
    let mut socket = Socket::open(&studio);
    let question = json!({"scene": DEFAULT});
    let posted = studio.post("design", question.to_string().as_bytes());
    let posted = posted.json();
    for _ in 0..3 {
        assert!(different(&socket.asks(&question), &posted).is_empty());
    }
    let fault = socket.asks(&json!({"scene": "name = "}));
    assert_eq!(fault["error"]["code"], "studio-not-toml");
    let nonsense = socket.asks(&json!([]));
    assert_eq!(nonsense["error"]["code"], "studio-bad-request");
    assert!(different(&socket.asks(&question), &posted).is_empty());
}

#[test]
fn a_question_may_come_in_pieces_with_a_ping_between() {
    let studio = Running::new();
    let mut socket = Socket::open(&studio);
    let text = json!({"scene": DEFAULT}).to_string();
    let (first, rest) = text.as_bytes().split_at(100);
    let (second, third) = rest.split_at(rest.len() / 2);
    socket.sends(0x01, first);
    socket.sends(0x89, b"there?");
    assert_eq!(socket.receives(), (0x8a, b"there?".to_vec()));
    socket.sends(0x00, second);
    socket.sends(0x80, third);
    let (_, data) = socket.receives();
    let answer: Value = serde_json::from_slice(&data).unwrap();
    assert_eq!(answer["verdict"], "acceptable");
}

#[test]
fn what_is_no_question_ends_the_conversation_with_its_reason() {
    let studio = Running::new();
    let large = vec![b'x'; 5 << 20];
    for (first, data, code) in [
        (0x82, &b"bytes"[..], 1003_u16),
        (0x80, b"more of nothing", 1002),
        (0xf1, b"an extension", 1002),
        (0x81, b"\xff\xfe", 1007),
        (0x81, &large, 1009),
        (0x88, b"", 1000),
    ] {
        let mut socket = Socket::open(&studio);
        // The server need not read a text to its end that is too large.
        if first == 0x81 && data.len() > 1000 {
            let length = (data.len() as u64).to_be_bytes();
            socket.0.write_all(&[0x81, 0x80 | 127]).unwrap();
            socket.0.write_all(&length).unwrap();
        } else {
            socket.sends(first, data);
        }
        assert_eq!(socket.receives(), (0x88, code.to_be_bytes().to_vec()));
        let mut rest = Vec::new();
        assert_eq!(socket.0.read_to_end(&mut rest).unwrap_or(0), 0);
    }
    let mut socket = Socket::open(&studio);
    socket.0.write_all(b"\x81\x05Hello").unwrap();
    assert_eq!(
        socket.receives(),
        (0x88, vec![0x03, 0xea]),
        "a client must mask"
    );
    // Where no question lives there is no answer to give.
    let target = format!("/{}/nothing", studio.token);
    let (mut nowhere, _) = Socket::connect(&studio, &target, "");
    nowhere.sends(0x81, b"{}");
    assert_eq!(nowhere.receives().0, 0x88);
}

#[test]
fn only_the_page_itself_may_open_one() {
    let studio = Running::new();
    let wrong = format!("/{}/design", "0".repeat(studio.token.len()));
    let own = format!("/{}/design", studio.token);
    for (target, more) in [
        (&wrong, ""),
        (&own, "Origin: http://evil.example\r\n"),
        (&own, "Origin: null\r\n"),
    ] {
        let (_, line) = Socket::connect(&studio, target, more);
        assert_eq!(line, "HTTP/1.1 403 Forbidden", "{target} {more}");
    }
}
