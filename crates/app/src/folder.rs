//! Atomic writing of files, so that a file is either complete or absent.

use std::ffi::OsString;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use gaitcam::error::{Placed, Result, WriteError};
use tempfile::{Builder, NamedTempFile};

use crate::inputs;
use gaitcam_output::Picture;

/// Folder to which files are written atomically.
pub struct Folder {
    path: PathBuf,
}

impl Folder {
    /// Creates the folder if necessary. Checks that it is writable, so that errors occur before a long computation.
    pub fn open(path: &Path) -> Result<Folder> {
        let fault = |e: std::io::Error| {
            WriteError::FolderRefuses {
                fault: crate::read::fault(&e),
            }
            .in_file(path)
        };
        fs::create_dir_all(path).map_err(fault)?;
        drop(temporary(&path.join(".gaitcam"), "", b"").map_err(fault)?);
        Ok(Folder {
            path: path.to_path_buf(),
        })
    }

    /// Writes one file atomically: the file is written under a temporary name and then renamed.
    pub fn write(&self, name: &str, bytes: &[u8]) -> Result<()> {
        write_whole(&self.path.join(name), bytes)
    }

    /// Writes a figure as `name.svg` and `name.png`.
    pub fn write_picture(&self, name: &str, picture: &Picture) -> Result<()> {
        self.write(&format!("{name}.svg"), picture.svg().as_bytes())?;
        self.write(&format!("{name}.png"), &picture.png())
    }

    /// Path of the folder to which files are written.
    pub fn path(&self) -> &Path {
        &self.path
    }
}

/// Writes `bytes` to a temporary file in the same folder and renames it to `path`.
///
/// # Errors
///
/// The file cannot be written.
pub fn write_whole(path: &Path, bytes: &[u8]) -> Result<()> {
    through_temporary(path, "", bytes, |_| Ok(()))
}

/// Writes `bytes` as [`write_whole`] does, but with a hidden temporary file that is synced to the disk before it is renamed. This is
/// necessary in folders that other processes read at the same time.
///
/// # Errors
///
/// The file cannot be written.
pub fn put_whole(path: &Path, bytes: &[u8]) -> Result<()> {
    through_temporary(path, ".", bytes, fs::File::sync_all)
}

/// Writes a new file atomically. An existing file is not replaced.
///
/// # Errors
///
/// The file already exists ([`AlreadyExists`](std::io::ErrorKind::AlreadyExists)) or cannot be written.
pub fn write_new(path: &Path, bytes: &[u8]) -> std::io::Result<()> {
    let temporary = temporary(path, ".", bytes)?;
    temporary.persist_noclobber(path).map_err(|e| e.error)?;
    Ok(())
}

fn through_temporary(
    path: &Path,
    prefix: &str,
    bytes: &[u8],
    sync: impl FnOnce(&fs::File) -> std::io::Result<()>,
) -> Result<()> {
    inputs::check(path)?;
    let written = temporary(path, prefix, bytes).and_then(|temporary| {
        sync(temporary.as_file())?;
        temporary.persist(path).map_err(|e| e.error)
    });
    written.map(|_| ()).map_err(|e| {
        let fault = crate::read::fault(&e);
        WriteError::FileRefuses { fault }.in_file(path)
    })
}

/// Creates a temporary file with a unique name in the folder of `path`. The file is removed when the value is dropped.
fn temporary(path: &Path, prefix: &str, bytes: &[u8]) -> std::io::Result<NamedTempFile> {
    let mut name = OsString::from(prefix);
    name.push(path.file_name().unwrap_or_default());
    name.push(".");
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let mut temporary = Builder::new()
        .prefix(&name)
        .suffix(".partial")
        // The file has the usual access rights of new files. The default access rights of temporary files are more restrictive.
        .make_in(folder, |p| fs::File::create_new(p))?;
    temporary.as_file_mut().write_all(bytes)?;
    Ok(temporary)
}
