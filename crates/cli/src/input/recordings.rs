//! Recordings given to a command: files and folders.

use std::path::{Path, PathBuf};

use crate::console::error::CliError;
use gaitcam::error::{Placed, Result};
use gaitcam_app::read::cannot_be_read;
use gaitcam_app::recordings::{ENDINGS, inside};

/// Recordings given by name or inside folders.
#[derive(Default)]
pub struct Recordings {
    /// Paths of the recordings.
    pub files: Vec<String>,
    /// Names of the other files in the folders.
    pub skipped: Vec<String>,
}

/// Every given file, and every recording inside a given folder, sorted by name. Hidden files are skipped. `argument` names the argument with the
/// paths, for an error if there is no recording.
pub fn recordings(paths: &[PathBuf], argument: &str) -> Result<Recordings> {
    let mut out = Recordings::default();
    for path in paths {
        if is_folder(path)? {
            let found = inside(path)?;
            let names = found
                .recordings
                .iter()
                .map(|p| p.to_string_lossy().into_owned());
            out.files.extend(names);
            out.skipped.extend(found.others);
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

/// Whether a path leads to an existing folder.
fn is_folder(path: &Path) -> Result<bool> {
    let about = std::fs::metadata(path).map_err(|e| cannot_be_read(path, &e))?;
    Ok(about.is_dir())
}
