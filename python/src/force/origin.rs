//! Data from which a force is computed: arrays, or the content of a recording.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use gaitcam::error::{Placed, SceneError, SweepError};
use gaitcam::force::{self, ForceCurve};
use gaitcam::scene::{self, BETWEEN_PLATES, Files, Gait};
use toml::{Table, Value};

/// Name of the file in the result folder that contains a force given as arrays.
pub use gaitcam_app::design::FORCE as FILE;

/// Data from which a force is computed.
#[derive(Clone)]
pub enum Origin {
    /// Arrays with the times and forces of one cycle.
    Arrays,
    /// Recording, with the options for reading it.
    Recording {
        /// Options for reading: keys of the section `[gait]`.
        gait: Table,
        /// Content of the recording file.
        bytes: Arc<Vec<u8>>,
        /// Content of the table of subjects in the folder of the recording file; `None` without such a table.
        metadata: Option<Vec<u8>>,
    },
}

impl Files for Origin {
    fn has(&self, name: &Path) -> bool {
        self.read(name).is_ok()
    }

    fn read(&self, name: &Path) -> gaitcam::error::Result<Arc<Vec<u8>>> {
        let missing = || SweepError::NotCarried.in_file(name);
        let Origin::Recording {
            gait,
            bytes,
            metadata,
        } = self
        else {
            return Err(missing());
        };
        let file = gait.get("file").and_then(Value::as_str).map(Path::new);
        if file == Some(name) {
            return Ok(Arc::clone(bytes));
        }
        let beside = file.and_then(force::metadata_name);
        let metadata = metadata.clone().filter(|_| beside.as_deref() == Some(name));
        metadata.map(Arc::new).ok_or_else(missing)
    }
}

/// Keys of `[gait]` that define the source of a force.
const OF_SOURCE: [&str; 13] = [
    "file",
    "model",
    "step_frequency",
    "body_weight",
    "time",
    "force",
    "unit",
    "rate",
    "mass",
    "kind",
    "period",
    "span",
    "noise",
];

impl Origin {
    /// Keys of `[gait]` that define this force.
    pub fn keys(&self) -> Table {
        match self {
            Origin::Arrays => Table::from_iter([("file".to_string(), Value::from(FILE))]),
            Origin::Recording { gait, .. } => gait.clone(),
        }
    }

    /// Path of the file of this force. For several files, the path of the first file is returned.
    pub fn file(&self) -> PathBuf {
        let keys = self.keys();
        let name = keys.get("file").and_then(Value::as_str).unwrap_or(FILE);
        let first = name.split(BETWEEN_PLATES).next();
        PathBuf::from(first.unwrap_or(name))
    }

    /// Section `[gait]` that defines this force.
    ///
    /// # Errors
    ///
    /// An option is invalid.
    pub fn gait(&self) -> gaitcam::error::Result<Gait> {
        let gait = Value::Table(self.keys());
        let scene = scene::read_keys(&Table::from_iter([("gait".to_string(), gait)]))?;
        Ok(scene.gait.unwrap_or_default())
    }

    /// Mean cycle of the force.
    ///
    /// # Errors
    ///
    /// An option is invalid, or the recording cannot be read.
    pub fn curve(&self) -> gaitcam::error::Result<ForceCurve> {
        let curve = self.gait()?.force(self)?;
        curve.ok_or_else(|| SceneError::NoForceNamed.into())
    }

    /// Copy of the table of a scene in which this force is the source in `[gait]`. Keys for scale, band, phase and weights are unchanged.
    pub fn named_in(&self, scene: &Table) -> Table {
        let mut table = scene.clone();
        let own = table.get("gait").and_then(Value::as_table).cloned();
        let mut gait = own.unwrap_or_default();
        for key in OF_SOURCE {
            gait.remove(key);
        }
        gait.extend(self.keys());
        table.insert("gait".to_string(), Value::Table(gait));
        table
    }
}
