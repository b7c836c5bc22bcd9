//! Writing: a file appears whole or not at all.

use std::cell::RefCell;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use gaitcam::error::{Error, Result};

/// A folder that is known to take files.
pub struct Folder {
    path: PathBuf,
    written: RefCell<Vec<String>>,
}

impl Folder {
    /// Creates the folder where needed and proves that it can be written, before any work is done.
    pub fn open(path: &Path) -> Result<Folder> {
        let fault = |e: std::io::Error| {
            Error::file(path, format!("cannot write into this folder ({e})"))
                .help("choose another with --out DIR")
        };
        fs::create_dir_all(path).map_err(fault)?;
        let probe = path.join(format!(".gaitcam.{}.partial", std::process::id()));
        fs::write(&probe, b"").map_err(fault)?;
        fs::remove_file(&probe).map_err(fault)?;
        Ok(Folder {
            path: path.to_path_buf(),
            written: RefCell::default(),
        })
    }

    /// Writes one file: beside its place first, then renamed into it.
    pub fn write(&self, name: &str, bytes: &[u8]) -> Result<()> {
        write_whole(&self.path.join(name), bytes)?;
        self.written.borrow_mut().push(name.to_string());
        Ok(())
    }

    /// Removes the files of these `names` that were not written since the folder was opened: they belong
    /// to another design. To be called when everything new is in place.
    pub fn remove_others(&self, names: &[&str]) {
        let written = self.written.borrow();
        for name in names {
            if !written.iter().any(|w| w == name) {
                // What is not there, or cannot be removed, is no fault of this result.
                let _ = fs::remove_file(self.path.join(name));
            }
        }
    }

    /// Removes the half-written neighbours of these `names` that runs which are no more left behind.
    pub fn remove_partials(&self, names: &[&str]) {
        let Ok(entries) = fs::read_dir(&self.path) else {
            return;
        };
        for entry in entries.flatten() {
            let file = entry.file_name();
            let Some((name, process)) = file.to_str().and_then(partial) else {
                continue;
            };
            if names.contains(&name) && is_gone(process) {
                let _ = fs::remove_file(entry.path());
            }
        }
    }

    /// The folder's path.
    pub fn path(&self) -> &Path {
        &self.path
    }
}

/// The name and the process of a half-written file: `law.csv.4711.partial`.
fn partial(file: &str) -> Option<(&str, u32)> {
    let (name, process) = file.strip_suffix(".partial")?.rsplit_once('.')?;
    Some((name, process.parse().ok()?))
}

/// Whether a process has ended; where the system does not show its processes, none is taken to have.
fn is_gone(process: u32) -> bool {
    let all = Path::new("/proc");
    all.join("self").exists() && !all.join(process.to_string()).exists()
}

/// Writes `bytes` to `path` through a neighbour that is renamed at the end.
pub fn write_whole(path: &Path, bytes: &[u8]) -> Result<()> {
    let fault = |e: std::io::Error| Error::file(path, format!("cannot be written ({e})"));
    let mut beside = path.as_os_str().to_owned();
    beside.push(format!(".{}.partial", std::process::id()));
    let beside = PathBuf::from(beside);
    let written = fs::File::create(&beside)
        .and_then(|mut f| f.write_all(bytes))
        .and_then(|()| fs::rename(&beside, path));
    written.map_err(|e| {
        let _ = fs::remove_file(&beside);
        fault(e)
    })
}
