//! Lock files, so that only one process at a time writes to a folder.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{ErrorKind, Read, Result, Write};
use std::path::{Path, PathBuf};
use std::thread::sleep;
use std::time::{Duration, Instant};

use gaitcam::error::{self, FileError, Placed, WriteError};

/// Default maximum waiting time for a lock that another process holds.
pub const PATIENCE: Duration = Duration::from_secs(60);
/// Time between two attempts to create the lock.
const PAUSE: Duration = Duration::from_millis(20);

/// Lock file that contains the number of the process that created it. The file is removed when the lock is released.
pub struct Lock {
    path: PathBuf,
    _file: File,
}

impl Lock {
    /// Creates the lock file `name` in a folder. If another process holds the lock, the function waits for at most `patience`.
    ///
    /// # Errors
    ///
    /// Another process still holds the lock after this time, the path is not a regular file, or the folder is not writable.
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

    /// Tries to create the lock once; `None` if another process holds it.
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

/// Whether a path is a regular file and not a link to one.
pub(crate) fn is_plain(path: &Path) -> bool {
    fs::symlink_metadata(path).is_ok_and(|about| about.is_file())
}

/// Process number in a lock file, as text; `None` if the file contains no number.
fn holder(path: &Path) -> Option<String> {
    let mut text = String::new();
    let file = File::open(path).ok()?;
    file.take(20).read_to_string(&mut text).ok()?;
    text.parse::<u32>().ok().map(|process| process.to_string())
}

/// Whether an open file is still the file at its path. This is not the case if the file was removed or replaced.
#[cfg(unix)]
fn is_still_there(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    match (file.metadata(), fs::symlink_metadata(path)) {
        (Ok(a), Ok(b)) => a.ino() == b.ino() && a.dev() == b.dev(),
        _ => false,
    }
}

/// Whether any file exists at the path. On this system the open file cannot be compared with the file at the path.
#[cfg(not(unix))]
fn is_still_there(_: &File, path: &Path) -> bool {
    path.exists()
}
