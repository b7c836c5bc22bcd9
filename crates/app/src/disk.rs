//! Access to files on the disk by their file names in a scene.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use gaitcam::error::Result;
use gaitcam::force;
use gaitcam::scene::{self, Files};
use toml::Table;

use crate::read::{read_bytes, read_motion};
use crate::recordings::inside;

/// Access to files on the disk by their file names in a scene. A file is looked up first in the folder of the scene file, then among the
/// built-in files, then in the working directory. A built-in scene has no folder.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Disk {
    /// Folder of the scene file; `None` for a built-in scene.
    pub folder: Option<PathBuf>,
}

impl Disk {
    /// Access to the files of the scene in `file`. The folder of this file is searched first.
    pub fn beside(file: &Path) -> Disk {
        let folder = file.parent().unwrap_or(Path::new("")).to_path_buf();
        Disk {
            folder: Some(folder),
        }
    }

    /// Path of a file in the folder of the scene; `None` if there is no such file.
    fn own(&self, name: &Path) -> Option<PathBuf> {
        let beside = self.folder.as_ref()?.join(name);
        beside.exists().then_some(beside)
    }

    /// Path of the file with this name in a scene; `None` for a built-in file. If the folder of the scene does not contain the file, the
    /// path is relative to the working directory.
    pub fn place(&self, name: &Path) -> Option<PathBuf> {
        match (self.own(name), scene::built_in_file(name)) {
            (Some(place), _) => Some(place),
            (None, Some(_)) => None,
            (None, None) => Some(name.to_path_buf()),
        }
    }

    /// Copy of the table of a scene in which the file name of every motion is replaced by the rows of the file.
    ///
    /// # Errors
    ///
    /// A file cannot be read or contains no motion.
    pub fn with_motions(&self, table: &Table) -> Result<Table> {
        scene::with_motions(table, &mut |file| {
            let path = self.shown(file);
            let bytes = read_motion(&path)?;
            Ok((path, bytes))
        })
    }
}

impl Files for Disk {
    fn has(&self, name: &Path) -> bool {
        self.place(name).is_none_or(|place| place.exists())
    }

    fn read(&self, name: &Path) -> Result<Arc<Vec<u8>>> {
        let bytes = match (self.own(name), scene::built_in_file(name)) {
            (Some(place), _) => read_bytes(&place)?,
            (None, Some(bytes)) => bytes.to_vec(),
            (None, None) => read_bytes(name)?,
        };
        Ok(Arc::new(bytes))
    }

    fn folder(&self, name: &Path) -> Result<Option<Vec<PathBuf>>> {
        let place = self.shown(name);
        if !place.is_dir() {
            return Ok(None);
        }
        let named = |file: &PathBuf| name.join(file.strip_prefix(&place).unwrap_or(file));
        Ok(Some(inside(&place)?.recordings.iter().map(named).collect()))
    }

    fn shown(&self, name: &Path) -> PathBuf {
        self.own(name).unwrap_or_else(|| name.to_path_buf())
    }
}

/// Content of the table of subjects in the folder of a table of stances; `None` without such a table.
pub fn metadata(path: &Path) -> Option<Vec<u8>> {
    read_bytes(&force::metadata_name(path)?).ok()
}
