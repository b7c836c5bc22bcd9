//! HTTP responses, with headers that isolate the page from other pages.

use std::io::{self, Write};

/// Status codes that the server uses.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// Status 200, successful request.
    Ok,
    /// Status 400, invalid request.
    BadRequest,
    /// Status 403, access is forbidden.
    Forbidden,
    /// Status 404, resource was not found.
    NotFound,
    /// Status 405, method is not allowed.
    MethodNotAllowed,
    /// Status 411, length of the body is required.
    LengthRequired,
    /// Status 413, request body too large.
    TooLarge,
    /// Status 431, request head too large.
    HeadTooLarge,
    /// Status 500, internal error of the server.
    Internal,
    /// Status 503, too many requests are in process.
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

/// Content security policy of the page. Scripts and connections are permitted only from this server. Drawings may contain styles. `unsafe-eval` is
/// necessary for programs that control a browser.
const POLICY: &str = "default-src 'none'; script-src 'self' 'unsafe-eval'; connect-src 'self'; img-src 'self' data: blob:; \
    style-src 'self' 'unsafe-inline'; font-src 'self'; base-uri 'self'; form-action 'none'; frame-ancestors 'none'";
/// Content security policy of a report. The report contains its own script and has no access to the network.
const REPORT: &str = "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data:; sandbox allow-scripts";

/// HTTP response to a request.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Response {
    /// Status code of the response.
    pub status: Status,
    /// Media type of the response, such as `application/json`.
    pub kind: &'static str,
    /// Body of the response, as bytes.
    pub body: Vec<u8>,
    /// File name under which the browser saves the body; `None` if the browser shows it.
    pub file: Option<String>,
}

impl Response {
    /// Successful response with a body of the media type `kind`.
    pub fn new(kind: &'static str, body: impl Into<Vec<u8>>) -> Response {
        Response {
            status: Status::Ok,
            kind,
            body: body.into(),
            file: None,
        }
    }

    /// Rejection with a status code and no data.
    pub fn refusal(status: Status) -> Response {
        Response {
            status,
            kind: "text/plain; charset=utf-8",
            body: format!("{}\n", status.line()).into_bytes(),
            file: None,
        }
    }

    /// Successful response with JSON data.
    pub fn json(value: &impl serde::Serialize) -> Response {
        // Serialising structs with string keys cannot fail.
        let body = serde_json::to_vec(value).unwrap_or_default();
        Response::new("application/json", body)
    }

    /// Response that the browser saves under the file name `name`.
    pub fn saved_as(mut self, name: &str) -> Response {
        self.file = Some(name.to_string());
        self
    }

    /// Writes the response to `out`. The body is omitted if `with_body` is false, as for a HEAD request. `closes` states that the server
    /// closes the connection.
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
        // Head and body are sent in one write. If the head were sent separately, the body would wait for its acknowledgement.
        let mut bytes = head.into_bytes();
        if with_body {
            bytes.extend_from_slice(&self.body);
        }
        out.write_all(&bytes)?;
        out.flush()
    }
}
