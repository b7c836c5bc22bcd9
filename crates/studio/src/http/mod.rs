//! HTTP/1.1 for one person on one machine: `httparse` reads the heads, one thread serves a connection.
//!
//! A server of its own because limits and time-outs must hold before a body is read: the ready-made small servers have
//! neither. No chunked bodies, no compression, no ranges.

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
    /// Method, address and headers.
    pub head: Head,
    /// The body, as long as its head said.
    pub body: Vec<u8>,
}

/// Whether the side that asked has left.
pub type Gone = Arc<dyn Fn() -> bool + Send + Sync>;

/// What a server asks: first about the head alone, then with the body.
pub trait Service: Send + Sync + 'static {
    /// Whether the request may go on; otherwise the refusal.
    fn admit(&self, head: &Head) -> Result<(), Response>;
    /// The largest body for this address, bytes.
    fn most(&self, head: &Head) -> usize;
    /// The answer.
    ///
    /// `gone` says whether the other side has left meanwhile: the answer is of no use then.
    fn answer(&self, request: &Request, gone: Gone) -> Response;
}
