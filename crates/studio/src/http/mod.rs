//! HTTP/1.1 for a single user on one machine. `httparse` parses the heads; one thread serves each connection. The project has its own server, because
//! limits and time-outs must apply before a body is read. The server does not support chunked bodies, compression or ranges.

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
    /// Body of the request, with the announced length.
    pub body: Vec<u8>,
}

/// Function that returns whether the client has disconnected.
pub type Gone = Arc<dyn Fn() -> bool + Send + Sync>;

/// Handler of a server. It is called first with the head, then with the body.
pub trait Service: Send + Sync + 'static {
    /// Admits the request or returns a rejection.
    fn admit(&self, head: &Head) -> Result<(), Response>;
    /// Maximum size of a body for this address, bytes.
    fn most(&self, head: &Head) -> usize;
    /// Response to a request. `gone` returns whether the client has disconnected and the response is no longer needed.
    fn answer(&self, request: &Request, gone: Gone) -> Response;
}
