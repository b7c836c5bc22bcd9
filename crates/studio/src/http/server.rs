//! Server that listens on the loopback address.

use std::io;
use std::net::{Ipv4Addr, TcpListener};
use std::sync::Arc;
use std::thread;
use std::time::Duration;

use super::places::Places;
use super::{Service, connection};

/// Server that listens on the loopback address but does not accept connections yet.
pub struct Server {
    listener: TcpListener,
    port: u16,
}

impl Server {
    /// Listens on a port of the loopback address. Port 0 selects a free port.
    ///
    /// # Errors
    ///
    /// The port is in use.
    pub fn listen(port: u16) -> io::Result<Server> {
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port))?;
        let port = listener.local_addr()?.port();
        Ok(Server { listener, port })
    }

    /// Port on which the server listens.
    pub fn port(&self) -> u16 {
        self.port
    }

    /// Accepts connections until the program ends. Each connection has its own thread.
    pub fn serve(self, service: impl Service) -> ! {
        let shared = Arc::new((service, Places::default()));
        loop {
            let spawned = self.listener.accept().and_then(|(stream, _)| {
                let shared = Arc::clone(&shared);
                let serve = move || connection::serve(stream, &shared.0, &shared.1);
                thread::Builder::new().spawn(serve)
            });
            // No file handle or thread is available. The server waits until others are released.
            if spawned.is_err() {
                thread::sleep(Duration::from_millis(50));
            }
        }
    }
}
