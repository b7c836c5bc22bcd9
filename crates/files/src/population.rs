//! Populations of walkers from folders, lists of files, and tables.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use gaitcam::error::{Place, Result};
use gaitcam::force::{self, ForceCurve, Walker};
use gaitcam::scene::Gait;

use crate::read::{cannot_be_read, find, metadata, read_bytes};

/// Endings of recordings; a folder may also hold other files.
pub const ENDINGS: [&str; 13] = [
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

/// Files of a folder.
#[derive(Debug, Default)]
pub struct Inside {
    /// Those called as recordings are, in the order of their names.
    pub recordings: Vec<PathBuf>,
    /// Names of the others.
    pub others: Vec<String>,
}

/// The files of a folder and of those in it; hidden files are left out without a word. Links to folders are not followed: they
/// may lead back to where they stand.
///
/// # Errors
/// A folder that cannot be read.
pub fn inside(folder: &Path) -> Result<Inside> {
    let mut out = Inside::default();
    collect(folder, &mut out)?;
    Ok(out)
}

fn collect(folder: &Path, out: &mut Inside) -> Result<()> {
    let entries = std::fs::read_dir(folder).and_then(|all| {
        let paths = all.map(|entry| entry.map(|e| e.path()));
        paths.collect::<std::io::Result<Vec<PathBuf>>>()
    });
    let mut entries = entries.map_err(|e| cannot_be_read(folder, &e))?;
    entries.sort();
    for path in entries {
        let name = path.file_name().unwrap_or_default();
        let name = name.to_string_lossy().into_owned();
        if name.starts_with('.') {
            continue;
        }
        if path.is_dir() && !path.is_symlink() {
            collect(&path, out)?;
        } else if !path.is_dir() && is_called_a_recording(&name.to_lowercase()) {
            out.recordings.push(path);
        } else {
            out.others.push(name);
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

/// The mean cycle of the walkers that a scene names, with the walkers; `None` where it names one recording.
///
/// # Errors
/// Every walker who cannot be taken, with the reason; only those that the scene leaves out are.
pub fn population(gait: &Gait, folder: &Path, path: &Path) -> Result<Option<ForceCurve>> {
    let place = find(folder, path);
    let is_folder = place.is_dir();
    if !is_folder && gait.more_files.is_empty() {
        let is_table = place.is_file() && is_text(&place) && is_table(&place, &read_bytes(&place)?);
        if !is_table {
            return Ok(None);
        }
    }
    let mut read = Read::default();
    for path in std::iter::once(path).chain(gait.more_files.iter().map(PathBuf::as_path)) {
        let place = find(folder, path);
        if place.is_dir() {
            for file in inside(&place)?.recordings {
                read.take(gait, &file);
            }
        } else {
            read.take(gait, &place);
        }
    }
    read.mean(gait, place).map(Some)
}

/// The content of a file, and of the table of subjects beside it.
pub struct Content {
    /// Its name.
    pub path: PathBuf,
    /// Its bytes.
    pub bytes: Arc<Vec<u8>>,
    /// The table of subjects.
    pub metadata: Option<Vec<u8>>,
}

/// The same of files that are read already.
///
/// # Errors
/// As [`population`].
pub fn population_of(gait: &Gait, files: &[Content]) -> Result<ForceCurve> {
    let mut read = Read::default();
    let kept = |path: &Path| {
        !leaves_out(gait, &file_name(path)) && !leaves_out(gait, &path.display().to_string())
    };
    for file in files.iter().filter(|f| kept(&f.path)) {
        read.take_content(gait, &file.path, &file.bytes, || file.metadata.clone());
    }
    let first = files.first().map(|f| f.path.clone());
    read.mean(gait, first.unwrap_or_default())
}

/// Whether a file is a table of walkers.
pub fn is_table(path: &Path, bytes: &[u8]) -> bool {
    is_text(path) && force::is_population(bytes)
}

/// Endings of tables; a recording of gigabytes is not read to find out.
fn is_text(path: &Path) -> bool {
    let ending = path
        .extension()
        .unwrap_or_default()
        .to_string_lossy()
        .to_lowercase();
    ["csv", "tsv", "txt"].contains(&ending.as_str())
}

/// Walkers as they were read.
#[derive(Default)]
struct Read {
    walkers: Vec<Walker>,
    /// Files that hold no cycle.
    unreadable: Vec<String>,
}

impl Read {
    /// The cycle of a recording, or every row of a table.
    fn take(&mut self, gait: &Gait, path: &Path) {
        if leaves_out(gait, &file_name(path)) || leaves_out(gait, &path.display().to_string()) {
            return;
        }
        match read_bytes(path) {
            Ok(bytes) => self.take_content(gait, path, &bytes, || metadata(path)),
            Err(_) => self.unreadable.push(file_name(path)),
        }
    }

    fn take_content(
        &mut self,
        gait: &Gait,
        path: &Path,
        bytes: &[u8],
        metadata: impl FnOnce() -> Option<Vec<u8>>,
    ) {
        match cycles(gait, path, bytes, metadata) {
            Ok(walkers) => self.walkers.extend(walkers),
            Err(_) => self.unreadable.push(file_name(path)),
        }
    }

    /// Their mean, with the file at fault where there is one.
    fn mean(self, gait: &Gait, first: PathBuf) -> Result<ForceCurve> {
        let walkers = gait.walkers(self.walkers, &self.unreadable);
        let mean = walkers.and_then(ForceCurve::of_walkers);
        mean.map_err(|e| match e.place {
            Place::File(_) | Place::Line { .. } => e,
            _ => e.at(Place::File(first)),
        })
    }
}

/// The walkers of a file.
fn cycles(
    gait: &Gait,
    path: &Path,
    bytes: &[u8],
    metadata: impl FnOnce() -> Option<Vec<u8>>,
) -> Result<Vec<Walker>> {
    if is_table(path, bytes) {
        return force::read_population(path, bytes);
    }
    let options = gait.read_options(metadata())?;
    let curve = force::force_curve(path, bytes, &options, gait.feet)?;
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    Ok(vec![Walker::new(&name, curve)])
}

fn file_name(path: &Path) -> String {
    path.file_name()
        .unwrap_or_default()
        .to_string_lossy()
        .into_owned()
}

fn leaves_out(gait: &Gait, name: &str) -> bool {
    gait.leave_out.iter().any(|out| out == name)
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    #[test]
    fn links_of_a_folder_to_itself_are_not_followed() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path();
        std::fs::write(path.join("walk.csv"), "").unwrap();
        for name in ["a", "b", "c.csv"] {
            std::os::unix::fs::symlink(path, path.join(name)).unwrap();
        }
        let found = inside(path).unwrap();
        assert_eq!(found.recordings, [path.join("walk.csv")]);
        assert_eq!(found.others, ["a", "b", "c.csv"]);
    }
}
