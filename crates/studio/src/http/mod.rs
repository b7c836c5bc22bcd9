//! HTTP/1.1 for one user on one machine: `httparse` parses the heads, one thread serves each connection. The server is our own because limits and
//! time-outs must apply before a body is read. It has no chunked bodies, compression or ranges.

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
    /// Body of the request, of the announced length.
    pub body: Vec<u8>,
}

/// Whether the client has disconnected.
pub type Gone = Arc<dyn Fn() -> bool + Send + Sync>;

/// Handler of a server: called first with the head alone, then with the body.
pub trait Service: Send + Sync + 'static {
    /// Admits the request or returns a rejection.
    fn admit(&self, head: &Head) -> Result<(), Response>;
    /// The maximum size of a body for this address, bytes.
    fn most(&self, head: &Head) -> usize;
    /// The answer. `gone` says whether the client has disconnected meanwhile, so that the answer is not needed.
    fn answer(&self, request: &Request, gone: Gone) -> Response;
}
