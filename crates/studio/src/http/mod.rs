//! HTTP/1.1 server for a single user on one machine.
//!
//! `httparse` parses the heads, and one thread serves each connection. Limits of size and time must apply before a body is read, so the
//! project has its own server. The server does not support chunked bodies, compression or ranges.

mod connection;
mod head;
mod places;
mod response;
mod server;

use std::sync::Arc;

pub use head::{Head, Method};
pub use response::{Response, Status};
pub use server::Server;

/// A request with its body.
#[derive(Debug)]
pub struct Request {
    /// Head of the request: method, address and headers.
    pub head: Head,
    /// Body of the request, bytes.
    pub body: Vec<u8>,
}

/// Function that returns whether the client has disconnected.
pub type Gone = Arc<dyn Fn() -> bool + Send + Sync>;

/// Handler of the requests of a server. The server calls it first with the head, then with the whole request.
pub trait Service: Send + Sync + 'static {
    /// Accepts the request, or returns a rejection.
    fn admit(&self, head: &Head) -> Result<(), Response>;
    /// Maximum size of the body for this address, bytes.
    fn most(&self, head: &Head) -> usize;
    /// Response to an accepted request. `gone` returns whether the client has disconnected, so that the response is no longer needed.
    fn answer(&self, request: &Request, gone: Gone) -> Response;
}
