//! Writing: a file appears whole or not at all.

use std::ffi::OsString;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use gaitcam::error::{Placed, Result, WriteError};
use tempfile::Builder;

/// A folder that is known to take files.
pub struct Folder {
    path: PathBuf,
}

impl Folder {
    /// Creates the folder where needed and proves that it can be written, before any work is done.
    pub fn open(path: &Path) -> Result<Folder> {
        let fault = |e: std::io::Error| {
            WriteError::FolderRefuses {
                fault: e.to_string(),
            }
            .in_file(path)
        };
        fs::create_dir_all(path).map_err(fault)?;
        let probe = path.join(format!(".gaitcam.{}.partial", std::process::id()));
        fs::write(&probe, b"").map_err(fault)?;
        fs::remove_file(&probe).map_err(fault)?;
        Ok(Folder {
            path: path.to_path_buf(),
        })
    }

    /// Writes one file: beside its place first, then renamed into it.
    pub fn write(&self, name: &str, bytes: &[u8]) -> Result<()> {
        write_whole(&self.path.join(name), bytes)
    }

    /// The folder's path.
    pub fn path(&self) -> &Path {
        &self.path
    }
}

/// Writes `bytes` to `path` through a neighbour that is renamed at the end.
///
/// # Errors
/// A file that cannot be written.
pub fn write_whole(path: &Path, bytes: &[u8]) -> Result<()> {
    through_neighbour(path, "", bytes, |_| Ok(()))
}

/// The same through a hidden neighbour that is on the disk before it has its name: for folders that others read
/// meanwhile.
///
/// # Errors
/// A file that cannot be written.
pub fn put_whole(path: &Path, bytes: &[u8]) -> Result<()> {
    through_neighbour(path, ".", bytes, fs::File::sync_all)
}

fn through_neighbour(
    path: &Path,
    prefix: &str,
    bytes: &[u8],
    settle: impl FnOnce(&fs::File) -> std::io::Result<()>,
) -> Result<()> {
    let mut name = OsString::from(prefix);
    name.push(path.file_name().unwrap_or_default());
    name.push(".");
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let written = Builder::new()
        .prefix(&name)
        .suffix(".partial")
        // With the rights that the user's files have, not those of a secret.
        .make_in(folder, |p| fs::File::create_new(p))
        .and_then(|mut beside| {
            beside.as_file_mut().write_all(bytes)?;
            settle(beside.as_file())?;
            beside.persist(path).map_err(|e| e.error)
        });
    written.map(|_| ()).map_err(|e| {
        let fault = e.to_string();
        WriteError::FileRefuses { fault }.in_file(path)
    })
}
