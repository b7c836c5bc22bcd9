//! The recordings that a command is given: files, and whatever folders hold.

use std::path::{Path, PathBuf};

use crate::console::error::CliError;
use gaitcam::error::{Placed, Result};
use gaitcam_files::read::cannot_be_read;

/// Endings of recordings; a folder may also hold other files.
const ENDINGS: [&str; 13] = [
    "c3d", "mot", "sto", "forces", "asc", "ascii", "csv", "tsv", "tab", "txt", "dat", "data", "prn",
];
/// Beginnings of the names of texts about a folder, and of the table of subjects.
const ABOUT: [&str; 7] = [
    "readme",
    "license",
    "licence",
    "copying",
    "notice",
    "sources",
    "changelog",
];

/// Recordings given by name or inside folders.
#[derive(Default)]
pub struct Recordings {
    /// Their paths.
    pub files: Vec<String>,
    /// Names of the files in the folders that are none.
    pub skipped: Vec<String>,
}

/// Every file given, and every recording inside a folder given, in the order of names; hidden files are
/// left out without a word.
///
/// `argument`: where the paths were given, for the fault where there is none.
pub fn recordings(paths: &[PathBuf], argument: &str) -> Result<Recordings> {
    let mut out = Recordings::default();
    for path in paths {
        if is_folder(path)? {
            collect(path, &mut out)?;
        } else {
            out.files.push(path.to_string_lossy().into_owned());
        }
    }
    if out.files.is_empty() && !paths.is_empty() {
        let endings = format!(".{}", ENDINGS.join(", ."));
        let fault = match out.skipped.len() {
            0 => CliError::NoRecordings { endings },
            files => CliError::NotRecordings { files, endings },
        };
        return Err(fault.at_argument(argument));
    }
    Ok(out)
}

/// Whether a path that is there leads to a folder.
fn is_folder(path: &Path) -> Result<bool> {
    let about = std::fs::metadata(path).map_err(|e| cannot_be_read(path, &e))?;
    Ok(about.is_dir())
}

fn collect(folder: &Path, out: &mut Recordings) -> Result<()> {
    let mut inside = std::fs::read_dir(folder)
        .and_then(|all| all.map(|entry| entry.map(|e| e.path())).collect())
        .map_err(|e: std::io::Error| cannot_be_read(folder, &e))
        .map(|all: Vec<PathBuf>| all)?;
    inside.sort();
    for path in inside {
        let name = path
            .file_name()
            .map_or_else(String::new, |n| n.to_string_lossy().into());
        if name.starts_with('.') {
            continue;
        }
        if is_folder(&path)? {
            collect(&path, out)?;
        } else if is_called_a_recording(&name.to_lowercase()) {
            out.files.push(path.to_string_lossy().into_owned());
        } else {
            out.skipped.push(name);
        }
    }
    Ok(())
}

fn is_called_a_recording(name: &str) -> bool {
    let Some((stem, ending)) = name.rsplit_once('.') else {
        return false;
    };
    ENDINGS.contains(&ending)
        && !ABOUT.iter().any(|about| stem.starts_with(about))
        && !stem.ends_with("metadata")
}
