//! Access control of the server: it accepts only requests from its own pages that contain its token.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use crate::http::{Head, Response, Status};

/// Number of bytes in the token.
const LENGTH: usize = 16;

/// Secret of the user, from which tokens are computed.
type Secret = [u8; 32];

/// Access control with the token and the port of a running server.
pub struct Guard {
    token: String,
    port: u16,
}

/// Token and preferred port for a folder. They are the same at every start, so that an open page can reconnect after a restart. They are
/// computed from the path of the folder and from a secret of the user. Other users therefore cannot guess the token.
pub struct Place {
    /// Secret token, which every request must contain.
    pub token: String,
    /// Preferred port of the folder, in the range for private use.
    pub port: u16,
}

impl Place {
    /// Computes the token and the port for a folder.
    ///
    /// # Errors
    ///
    /// The system provides no random numbers.
    pub fn of(folder: &Path) -> io::Result<Place> {
        let secret = match secret_file() {
            Some(file) => kept_secret(&file).or_else(|_| fresh())?,
            None => fresh()?,
        };
        let sum = hmac_sha256::HMAC::mac(folder.as_os_str().as_encoded_bytes(), secret);
        let token = sum[..LENGTH].iter().map(|b| format!("{b:02x}")).collect();
        let port = 49_152 + u16::from_be_bytes([sum[30], sum[31]]) % 16_384;
        Ok(Place { token, port })
    }
}

/// Path of the file with the secret of the user. It is in the system's folder for application data; `None` without such a folder.
fn secret_file() -> Option<PathBuf> {
    let folder = |name: &str| std::env::var_os(name).filter(|v| !v.is_empty());
    let below = |name: &str, more: &str| folder(name).map(|home| PathBuf::from(home).join(more));
    let state = if cfg!(windows) {
        below("LOCALAPPDATA", "")
    } else if cfg!(target_os = "macos") {
        below("HOME", "Library/Application Support")
    } else {
        below("XDG_STATE_HOME", "").or_else(|| below("HOME", ".local/state"))
    };
    Some(state?.join("gaitcam").join("studio.key"))
}

/// Secret of the user from its file. The file is created at first use, and only the user can read it.
fn kept_secret(file: &Path) -> io::Result<Secret> {
    if let Ok(bytes) = fs::read(file)
        && let Ok(secret) = bytes.try_into()
    {
        return Ok(secret);
    }
    let secret = fresh()?;
    fs::create_dir_all(file.parent().unwrap_or(Path::new(".")))?;
    let mut options = fs::OpenOptions::new();
    options.write(true).create(true).truncate(true);
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::mode(&mut options, 0o600);
    options.open(file)?.write_all(&secret)?;
    Ok(secret)
}

fn fresh() -> io::Result<Secret> {
    let mut secret = Secret::default();
    getrandom::fill(&mut secret).map_err(|e| io::Error::other(e.to_string()))?;
    Ok(secret)
}

impl Guard {
    /// Creates the access control of a server with this port and token.
    pub fn new(port: u16, token: String) -> Guard {
        Guard { token, port }
    }

    /// URL of the page, which contains the token.
    pub fn url(&self) -> String {
        format!("http://127.0.0.1:{}/?token={}", self.port, self.token)
    }

    /// Prefix of paths: the token between two slashes.
    pub fn base(&self) -> String {
        format!("/{}/", self.token)
    }

    /// Accepts or rejects a request. The header `Host` must be the address of this server. The header `Origin`, if present, must be the
    /// same address. The token must be in the query or in the first part of the path. The path must not contain the parts `.` and `..`,
    /// backslashes or zero bytes.
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

    /// Removes the token prefix and leading slashes from a path.
    pub fn inside<'p>(&self, path: &'p str) -> &'p str {
        let path = path.trim_start_matches('/');
        match path.strip_prefix(self.token.as_str()) {
            Some(rest) => rest.trim_start_matches('/'),
            None => path,
        }
    }
}

/// Whether two byte strings are equal. The comparison time does not depend on their contents.
fn same(a: &[u8], b: &[u8]) -> bool {
    a.len() == b.len() && a.iter().zip(b).fold(0, |d, (x, y)| d | (x ^ y)) == 0
}
