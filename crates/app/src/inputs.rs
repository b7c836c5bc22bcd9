//! Protection of inputs: a command does not replace a file that it reads.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use gaitcam::error::{FileError, Placed, Result};

/// Files read so far, with links resolved; `None` in a program that processes several requests.
static READ: Mutex<Option<BTreeSet<PathBuf>>> = Mutex::new(None);

/// Protects every file that is read from now on, in a program that processes a single request.
pub fn protect() {
    with(|read| *read = Some(BTreeSet::new()));
}

fn with<T>(act: impl FnOnce(&mut Option<BTreeSet<PathBuf>>) -> T) -> T {
    act(&mut READ.lock().unwrap_or_else(PoisonError::into_inner))
}

/// Records that a file was read.
pub fn note(path: &Path) {
    with(|read| {
        if let Some(read) = read {
            read.extend(path.canonicalize());
        }
    });
}

/// Rejects the replacement of a file that was read.
///
/// # Errors
///
/// The file was read; the error contains its path.
pub fn check(place: &Path) -> Result<()> {
    with(|read| match read {
        Some(read) => check_among(read, place),
        None => Ok(()),
    })
}

/// Rejects the replacement of one of the given files, whose links are resolved.
///
/// # Errors
///
/// The file is one of them; the error contains its path.
pub fn check_among(inputs: &BTreeSet<PathBuf>, place: &Path) -> Result<()> {
    // Links in the path are resolved only if files were read.
    let replaces = || place.canonicalize().is_ok_and(|p| inputs.contains(&p));
    if inputs.is_empty() || !replaces() {
        return Ok(());
    }
    let file = place.display().to_string();
    // The parent of a plain file name is empty.
    let folder = place.parent().filter(|p| !p.as_os_str().is_empty());
    Err(FileError::Replaced { file }.in_file(folder.unwrap_or(place)))
}

/// Checks the files of a folder before any computation.
///
/// # Errors
///
/// The first file that would be replaced.
pub fn check_in<'a>(folder: &Path, names: impl IntoIterator<Item = &'a str>) -> Result<()> {
    let mut names = names.into_iter();
    names.try_for_each(|name| check(&folder.join(name)))
}
