//! Recordings on the command line: files, and folders that contain files.

use std::path::{Path, PathBuf};

use crate::console::error::CliError;
use gaitcam::error::{Placed, Result};
use gaitcam_app::read::cannot_be_read;
use gaitcam_app::recordings::{ENDINGS, inside};

/// Recordings that are named by the user or found in folders.
#[derive(Default)]
pub struct Recordings {
    /// Paths of the recordings.
    pub files: Vec<String>,
    /// Names of the files in the folders that are not recordings.
    pub skipped: Vec<String>,
}

/// All named files, and the recordings in each named folder, sorted by name within the folder. Hidden files are skipped. `argument` is the
/// name of the argument that contains the paths. The error for paths without a recording contains this name.
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

/// Whether a path is the path of an existing folder.
fn is_folder(path: &Path) -> Result<bool> {
    let about = std::fs::metadata(path).map_err(|e| cannot_be_read(path, &e))?;
    Ok(about.is_dir())
}
