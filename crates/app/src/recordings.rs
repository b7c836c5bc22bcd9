//! Search for recordings in a folder.

use std::path::{Path, PathBuf};

use gaitcam::error::Result;

use crate::read::cannot_be_read;

/// Extensions of recordings. Files with other extensions are ignored in folders.
pub const ENDINGS: [&str; 13] = [
    "c3d", "mot", "sto", "forces", "asc", "ascii", "csv", "tsv", "tab", "txt", "dat", "data", "prn",
];
/// First words of the names of text files that describe a folder and are not recordings.
const ABOUT: [&str; 7] = [
    "readme",
    "license",
    "licence",
    "copying",
    "notice",
    "sources",
    "changelog",
];

/// Files in a folder and in its subfolders.
#[derive(Debug, Default)]
pub struct Inside {
    /// Recordings, recognised by their extensions, in alphabetical order.
    pub recordings: Vec<PathBuf>,
    /// Names of the files that are not recordings.
    pub others: Vec<String>,
}

/// Lists the files of a folder and of its subfolders. Hidden files are skipped. Links to folders are not followed, because they may form a loop.
///
/// # Errors
///
/// A folder cannot be read.
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
