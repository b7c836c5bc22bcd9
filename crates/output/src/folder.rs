//! Writing: a file appears whole or not at all.

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
pub fn write_whole(path: &Path, bytes: &[u8]) -> Result<()> {
    let fault = |e: std::io::Error| {
        WriteError::FileRefuses {
            fault: e.to_string(),
        }
        .file(path)
    };
    let mut beside = path.as_os_str().to_owned();
    // Processes of several machines may share a folder, and have the same number.
    let random = RandomState::new().build_hasher().finish();
    beside.push(format!(".{}.{random:x}.partial", std::process::id()));
    let beside = PathBuf::from(beside);
    let written = fs::File::create(&beside)
        .and_then(|mut f| f.write_all(bytes))
        .and_then(|()| fs::rename(&beside, path));
    written.map_err(|e| {
        let _ = fs::remove_file(&beside);
        fault(e)
    })
}
