//! Paths of the files with mean cycles.

use std::path::{Path, PathBuf};

use crate::console::error::CliError;
use gaitcam::error::{Placed, Result};
use gaitcam::force::steps_csv;
use gaitcam_app::folder::Folder;
use gaitcam_app::inputs;

/// File name of the joint mean in a folder of cycles.
pub const JOINT_MEAN: &str = "joint_mean.csv";

/// Paths of the cycles of one or several recordings. The picture of a cycle has the same path with the ending `.svg` or `.png`.
#[derive(Debug, Default)]
pub struct Places {
    /// Path of the cycle of each recording. The list is empty if no cycles are written.
    pub each: Vec<PathBuf>,
    /// Path of the joint mean; `None` if it is not written.
    pub joint: Option<PathBuf>,
}

impl Places {
    /// Paths for the value of `--out`. In a folder, the cycles are `NAME_cycle.csv`, one per recording, and the joint mean is
    /// `joint_mean.csv`. If `out` is a file, the joint mean is written to it if `several` is set, otherwise the cycle. `recordings`
    /// contains the files of each recording.
    ///
    /// # Errors
    ///
    /// A path would replace a recording, or the file ending of `out` is neither csv nor mot.
    pub fn of(out: Option<&Path>, recordings: &[Vec<PathBuf>], several: bool) -> Result<Places> {
        let Some(out) = out else {
            return Ok(Places::default());
        };
        let ending = out.extension().unwrap_or_default();
        let csv = ["csv", "mot"]
            .iter()
            .any(|e| ending.eq_ignore_ascii_case(e));
        if !csv && !out.is_dir() && out.extension().is_some() {
            let file = out.display().to_string();
            return Err(CliError::CycleEnding { file }.at_argument("--out"));
        }
        let places = if csv && !out.is_dir() {
            // A missing folder is created, as in `synth`.
            if let Some(folder) = out.parent().filter(|f| !f.as_os_str().is_empty()) {
                Folder::open(folder)?;
            }
            let file = Some(out.to_path_buf());
            let (joint, each) = if several { (file, None) } else { (None, file) };
            Places {
                each: each.into_iter().collect(),
                joint,
            }
        } else {
            let folder = Folder::open(out)?;
            Places {
                each: named(folder.path(), recordings),
                joint: several.then(|| folder.path().join(JOINT_MEAN)),
            }
        };
        let all = places.each.iter().chain(&places.joint);
        for place in all {
            inputs::check(place)?;
            for ending in ["svg", "png"] {
                inputs::check(&place.with_extension(ending))?;
            }
        }
        Ok(places)
    }
}

/// Checks the path of a table of stances.
///
/// # Errors
///
/// The file ending is wrong, or a file of another kind exists at this path.
pub fn check_table(table: &Path) -> Result<()> {
    let file = table.display().to_string();
    let is_csv = (table.extension()).is_some_and(|e| e.eq_ignore_ascii_case("csv"));
    inputs::check(table)?;
    let is_other = |bytes: Vec<u8>| !bytes.starts_with(steps_csv(&[]).as_bytes());
    if !is_csv || std::fs::read(table).is_ok_and(is_other) {
        return Err(CliError::NotStances { file }.at_argument("--stances"));
    }
    Ok(())
}

/// Path `NAME_cycle.csv` for each recording, where NAME is the name of its first file. Recordings with equal names from different folders
/// are numbered.
fn named(folder: &Path, recordings: &[Vec<PathBuf>]) -> Vec<PathBuf> {
    let mut places: Vec<PathBuf> = Vec::new();
    for recording in recordings.iter().filter_map(|files| files.first()) {
        let stem = recording.file_stem().unwrap_or_default().to_string_lossy();
        let numbered = (1..).map(|k| match k {
            1 => format!("{stem}_cycle.csv"),
            k => format!("{stem}_cycle_{k}.csv"),
        });
        let mut free = numbered.map(|name| folder.join(name));
        places.extend(free.find(|p| !places.contains(p)));
    }
    places
}
