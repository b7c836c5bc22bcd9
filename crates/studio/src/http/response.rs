//! Answers, with the headers that keep a page to itself.

use std::io::{self, Write};

/// Status codes that this server answers with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// 200.
    Ok,
    /// 400.
    BadRequest,
    /// 403.
    Forbidden,
    /// 404.
    NotFound,
    /// 405.
    MethodNotAllowed,
    /// 411.
    LengthRequired,
    /// 413.
    TooLarge,
    /// 431.
    HeadTooLarge,
    /// 500.
    Internal,
    /// 503.
    Busy,
}

impl Status {
    fn line(self) -> &'static str {
        match self {
            Status::Ok => "200 OK",
            Status::BadRequest => "400 Bad Request",
            Status::Forbidden => "403 Forbidden",
            Status::NotFound => "404 Not Found",
            Status::MethodNotAllowed => "405 Method Not Allowed",
            Status::LengthRequired => "411 Length Required",
            Status::TooLarge => "413 Content Too Large",
            Status::HeadTooLarge => "431 Request Header Fields Too Large",
            Status::Internal => "500 Internal Server Error",
            Status::Busy => "503 Service Unavailable",
        }
    }
}

/// Scripts and connections come from this server alone; styles may stand in drawings. The page evaluates nothing, but
/// programs that drive a browser do.
const POLICY: &str = "default-src 'none'; script-src 'self' 'unsafe-eval'; connect-src 'self'; img-src 'self' data: blob:; \
    style-src 'self' 'unsafe-inline'; font-src 'self'; base-uri 'self'; form-action 'none'; frame-ancestors 'none'";
/// A report has its own script and reaches nothing.
const REPORT: &str = "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data:; sandbox allow-scripts";

/// An answer.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Response {
    /// Status of the response.
    pub status: Status,
    /// Media type of the response.
    pub kind: &'static str,
    /// Body of the response.
    pub body: Vec<u8>,
    /// The name under which a browser saves it.
    pub file: Option<String>,
}

impl Response {
    /// Contents of a media type.
    pub fn new(kind: &'static str, body: impl Into<Vec<u8>>) -> Response {
        Response {
            status: Status::Ok,
            kind,
            body: body.into(),
            file: None,
        }
    }

    /// A refusal with nothing but its status.
    pub fn refusal(status: Status) -> Response {
        Response {
            status,
            kind: "text/plain; charset=utf-8",
            body: format!("{}\n", status.line()).into_bytes(),
            file: None,
        }
    }

    /// Data.
    pub fn json(value: &impl serde::Serialize) -> Response {
        // Structs with string keys: this cannot fail.
        let body = serde_json::to_vec(value).unwrap_or_default();
        Response::new("application/json", body)
    }

    /// The same to be saved under a name.
    pub fn saved_as(mut self, name: &str) -> Response {
        self.file = Some(name.to_string());
        self
    }

    /// Writes it; the body is left out where only the head was asked for.
    pub fn write(&self, out: &mut impl Write, closes: bool, with_body: bool) -> io::Result<()> {
        let policy = if self.file.is_some() { REPORT } else { POLICY };
        let mut head = format!(
            "HTTP/1.1 {}\r\nContent-Type: {}\r\nContent-Length: {}\r\nCache-Control: no-store\r\n\
             X-Content-Type-Options: nosniff\r\nReferrer-Policy: no-referrer\r\n\
             Cross-Origin-Resource-Policy: same-origin\r\nContent-Security-Policy: {policy}\r\n",
            self.status.line(),
            self.kind,
            self.body.len()
        );
        if let Some(name) = &self.file {
            let plain: String = name
                .chars()
                .map(|c| {
                    if c.is_ascii_alphanumeric() || "._-".contains(c) {
                        c
                    } else {
                        '_'
                    }
                })
                .collect();
            head.push_str(&format!(
                "Content-Disposition: attachment; filename=\"{plain}\"\r\n"
            ));
        }
        if closes {
            head.push_str("Connection: close\r\n");
        }
        head.push_str("\r\n");
        // One write: a head on its own would wait for the acknowledgement of the one before.
        let mut bytes = head.into_bytes();
        if with_body {
            bytes.extend_from_slice(&self.body);
        }
        out.write_all(&bytes)?;
        out.flush()
    }
}
