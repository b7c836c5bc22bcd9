//! Access control: only pages of this server that have its token.

use crate::http::{Head, Response, Status};

/// Bytes of the token.
const LENGTH: usize = 16;

/// Token and port of a running server.
pub struct Guard {
    token: String,
    port: u16,
}

impl Guard {
    /// A guard with a new token.
    ///
    /// # Errors
    /// Where the system has no random numbers.
    pub fn new(port: u16) -> std::io::Result<Guard> {
        let mut bytes = [0; LENGTH];
        getrandom::fill(&mut bytes).map_err(|e| std::io::Error::other(e.to_string()))?;
        let token = bytes.iter().map(|b| format!("{b:02x}")).collect();
        Ok(Guard { token, port })
    }

    /// The address to open.
    pub fn url(&self) -> String {
        format!("http://127.0.0.1:{}/?token={}", self.port, self.token)
    }

    /// Path prefix with the token.
    pub fn base(&self) -> String {
        format!("/{}/", self.token)
    }

    /// Whether a request may go on: this host, no other origin, the token in its query or as the first part of its
    /// path, and no way upwards.
    pub fn admit(&self, head: &Head) -> Result<(), Response> {
        let own = [
            format!("127.0.0.1:{}", self.port),
            format!("localhost:{}", self.port),
        ];
        let hosted = matches!(&head.hosts[..], [host] if own.contains(host));
        let origin = head.origin.as_deref().map(|o| o.strip_prefix("http://"));
        let own_page = origin.is_none_or(|o| o.is_some_and(|o| own.iter().any(|own| own == o)));
        let upwards = head.path.contains(['\\', '\0'])
            || head.path.split('/').any(|part| part == ".." || part == ".");
        if hosted && own_page && !upwards && self.has_token(head) {
            Ok(())
        } else {
            Err(Response::refusal(Status::Forbidden))
        }
    }

    fn has_token(&self, head: &Head) -> bool {
        let first = head.path.trim_start_matches('/').split('/').next();
        [head.asked("token"), first]
            .into_iter()
            .flatten()
            .any(|given| same(given.as_bytes(), self.token.as_bytes()))
    }

    /// The path without the token.
    pub fn inside<'p>(&self, path: &'p str) -> &'p str {
        let path = path.trim_start_matches('/');
        match path.strip_prefix(self.token.as_str()) {
            Some(rest) => rest.trim_start_matches('/'),
            None => path,
        }
    }
}

/// Comparison in constant time.
fn same(a: &[u8], b: &[u8]) -> bool {
    a.len() == b.len() && a.iter().zip(b).fold(0, |d, (x, y)| d | (x ^ y)) == 0
}
