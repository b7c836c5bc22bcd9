//! Plain HTTP client for a running studio.

use std::fs;
use std::io::{Read, Write};
use std::net::{Shutdown, TcpStream};
use std::path::{Path, PathBuf};
use std::thread;
use std::time::Duration;

use gaitcam_studio::{Options, open};
use serde_json::Value;
use tempfile::TempDir;

/// A running studio with a separate folder.
pub struct Running {
    pub folder: TempDir,
    pub port: u16,
    pub token: String,
}

/// Response of the server.
pub struct Answer {
    pub status: u16,
    pub head: String,
    pub body: Vec<u8>,
}

impl Answer {
    pub fn json(&self) -> Value {
        serde_json::from_slice(&self.body).unwrap()
    }
}

impl Running {
    pub fn new() -> Running {
        let folder = tempfile::tempdir().unwrap();
        let inside = folder.path().join("open");
        fs::create_dir(&inside).unwrap();
        fs::write(folder.path().join("secret.toml"), "name = \"secret\"\n").unwrap();
        let options = Options {
            open: Some(inside),
            ..Options::default()
        };
        let ready = open(&options).unwrap();
        let url = ready.url();
        thread::spawn(move || ready.serve());
        let (before, token) = url.split_once("/?token=").unwrap();
        let port = before.rsplit(':').next().unwrap().parse().unwrap();
        Running {
            folder,
            port,
            token: token.to_string(),
        }
    }

    pub fn inside(&self) -> PathBuf {
        self.folder.path().join("open")
    }

    pub fn host(&self) -> String {
        format!("127.0.0.1:{}", self.port)
    }

    /// Sends bytes unchanged, closes the sending side and reads to the end of the connection.
    pub fn raw(&self, bytes: &[u8]) -> Option<Answer> {
        self.exchange(bytes, true)
    }

    fn exchange(&self, bytes: &[u8], ended: bool) -> Option<Answer> {
        let mut stream = TcpStream::connect(("127.0.0.1", self.port)).ok()?;
        stream
            .set_read_timeout(Some(Duration::from_secs(30)))
            .unwrap();
        let _ = stream.write_all(bytes);
        if ended {
            let _ = stream.shutdown(Shutdown::Write);
        }
        let mut all = Vec::new();
        let _ = stream.read_to_end(&mut all);
        parsed(&all)
    }

    pub fn get(&self, target: &str) -> Answer {
        self.ask("GET", target, &self.host(), "", b"")
    }

    /// Sends a request with the token.
    pub fn post(&self, name: &str, body: &[u8]) -> Answer {
        let target = format!("/{}/{name}", self.token);
        self.ask("POST", &target, &self.host(), "", body)
    }

    pub fn ask(&self, method: &str, target: &str, host: &str, more: &str, body: &[u8]) -> Answer {
        let length = body.len();
        let mut bytes = format!(
            "{method} {target} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\nContent-Length: {length}\r\n{more}\r\n"
        )
        .into_bytes();
        bytes.extend_from_slice(body);
        self.exchange(&bytes, false).unwrap()
    }

    /// All files below the folder with their contents.
    pub fn files(&self) -> Vec<(PathBuf, Vec<u8>)> {
        let mut out = Vec::new();
        collect(self.folder.path(), &mut out);
        out.sort();
        out
    }
}

fn collect(folder: &Path, out: &mut Vec<(PathBuf, Vec<u8>)>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            collect(&path, out);
        } else {
            out.push((path.clone(), fs::read(&path).unwrap()));
        }
    }
}

fn parsed(all: &[u8]) -> Option<Answer> {
    let end = all.windows(4).position(|w| w == b"\r\n\r\n")?;
    let head = String::from_utf8(all[..end].to_vec()).unwrap();
    let status = head.split(' ').nth(1)?.parse().ok()?;
    Some(Answer {
        status,
        head,
        body: all[end + 4..].to_vec(),
    })
}
