//! Protection of inputs: a command must not replace a file that it reads.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use gaitcam::error::{FileError, Placed, Result};

/// Paths of the files read so far, with links resolved. `None` disables the protection, because the program processes several requests.
static READ: Mutex<Option<BTreeSet<PathBuf>>> = Mutex::new(None);

/// Starts the protection of all files that are read from now on. Only a program that processes a single request calls this function.
pub fn protect() {
    with(|read| *read = Some(BTreeSet::new()));
}

fn with<T>(act: impl FnOnce(&mut Option<BTreeSet<PathBuf>>) -> T) -> T {
    act(&mut READ.lock().unwrap_or_else(PoisonError::into_inner))
}

/// Registers a file as read.
pub fn note(path: &Path) {
    with(|read| {
        if let Some(read) = read {
            read.extend(path.canonicalize());
        }
    });
}

/// Checks that a file to be written has not been read.
///
/// # Errors
///
/// The file was read. The error contains its path.
pub fn check(place: &Path) -> Result<()> {
    with(|read| match read {
        Some(read) => check_among(read, place),
        None => Ok(()),
    })
}

/// Checks that a file to be written is not one of the given inputs. The paths of the inputs must have resolved links.
///
/// # Errors
///
/// The file is one of the inputs. The error contains its path.
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

/// Checks that no file to be written to a folder has been read. The check precedes the computation.
///
/// # Errors
///
/// A file was read and would be replaced. The error contains the path of the first such file.
pub fn check_in<'a>(folder: &Path, names: impl IntoIterator<Item = &'a str>) -> Result<()> {
    let mut names = names.into_iter();
    names.try_for_each(|name| check(&folder.join(name)))
}
