//! A folder that holds one result, replaced as a whole.
//!
//! New files are written into a hidden folder inside. When all are there, that folder is renamed to
//! `READY`: from then on every gaitcam that opens the folder completes the move, so
//! a process that is killed leaves the old result or the new one. A lock keeps a second writer waiting.
//! `summary.json` goes first and comes last, so that whoever sees one sees the files that belong to it.

use std::cell::RefCell;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::path::{Path, PathBuf};

use gaitcam::error::{FileError, Placed, Result, WriteError};

/// New files that wait to be moved into place.
const READY: &str = ".gaitcam.ready";
/// Inside it: names of files of the earlier result, one a line.
const STALE: &str = ".stale";
/// Held by the writer.
const LOCK: &str = ".gaitcam.lock";
/// Present only while the files of the folder belong together.
const SUMMARY: &str = "summary.json";

/// A result folder that is being written.
pub struct ResultFolder {
    path: PathBuf,
    stage: PathBuf,
    written: RefCell<Vec<String>>,
    _lock: Lock,
}

impl ResultFolder {
    /// Creates the folder where needed, waits for other writers, and checks that it can be written, before
    /// any work is done.
    pub fn open(path: &Path) -> Result<ResultFolder> {
        let fault = |e: std::io::Error| {
            let fault = e.to_string();
            WriteError::FolderRefuses { fault }.in_file(path)
        };
        fs::create_dir_all(path).map_err(fault)?;
        let lock = Lock::wait(&path.join(LOCK)).map_err(fault)?;
        complete(path).map_err(fault)?;
        remove_abandoned_stages(path);
        let stage = path.join(format!(".gaitcam.{}.new", std::process::id()));
        fs::create_dir(&stage).map_err(fault)?;
        Ok(ResultFolder {
            path: path.to_path_buf(),
            stage,
            written: RefCell::default(),
            _lock: lock,
        })
    }

    /// The folder's path.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Writes a file of the new result.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn write(&self, name: &str, bytes: &[u8]) -> Result<()> {
        fs::write(self.stage.join(name), bytes).map_err(|e| {
            let fault = e.to_string();
            WriteError::FileRefuses { fault }.in_file(&self.path.join(name))
        })?;
        self.written.borrow_mut().push(name.to_string());
        Ok(())
    }

    /// Puts the new files into place and removes those of `others` that the new result does not have.
    pub fn commit(self, others: &[&str]) -> Result<()> {
        let fault = |e: std::io::Error| {
            let fault = e.to_string();
            FileError::CannotPlace { fault }.in_file(&self.path)
        };
        let written = self.written.borrow();
        let stale: Vec<&str> = others
            .iter()
            .copied()
            .filter(|name| !written.iter().any(|w| w == name))
            .collect();
        fs::write(self.stage.join(STALE), stale.join("\n")).map_err(fault)?;
        fs::rename(&self.stage, self.path.join(READY)).map_err(fault)?;
        complete(&self.path).map_err(fault)
    }
}

impl Drop for ResultFolder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.stage);
    }
}

/// Completes the move that a killed process began, before the folder is read.
pub fn settle(path: &Path) {
    if path.join(READY).exists()
        && let Ok(_lock) = Lock::wait(&path.join(LOCK))
    {
        let _ = complete(path);
    }
}

/// Moves the files of [`READY`] into place; each step may be repeated.
fn complete(path: &Path) -> std::io::Result<()> {
    let ready = path.join(READY);
    if !ready.is_dir() {
        return Ok(());
    }
    let mut names = Vec::new();
    for entry in fs::read_dir(&ready)? {
        names.push(entry?.file_name());
    }
    if names.iter().any(|n| n == SUMMARY) {
        remove_if_there(&path.join(SUMMARY))?;
    }
    for name in names.iter().filter(|n| *n != SUMMARY && *n != STALE) {
        fs::rename(ready.join(name), path.join(name))?;
    }
    let stale = fs::read_to_string(ready.join(STALE)).unwrap_or_default();
    for name in stale.lines() {
        remove_if_there(&path.join(name))?;
    }
    if names.iter().any(|n| n == SUMMARY) {
        fs::rename(ready.join(SUMMARY), path.join(SUMMARY))?;
    }
    fs::remove_dir_all(&ready)
}

fn remove_if_there(path: &Path) -> std::io::Result<()> {
    match fs::remove_file(path) {
        Err(e) if e.kind() != std::io::ErrorKind::NotFound => Err(e),
        _ => Ok(()),
    }
}

/// Removes the hidden folders of processes that were killed; the lock says that none of them still runs.
fn remove_abandoned_stages(path: &Path) {
    for entry in fs::read_dir(path).into_iter().flatten().flatten() {
        let name = entry.file_name();
        let name = name.to_string_lossy();
        if name.starts_with(".gaitcam.") && name.ends_with(".new") {
            let _ = fs::remove_dir_all(entry.path());
        }
    }
}

/// A lock file, removed when the lock is released.
pub struct Lock {
    path: PathBuf,
    _file: File,
}

impl Lock {
    fn open(path: &Path) -> std::io::Result<File> {
        let mut options = OpenOptions::new();
        options.write(true).create(true).truncate(false).open(path)
    }

    /// The lock if the file is still at its path: its last holder may have removed it between opening and locking.
    fn if_still_there(file: File, path: &Path) -> Option<Lock> {
        let path = path.to_path_buf();
        is_still_there(&file, &path).then_some(Lock { path, _file: file })
    }

    fn wait(path: &Path) -> std::io::Result<Lock> {
        loop {
            let file = Lock::open(path)?;
            file.lock()?;
            if let Some(lock) = Lock::if_still_there(file, path) {
                return Ok(lock);
            }
        }
    }

    /// The lock, `None` where another process holds it.
    ///
    /// # Errors
    /// A file that cannot be created or locked.
    pub fn unless_held(path: &Path) -> std::io::Result<Option<Lock>> {
        let file = Lock::open(path)?;
        match file.try_lock() {
            Ok(()) => Ok(Lock::if_still_there(file, path)),
            Err(TryLockError::WouldBlock) => Ok(None),
            Err(TryLockError::Error(e)) => Err(e),
        }
    }
}

impl Drop for Lock {
    fn drop(&mut self) {
        let _ = fs::remove_file(&self.path);
    }
}

/// Whether an open file is still the one at its path.
#[cfg(unix)]
fn is_still_there(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    match (file.metadata(), fs::metadata(path)) {
        (Ok(a), Ok(b)) => a.ino() == b.ino() && a.dev() == b.dev(),
        _ => false,
    }
}

/// Whether an open file is still the one at its path.
#[cfg(not(unix))]
fn is_still_there(_: &File, path: &Path) -> bool {
    path.exists()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(path: &Path) -> Vec<String> {
        let mut all: Vec<String> = fs::read_dir(path)
            .unwrap()
            .map(|e| e.unwrap().file_name().into_string().unwrap())
            .collect();
        all.sort();
        all
    }

    #[test]
    fn an_interrupted_move_is_completed_by_the_next_who_opens_the_folder() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path();
        for (name, text) in [
            ("law.csv", "old"),
            ("cutter.csv", "old"),
            ("summary.json", "old"),
        ] {
            fs::write(path.join(name), text).unwrap();
        }
        let ready = path.join(READY);
        fs::create_dir(&ready).unwrap();
        for (name, text) in [
            ("law.csv", "new"),
            ("summary.json", "new"),
            (STALE, "cutter.csv"),
        ] {
            fs::write(ready.join(name), text).unwrap();
        }
        settle(path);
        assert_eq!(names(path), ["law.csv", "summary.json"]);
        assert_eq!(fs::read_to_string(path.join("law.csv")).unwrap(), "new");
    }

    #[test]
    fn a_result_that_was_not_committed_leaves_nothing() {
        let folder = tempfile::tempdir().unwrap();
        fs::create_dir(folder.path().join(".gaitcam.1.new")).unwrap();
        let result = ResultFolder::open(folder.path()).unwrap();
        result.write("law.csv", b"half").unwrap();
        drop(result);
        assert_eq!(names(folder.path()), Vec::<String>::new());
    }
}
