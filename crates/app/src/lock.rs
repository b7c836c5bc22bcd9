//! Lock files: only one process writes to a folder at a time.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{ErrorKind, Read, Result, Write};
use std::path::{Path, PathBuf};
use std::thread::sleep;
use std::time::{Duration, Instant};

use gaitcam::error::{self, FileError, Placed, WriteError};

/// Default waiting time for another process that writes.
pub const PATIENCE: Duration = Duration::from_secs(60);
/// Time between two attempts.
const PAUSE: Duration = Duration::from_millis(20);

/// A lock file that contains the number of its process. It is removed when the lock is released.
pub struct Lock {
    path: PathBuf,
    _file: File,
}

impl Lock {
    /// Locks `name` in a folder. If another process holds the lock, waits for at most `patience`.
    ///
    /// # Errors
    ///
    /// Another process still holds the lock after this time; the path is not a plain file; the folder is not writable.
    pub fn wait(folder: &Path, name: &str, patience: Duration) -> error::Result<Lock> {
        let (path, begun) = (folder.join(name), Instant::now());
        loop {
            let lock = Lock::attempt(&path).map_err(|e| match e.kind() {
                ErrorKind::InvalidInput => FileError::Foreign.in_file(&path),
                _ => {
                    let fault = crate::read::fault(&e);
                    WriteError::FolderRefuses { fault }.in_file(folder)
                }
            })?;
            if let Some(lock) = lock {
                return Ok(lock);
            }
            if begun.elapsed() >= patience {
                let process = holder(&path);
                return Err(FileError::Held { process }.in_file(folder));
            }
            sleep(PAUSE);
        }
    }

    /// Tries to create the lock; `None` if another process holds it.
    fn attempt(path: &Path) -> Result<Option<Lock>> {
        loop {
            let mut options = OpenOptions::new();
            let (mut file, is_new) = match options.write(true).create_new(true).open(path) {
                Ok(file) => (file, true),
                Err(e) if e.kind() != ErrorKind::AlreadyExists => return Err(e),
                // A link could point to any file, and opening a pipe could block without end.
                Err(_) if !is_plain(path) => match fs::symlink_metadata(path) {
                    Ok(_) => return Err(ErrorKind::InvalidInput.into()),
                    Err(_) => continue,
                },
                Err(_) => match OpenOptions::new().write(true).open(path) {
                    Ok(file) => (file, false),
                    Err(e) if e.kind() == ErrorKind::NotFound => continue,
                    Err(e) => return Err(e),
                },
            };
            match file.try_lock() {
                Ok(()) => {}
                Err(TryLockError::WouldBlock) => return Ok(None),
                Err(TryLockError::Error(e)) => return Err(e),
            }
            // The last holder may have removed the file between opening and locking.
            if !is_still_there(&file, path) {
                continue;
            }
            if is_new {
                write!(file, "{}", std::process::id())?;
                let path = path.to_path_buf();
                return Ok(Some(Lock { path, _file: file }));
            }
            // The file was left by a killed process, or it may be a hard link to a file of the user. It is removed without writing to it.
            fs::remove_file(path)?;
        }
    }
}

impl Drop for Lock {
    fn drop(&mut self) {
        let _ = fs::remove_file(&self.path);
    }
}

/// Whether a path is a plain file, not a link to one.
pub(crate) fn is_plain(path: &Path) -> bool {
    fs::symlink_metadata(path).is_ok_and(|about| about.is_file())
}

/// Process number written in a lock file.
fn holder(path: &Path) -> Option<String> {
    let mut text = String::new();
    let file = File::open(path).ok()?;
    file.take(20).read_to_string(&mut text).ok()?;
    text.parse::<u32>().ok().map(|process| process.to_string())
}

/// Whether an open file is still the file at its path.
#[cfg(unix)]
fn is_still_there(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    match (file.metadata(), fs::symlink_metadata(path)) {
        (Ok(a), Ok(b)) => a.ino() == b.ino() && a.dev() == b.dev(),
        _ => false,
    }
}

/// Whether a file exists at the path. On this system the path is not compared with the open file.
#[cfg(not(unix))]
fn is_still_there(_: &File, path: &Path) -> bool {
    path.exists()
}
