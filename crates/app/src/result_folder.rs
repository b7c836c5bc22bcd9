//! Result folder in which all files are replaced together.
//!
//! New files are first written to a hidden folder inside the result folder. When all new files are complete, the hidden folder is renamed
//! to `READY`. Then its files are moved into the result folder. If this move was interrupted, the next gaitcam process that opens the
//! result folder completes it. A process that is killed therefore leaves either the old result or the new one. A lock file makes a second
//! process wait.
//!
//! `summary.json` is removed first and written last, so that it always belongs to the other files.
//!
//! The folder may come from an untrusted source. Therefore file names are never taken from the folder. Only regular files with names that gaitcam
//! writes are moved or removed.

use std::cell::RefCell;
use std::collections::BTreeSet;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::time::Duration;

use gaitcam::error::{FileError, Placed, Result, WriteError};

use crate::earlier::{is_last, own};
use crate::inputs;
use crate::lock::{Lock, is_plain};
use crate::read::read_bytes;

/// Name of the hidden folder that contains the complete new files until they are moved into the result folder.
const READY: &str = ".gaitcam.ready";
/// Name of a file in the hidden folder. It lists the files of the earlier result that must be removed, one per line.
const STALE: &str = ".stale";
/// Name of the lock file of the process that writes to the folder.
const LOCK: &str = ".gaitcam.lock";

/// Result folder that is open for writing.
pub struct ResultFolder {
    path: PathBuf,
    stage: PathBuf,
    written: RefCell<Vec<String>>,
    _lock: Lock,
}

impl ResultFolder {
    /// Opens a result folder for writing, before any computation. Creates the folder if necessary and waits for at most `patience` while
    /// another process writes to it. Checks that the folder is writable.
    ///
    /// # Errors
    ///
    /// The folder is not writable, or another process still holds the lock.
    pub fn open(path: &Path, patience: Duration) -> Result<ResultFolder> {
        let fault = |e: io::Error| {
            let fault = crate::read::fault(&e);
            WriteError::FolderRefuses { fault }.in_file(path)
        };
        fs::create_dir_all(path).map_err(fault)?;
        let lock = Lock::wait(path, LOCK, patience)?;
        complete(path)?;
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

    /// Path of the result folder.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Writes a file of the new result to the hidden folder. `name` must be the name of a result file.
    ///
    /// # Errors
    ///
    /// The file cannot be written, or its path is a folder.
    pub fn write(&self, name: &str, bytes: &[u8]) -> Result<()> {
        assert!(own().any(|own| own == name), "{name} would stay for ever");
        inputs::check(&self.path.join(name))?;
        check_place(&self.path, name)?;
        let place = self.stage.join(name);
        let parent = place.parent().map_or(Ok(()), fs::create_dir_all);
        parent
            .and_then(|()| fs::write(&place, bytes))
            .map_err(|e| {
                let fault = crate::read::fault(&e);
                WriteError::FileRefuses { fault }.in_file(&self.path.join(name))
            })?;
        self.written.borrow_mut().push(name.to_string());
        Ok(())
    }

    /// Moves the new files into the result folder, and removes the files in `others` that are not part of the new result.
    ///
    /// # Errors
    ///
    /// A file cannot be moved.
    pub fn commit(self, others: &[&str]) -> Result<()> {
        let written = self.written.borrow();
        let stale: Vec<&str> = others
            .iter()
            .copied()
            .filter(|name| !written.iter().any(|w| w == name))
            .collect();
        fs::write(self.stage.join(STALE), stale.join("\n"))
            .and_then(|()| fs::rename(&self.stage, self.path.join(READY)))
            .map_err(|e| cannot_place(&self.path, &e))?;
        complete(&self.path)
    }
}

impl Drop for ResultFolder {
    fn drop(&mut self) {
        let _ = discard(&self.stage);
    }
}

/// Content of a file of the result. If a killed process left the new file in the hidden folder, the new file is read. The folder is not
/// changed.
///
/// # Errors
///
/// The file cannot be read.
pub fn read(folder: &Path, name: &str) -> Result<Vec<u8>> {
    let ready = folder.join(READY);
    let new = ready.join(name);
    if is_folder(&ready)
        && is_plain(&new)
        && let Ok(bytes) = read_bytes(&new)
    {
        return Ok(bytes);
    }
    read_bytes(&folder.join(name))
}

/// Moves the files of [`READY`] into the result folder. If the function is interrupted, it can be repeated.
fn complete(path: &Path) -> Result<()> {
    let ready = path.join(READY);
    if !is_folder(&ready) {
        return Ok(());
    }
    let foreign = || FileError::Foreign.in_file(&ready);
    let mut inside = names_in(&ready).map_err(|_| foreign())?;
    inside.retain(|name| !is_emptied(&ready, name));
    let is_new = |own: &&str| inside.iter().any(|name| name == own) && is_plain(&ready.join(own));
    let new: Vec<&str> = own().filter(is_new).collect();
    if inside.len() > new.len() + usize::from(is_plain(&ready.join(STALE))) {
        return Err(foreign());
    }
    for name in &new {
        check_place(path, name)?;
    }
    put(path, &ready, &new).map_err(|e| cannot_place(path, &e))?;
    discard(&ready).map_err(|_| foreign())
}

fn put(path: &Path, ready: &Path, new: &[&str]) -> io::Result<()> {
    let listed = ready.join(STALE);
    let listed = match is_plain(&listed) {
        true => fs::read_to_string(listed).unwrap_or_default(),
        false => String::new(),
    };
    let listed: BTreeSet<&str> = listed.lines().collect();
    let (last, first): (Vec<&str>, Vec<&str>) = new.iter().partition(|name| is_last(name));
    for name in &last {
        remove_plain(&path.join(name))?;
    }
    for name in first {
        let place = path.join(name);
        place.parent().map_or(Ok(()), fs::create_dir_all)?;
        fs::rename(ready.join(name), place)?;
        remove_empty_parent(ready, name);
    }
    for name in own().filter(|own| listed.contains(own)) {
        if !new.contains(&name) && is_inside(path, name) {
            remove_plain(&path.join(name))?;
            remove_empty_parent(path, name);
        }
    }
    for name in last {
        fs::rename(ready.join(name), path.join(name))?;
    }
    Ok(())
}

/// Checks that a result file can be written to its path. The path must not be a folder. The parent of the file must be a real folder (not a
/// link) or must not exist yet.
fn check_place(path: &Path, name: &str) -> Result<()> {
    match is_folder(&path.join(name)) || !is_inside(path, name) {
        true => Err(FileError::Foreign.in_file(&path.join(name))),
        false => Ok(()),
    }
}

/// Whether a file name leads to the result folder or to a real subfolder. A link is not accepted. The subfolder may be missing.
fn is_inside(path: &Path, name: &str) -> bool {
    let parent = Path::new(name)
        .parent()
        .filter(|p| !p.as_os_str().is_empty());
    parent.is_none_or(|parent| {
        let parent = path.join(parent);
        is_folder(&parent) || fs::symlink_metadata(&parent).is_err()
    })
}

/// Removes the subfolder of a result file if it is empty.
fn remove_empty_parent(path: &Path, name: &str) {
    if name.contains('/')
        && let Some(parent) = path.join(name).parent()
    {
        let _ = fs::remove_dir(parent);
    }
}

/// Whether `name` is an empty subfolder for result files. [`names_in`] lists a subfolder only if it is empty. A subfolder is empty after
/// all its files have been moved.
fn is_emptied(path: &Path, name: &str) -> bool {
    let is_parent = |own: &str| Path::new(own).parent() == Some(Path::new(name));
    is_folder(&path.join(name)) && own().any(is_parent)
}

/// Relative names of the files in a folder and its subfolders, and of empty subfolders.
fn names_in(folder: &Path) -> io::Result<Vec<String>> {
    let mut out = Vec::new();
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let name = entry.file_name().to_string_lossy().into_owned();
        let inside = match is_folder(&entry.path()) {
            true => names_in(&entry.path())?,
            false => Vec::new(),
        };
        match inside[..] {
            [] => out.push(name),
            _ => out.extend(inside.iter().map(|file| format!("{name}/{file}"))),
        }
    }
    Ok(out)
}

fn cannot_place(path: &Path, e: &io::Error) -> gaitcam::error::Error {
    let fault = e.to_string();
    FileError::CannotPlace { fault }.in_file(path)
}

/// Whether a path is a folder and not a link to one.
fn is_folder(path: &Path) -> bool {
    fs::symlink_metadata(path).is_ok_and(|about| about.is_dir())
}

fn remove_plain(path: &Path) -> io::Result<()> {
    match is_plain(path) {
        true => fs::remove_file(path),
        false => Ok(()),
    }
}

/// Removes a hidden folder and those files in it that gaitcam writes. If the folder contains other files, they and the folder remain.
fn discard(folder: &Path) -> io::Result<()> {
    for name in names_in(folder)? {
        if is_emptied(folder, &name) {
            fs::remove_dir(folder.join(&name))?;
        } else if own().chain([STALE]).any(|own| own == name) {
            remove_plain(&folder.join(&name))?;
            remove_empty_parent(folder, &name);
        }
    }
    fs::remove_dir(folder)
}

/// Removes the hidden folders of processes that were killed. The lock ensures that these processes are no longer running.
fn remove_abandoned_stages(path: &Path) {
    for entry in fs::read_dir(path).into_iter().flatten().flatten() {
        let name = entry.file_name();
        let name = name.to_string_lossy();
        let process = name
            .strip_prefix(".gaitcam.")
            .and_then(|n| n.strip_suffix(".new"));
        let is_stage = process.is_some_and(|p| p.bytes().all(|b| b.is_ascii_digit()));
        if is_stage && is_folder(&entry.path()) {
            let _ = discard(&entry.path());
        }
    }
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
            ("profile.csv", "of another command"),
            ("summary.json", "old"),
        ] {
            fs::write(path.join(name), text).unwrap();
        }
        let ready = path.join(READY);
        fs::create_dir(&ready).unwrap();
        fs::create_dir(ready.join("cams_1")).unwrap();
        for (name, text) in [
            ("law.csv", "new"),
            ("summary.json", "new"),
            (STALE, "cutter.csv"),
        ] {
            fs::write(ready.join(name), text).unwrap();
        }
        drop(ResultFolder::open(path, Duration::ZERO).unwrap());
        assert_eq!(names(path), ["law.csv", "profile.csv", "summary.json"]);
        assert_eq!(fs::read_to_string(path.join("law.csv")).unwrap(), "new");
    }

    #[test]
    fn new_files_among_foreign_ones_are_refused_before_anything_is_moved() {
        type Put = fn(&Path);
        let foreign: [Put; 4] = [
            |at| fs::write(at.join("notes.txt"), "own").unwrap(),
            |at| fs::create_dir(at.join("profile.csv")).unwrap(),
            |at| fs::create_dir(at.join(STALE)).unwrap(),
            |at| fs::write(at.join("law.csv.old"), "own").unwrap(),
        ];
        for put in foreign {
            let folder = tempfile::tempdir().unwrap();
            let path = folder.path();
            let ready = path.join(READY);
            fs::create_dir(&ready).unwrap();
            put(&ready);
            fs::write(path.join("law.csv"), "old").unwrap();
            fs::write(ready.join("cam.svg"), "new").unwrap();
            if !ready.join(STALE).exists() {
                fs::write(ready.join(STALE), "law.csv").unwrap();
            }
            let before = (names(path), names(&ready));
            assert!(ResultFolder::open(path, Duration::ZERO).is_err());
            assert_eq!((names(path), names(&ready)), before);
        }
    }

    #[test]
    fn a_move_that_fails_leaves_no_summary_beside_old_files() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path();
        let ready = path.join(READY);
        fs::create_dir(&ready).unwrap();
        for name in ["law.csv", "summary.json"] {
            fs::write(path.join(name), "old").unwrap();
        }
        fs::write(ready.join("summary.json"), "new").unwrap();
        assert!(put(path, &ready, &["summary.json", "law.csv"]).is_err());
        assert_eq!(names(path), [READY, "law.csv"]);
    }

    #[test]
    fn a_cover_replaces_the_one_before_as_a_whole() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path();
        for name in [
            "cams_2/cam_1.toml",
            "cams_3/cam_2.toml",
            "cover.csv",
            "cams_2/notes.txt",
        ] {
            fs::create_dir_all(path.join(name).parent().unwrap()).unwrap();
            fs::write(path.join(name), "old").unwrap();
        }
        let result = ResultFolder::open(path, Duration::ZERO).unwrap();
        result.write("cams_1/cam_1.toml", b"new").unwrap();
        result.write("cover.csv", b"new").unwrap();
        let others: Vec<&str> = crate::design::of_cover().collect();
        result.commit(&others).unwrap();
        assert_eq!(names(path), ["cams_1", "cams_2", "cover.csv"]);
        assert_eq!(names(&path.join("cams_2")), ["notes.txt"]);
        assert_eq!(
            fs::read_to_string(path.join("cams_1/cam_1.toml")).unwrap(),
            "new"
        );
    }

    #[cfg(unix)]
    #[test]
    fn nothing_is_written_through_a_link_to_a_folder() {
        let (folder, foreign) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
        fs::write(foreign.path().join("cam_1.toml"), "foreign").unwrap();
        std::os::unix::fs::symlink(foreign.path(), folder.path().join("cams_1")).unwrap();
        let result = ResultFolder::open(folder.path(), Duration::ZERO).unwrap();
        assert!(result.write("cams_1/cam_1.toml", b"new").is_err());
        result.write("cover.csv", b"new").unwrap();
        result.commit(&["cams_1/cam_1.toml"]).unwrap();
        assert_eq!(
            fs::read_to_string(foreign.path().join("cam_1.toml")).unwrap(),
            "foreign"
        );
    }

    #[test]
    fn a_result_that_was_not_committed_leaves_nothing() {
        let folder = tempfile::tempdir().unwrap();
        fs::create_dir(folder.path().join(".gaitcam.1.new")).unwrap();
        let result = ResultFolder::open(folder.path(), Duration::ZERO).unwrap();
        result.write("law.csv", b"half").unwrap();
        drop(result);
        assert_eq!(names(folder.path()), Vec::<String>::new());
    }

    #[cfg(unix)]
    #[test]
    fn a_link_in_the_place_of_new_files_is_not_followed() {
        let (folder, foreign) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
        fs::write(folder.path().join("law.csv"), "own").unwrap();
        fs::write(foreign.path().join("law.csv"), "foreign").unwrap();
        std::os::unix::fs::symlink(foreign.path(), folder.path().join(READY)).unwrap();
        assert_eq!(read(folder.path(), "law.csv").unwrap(), b"own");
    }
}
