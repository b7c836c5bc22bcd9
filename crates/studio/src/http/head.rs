//! Head of a request: method, address and the headers that the server uses.

use super::{Response, Status};

/// Maximum number of headers in a request.
const HEADERS: usize = 64;

/// HTTP method of a request: GET, HEAD or POST.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// GET: requests a resource.
    Get,
    /// HEAD: requests a resource without its body.
    Head,
    /// POST: sends data and requests a response.
    Post,
}

/// Head of an HTTP request: method, address and headers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Head {
    /// HTTP method of the request.
    pub method: Method,
    /// Path of the address, percent-decoded.
    pub path: String,
    /// Query of the address as pairs of names and values, percent-decoded.
    pub query: Vec<(String, String)>,
    /// Values of all `Host` headers. A valid request has exactly one.
    pub hosts: Vec<String>,
    /// Value of the header `Origin`; `None` without this header.
    pub origin: Option<String>,
    /// Length of the body, bytes.
    pub length: usize,
    /// Whether the client waits for a confirmation before it sends the body.
    pub expects: bool,
    /// Whether the client requests that the server closes the connection after the response.
    pub closes: bool,
}

impl Head {
    /// Value of the query parameter `name`; `None` if it is missing.
    pub fn asked(&self, name: &str) -> Option<&str> {
        let found = self.query.iter().find(|(n, _)| n == name);
        found.map(|(_, value)| value.as_str())
    }

    /// Parses a head and returns it with its length in bytes. The result is `None` while the head is incomplete.
    ///
    /// # Errors
    ///
    /// The bytes are not a head, or the server does not support the request.
    pub fn read(bytes: &[u8]) -> Result<Option<(Head, usize)>, Response> {
        let mut headers = [httparse::EMPTY_HEADER; HEADERS];
        let mut parsed = httparse::Request::new(&mut headers);
        let length = match parsed.parse(bytes) {
            Ok(httparse::Status::Complete(length)) => length,
            Ok(httparse::Status::Partial) => return Ok(None),
            Err(_) => return Err(Response::refusal(Status::BadRequest)),
        };
        Head::of(&parsed).map(|head| Some((head, length)))
    }

    fn of(parsed: &httparse::Request) -> Result<Head, Response> {
        let bad = || Response::refusal(Status::BadRequest);
        let method = match parsed.method {
            Some("GET") => Method::Get,
            Some("HEAD") => Method::Head,
            Some("POST") => Method::Post,
            _ => return Err(Response::refusal(Status::MethodNotAllowed)),
        };
        let target = parsed.path.unwrap_or("/");
        let (path, query) = target.split_once('?').unwrap_or((target, ""));
        let mut head = Head {
            method,
            path: decoded(path).ok_or_else(bad)?,
            query: pairs(query).ok_or_else(bad)?,
            hosts: Vec::new(),
            origin: None,
            length: 0,
            expects: false,
            closes: parsed.version == Some(0),
        };
        for header in parsed.headers.iter() {
            let value = std::str::from_utf8(header.value).map_err(|_| bad())?;
            head.take(header.name, value.trim())?;
        }
        Ok(head)
    }

    fn take(&mut self, name: &str, value: &str) -> Result<(), Response> {
        match name.to_ascii_lowercase().as_str() {
            "host" => self.hosts.push(value.to_string()),
            "origin" => self.origin = Some(value.to_string()),
            "content-length" => {
                let length = value.parse().ok().filter(|_| self.length == 0);
                self.length = length.ok_or_else(|| Response::refusal(Status::BadRequest))?;
            }
            "transfer-encoding" => return Err(Response::refusal(Status::LengthRequired)),
            "expect" => self.expects = value.eq_ignore_ascii_case("100-continue"),
            "connection" if value.eq_ignore_ascii_case("close") => self.closes = true,
            _ => {}
        }
        Ok(())
    }
}

fn pairs(query: &str) -> Option<Vec<(String, String)>> {
    let given = query.split('&').filter(|pair| !pair.is_empty());
    given
        .map(|pair| {
            let (name, value) = pair.split_once('=').unwrap_or((pair, ""));
            Some((decoded(name)?, decoded(&value.replace('+', " "))?))
        })
        .collect()
}

/// Percent-decoded text; `None` if the decoded bytes are not UTF-8.
fn decoded(text: &str) -> Option<String> {
    let mut out = Vec::with_capacity(text.len());
    let mut rest = text.as_bytes();
    while let [first, more @ ..] = rest {
        rest = more;
        if *first != b'%' {
            out.push(*first);
            continue;
        }
        let code = more.get(..2).and_then(|c| std::str::from_utf8(c).ok())?;
        out.push(u8::from_str_radix(code, 16).ok()?);
        rest = &more[2..];
    }
    String::from_utf8(out).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn head(text: &str) -> Result<Option<(Head, usize)>, Response> {
        Head::read(text.as_bytes())
    }

    #[test]
    fn addresses_are_decoded_and_queries_split() {
        let text = "GET /a%20b?token=1%2b2&x=y+z HTTP/1.1\r\nHost: h\r\n\r\nrest";
        let (head, length) = head(text).unwrap().unwrap();
        assert_eq!(head.path, "/a b");
        assert_eq!(head.asked("token"), Some("1+2"));
        assert_eq!(head.asked("x"), Some("y z"));
        assert_eq!(length, text.len() - 4);
    }

    #[test]
    fn a_head_in_pieces_waits_and_a_broken_one_is_refused() {
        assert_eq!(head("GET / HTTP/1.1\r\nHo").unwrap(), None);
        for broken in [
            "\0\0\0\r\n\r\n",
            "GET /%zz HTTP/1.1\r\n\r\n",
            "GET /%ff HTTP/1.1\r\n\r\n",
            "POST / HTTP/1.1\r\nContent-Length: -4\r\n\r\n",
            "POST / HTTP/1.1\r\nContent-Length: 4\r\nContent-Length: 5\r\n\r\n",
            "POST / HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\n",
            "DELETE / HTTP/1.1\r\n\r\n",
        ] {
            assert!(head(broken).is_err(), "{broken:?}");
        }
    }

    /// Any sequence of bytes gives a head or a rejection without a panic. The head does not depend on the bytes after it.
    #[test]
    fn damaged_heads_end_where_they_end_and_nothing_panics() {
        const HEADS: [&str; 2] = [
            "GET /a%20b?token=1%2b2&x=y+z HTTP/1.0\r\nHost: h\r\nConnection: close\r\n\r\nrest",
            "POST /0123456789abcdef/design?language=es HTTP/1.1\r\nHost: 127.0.0.1:8080\r\nOrigin: http://127.0.0.1:8080\r\n\
             Content-Length: 12\r\nExpect: 100-continue\r\n\r\n",
        ];
        // Xorshift generator with a fixed seed, so that the damage is the same in every run.
        let mut state = 0x9e37_79b9_7f4a_7c15_u64;
        let mut roll = |below: usize| {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 11) as usize % below
        };
        let length = |bytes: &[u8]| Some(Head::read(bytes).ok()??.1);
        let mut whole = 0;
        for round in 0..40_000 {
            let mut bytes = HEADS[round % HEADS.len()].as_bytes().to_vec();
            for _ in 0..roll(5) {
                let at = roll(bytes.len());
                match roll(4) {
                    0 => bytes[at] = roll(256) as u8,
                    1 => bytes.insert(at, b"%&=?: \r\n\0"[roll(9)]),
                    2 => drop(bytes.drain(at..(at + roll(9)).min(bytes.len() - 1).max(at))),
                    _ => bytes.extend_from_within(at..),
                }
            }
            let Some(end) = length(&bytes) else { continue };
            whole += 1;
            assert!((1..=bytes.len()).contains(&end));
            assert_eq!(length(&bytes[..end]), Some(end), "{bytes:?}");
            assert_eq!(length(&bytes[..end - 1]), None, "{bytes:?}");
        }
        assert!(whole > 10_000, "{whole} heads of 40 000 are whole");
    }
}
