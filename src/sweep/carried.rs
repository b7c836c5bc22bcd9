//! Recordings of a sweep, stored with the sweep by content.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::error::{Placed, Result, SweepError};
use crate::force::ForceCurve;
use crate::scene::{self, Scene};

/// Key of a stored file. It consists of the index of a base scene and the path of the file in this scene.
pub type Named = (usize, String);

/// Contents of the files from which the rows of a sweep are computed.
///
/// ```
/// use gaitcam::sweep::Files;
///
/// let mut files = Files::new();
/// files.insert((0, "walk.csv".to_string()), b"time,Fz\n".to_vec().into());
/// assert_eq!(files[&(0, "walk.csv".to_string())].len(), 8);
/// ```
pub type Files = BTreeMap<Named, Arc<Vec<u8>>>;

/// Reads the force curve of a scene from the stored files. `scene` is the index of the base scene from which `of` was derived.
///
/// # Errors
///
/// The scene has no force, or a file is missing or invalid.
pub fn force(files: &Files, scene: usize, of: &Scene) -> Result<ForceCurve> {
    let carried = Carried { files, scene };
    let gait = of.gait.as_ref();
    let force = gait.map(|gait| gait.force(&carried)).transpose()?;
    force
        .flatten()
        .ok_or_else(|| SweepError::NoForceError.into())
}

/// The stored files of one base scene, as [`scene::Files`].
struct Carried<'a> {
    files: &'a Files,
    scene: usize,
}

impl Carried<'_> {
    fn find(&self, name: &Path) -> Option<&Arc<Vec<u8>>> {
        self.files
            .get(&(self.scene, name.to_string_lossy().into_owned()))
    }
}

impl scene::Files for Carried<'_> {
    fn has(&self, name: &Path) -> bool {
        self.find(name).is_some()
    }

    fn read(&self, name: &Path) -> Result<Arc<Vec<u8>>> {
        let missing = || SweepError::NotCarried.in_file(name);
        self.find(name).cloned().ok_or_else(missing)
    }

    fn names(&self) -> Vec<PathBuf> {
        let own = self.files.keys().filter(|key| key.0 == self.scene);
        own.map(|key| PathBuf::from(&key.1)).collect()
    }
}
