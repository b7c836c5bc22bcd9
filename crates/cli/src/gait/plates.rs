//! Grouping of files that contain the force plates of one trial.

use std::io::Read as _;
use std::path::{Path, PathBuf};

use gaitcam::force::{PlateFile, plate_of};
use gaitcam_app::read::open;

/// Number of bytes that are read from the start of a file. The header of the file must be within these bytes.
const HEAD: u64 = 1 << 16;

/// Files grouped by recording, in the given order. All plates of one trial form a group. Each other file forms its own group.
pub fn by_trial(files: Vec<PathBuf>) -> Vec<Vec<PathBuf>> {
    let mut trials: Vec<(Option<Vec<PlateFile>>, Vec<PathBuf>)> = Vec::new();
    let is_alone = files.len() < 2;
    for file in files {
        let plate = if is_alone { None } else { plate(&file) };
        let fits = |plates: &[PlateFile], new: &PlateFile| {
            plates
                .iter()
                .all(|p| p.trial == new.trial && p.plate != new.plate)
        };
        let same = plate.as_ref().and_then(|new| {
            let mut trials = trials.iter_mut();
            trials.find(|(plates, _)| plates.as_ref().is_some_and(|p| fits(p, new)))
        });
        match same {
            Some((plates, paths)) => {
                plates.iter_mut().for_each(|p| p.extend(plate.clone()));
                paths.push(file);
            }
            None => trials.push((plate.map(|p| vec![p]), vec![file])),
        }
    }
    trials.into_iter().map(|(_, paths)| paths).collect()
}

/// Trial and force plate of a file, from its header. `None` if the file does not contain one force plate of a trial, or if it cannot be
/// read. A reading error is reported later.
fn plate(file: &Path) -> Option<PlateFile> {
    let mut head = Vec::new();
    let start = open(file).ok()?.take(HEAD).read_to_end(&mut head);
    start.ok()?;
    plate_of(&head)
}
