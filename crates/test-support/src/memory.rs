//! Files in memory, for tests without a disk.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use gaitcam::error::{Placed, Result, SweepError};
use gaitcam::scene::Files;

/// Files in memory, by their names in a scene.
#[derive(Debug, Default)]
pub struct Memory(BTreeMap<PathBuf, Arc<Vec<u8>>>);

impl<const N: usize> From<[(&str, Vec<u8>); N]> for Memory {
    fn from(files: [(&str, Vec<u8>); N]) -> Memory {
        let named = files.map(|(name, bytes)| (PathBuf::from(name), Arc::new(bytes)));
        Memory(BTreeMap::from(named))
    }
}

impl Files for Memory {
    fn has(&self, name: &Path) -> bool {
        self.0.contains_key(name)
    }

    fn read(&self, name: &Path) -> Result<Arc<Vec<u8>>> {
        let missing = || SweepError::NotCarried.in_file(name);
        self.0.get(name).cloned().ok_or_else(missing)
    }

    fn names(&self) -> Vec<PathBuf> {
        self.0.keys().cloned().collect()
    }
}
