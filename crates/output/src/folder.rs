//! Writing: a file appears whole or not at all.

use std::ffi::OsString;
use std::fs;
use std::hash::{BuildHasher, Hasher, RandomState};
use std::io::Write;
use std::path::{Path, PathBuf};

use gaitcam::error::{Result, WriteError};

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
            .file(path)
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
    // Processes of several machines may share a folder, and have the same number.
    let random = RandomState::new().build_hasher().finish();
    let mut name = OsString::from(prefix);
    name.push(path.file_name().unwrap_or_default());
    name.push(format!(".{}.{random:x}.partial", std::process::id()));
    let beside = path.with_file_name(name);
    let written = fs::File::create(&beside)
        .and_then(|mut f| f.write_all(bytes).and_then(|()| settle(&f)))
        .and_then(|()| fs::rename(&beside, path));
    written.map_err(|e| {
        let _ = fs::remove_file(&beside);
        let fault = e.to_string();
        WriteError::FileRefuses { fault }.file(path)
    })
}
