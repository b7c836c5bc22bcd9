//! Listening on the loopback address, with a bound on connections.

use std::io;
use std::net::{Ipv4Addr, TcpListener, TcpStream};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::Duration;

use super::{Response, Service, Status, connection};

/// Most connections at a time: a few pages of six each.
const MOST: usize = 96;

/// A listener on the loopback address.
pub struct Server {
    listener: TcpListener,
    port: u16,
}

impl Server {
    /// Listens on a port; 0 takes a free one.
    ///
    /// # Errors
    /// Where the port is taken.
    pub fn listen(port: u16) -> io::Result<Server> {
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port))?;
        let port = listener.local_addr()?.port();
        Ok(Server { listener, port })
    }

    /// The port it listens on.
    pub fn port(&self) -> u16 {
        self.port
    }

    /// Serves for ever.
    pub fn serve(self, service: impl Service) -> ! {
        let service = Arc::new(service);
        let open = Arc::new(AtomicUsize::new(0));
        loop {
            match self.listener.accept() {
                Ok((stream, _)) => take(stream, &service, &open),
                // Out of file handles: wait until some are given back.
                Err(_) => thread::sleep(Duration::from_millis(50)),
            }
        }
    }
}

/// A place among the open connections, given back when it is dropped.
struct Seat(Arc<AtomicUsize>);

impl Drop for Seat {
    fn drop(&mut self) {
        self.0.fetch_sub(1, Ordering::SeqCst);
    }
}

fn take(mut stream: TcpStream, service: &Arc<impl Service>, open: &Arc<AtomicUsize>) {
    let taken = open.fetch_add(1, Ordering::SeqCst);
    let seat = Seat(Arc::clone(open));
    if taken >= MOST {
        let _ = stream.set_write_timeout(Some(Duration::from_millis(50)));
        let _ = Response::refusal(Status::Busy).write(&mut stream, true, true);
        return;
    }
    let service = Arc::clone(service);
    let spawned = thread::Builder::new().spawn(move || {
        connection::serve(stream, service.as_ref());
        drop(seat);
    });
    drop(spawned);
}
