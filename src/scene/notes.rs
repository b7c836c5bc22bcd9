//! Keys that are given but have no effect in this scene. They are reported, not refused, so that a sweep over
//! families or followers can leave them in place.

use serde::Serialize;

use super::Scene;
use super::keys::{Idle, KEYS, Key, find};
use crate::error::{Error, Placed, SceneError};
use crate::wording::{self, Language};

/// A remark on a valid scene.
///
/// ```
/// use gaitcam::scene::SceneNote;
/// use gaitcam::{Scene, scene};
///
/// // A load model has its own stride: the rate of a recording changes nothing.
/// let scene: Scene = scene::built_in("footbridge")?.scene()?.with("gait.rate", "100 Hz")?;
/// let [SceneNote::NoEffect { key, .. }] = &scene.notes()[..] else { panic!("{:?}", scene.notes()) };
/// assert_eq!(key, "gait.rate");
/// # Ok::<(), gaitcam::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum SceneNote {
    /// A key without effect in this scene.
    NoEffect {
        /// The key; a list without the number of an entry.
        key: String,
        /// Why.
        why: Idle,
        /// The law's family.
        family: &'static str,
        /// The kind of follower.
        follower: &'static str,
        /// The kind of drive.
        drive: &'static str,
    },
}

impl SceneNote {
    /// The note as a sentence.
    pub fn sentence(&self, language: Language) -> String {
        wording::sentence(language, "scene", self)
    }
}

/// Turns the note into an error, for changes of a single key.
impl From<SceneNote> for Error {
    fn from(note: SceneNote) -> Error {
        let SceneNote::NoEffect {
            key,
            why,
            family,
            follower,
            drive,
        } = note;
        SceneError::NoEffect {
            key: key.clone(),
            why: why.name(),
            family,
            follower,
            drive,
        }
        .at_key(&key)
    }
}

impl Scene {
    /// One note for each given key without effect.
    pub fn notes(&self) -> Vec<SceneNote> {
        let without_effect = KEYS
            .iter()
            .filter_map(|key| Some((key, key.idle(self).filter(|_| self.gives(key))?)));
        without_effect
            .map(|(key, why)| SceneNote::NoEffect {
                key: key.list().unwrap_or(key.path).to_string(),
                why,
                family: self.law.family.name(),
                follower: self.cam.follower.name(),
                drive: self.drive.kind.name(),
            })
            .collect()
    }

    /// The note about one key, if it has no effect.
    pub fn no_effect_of(&self, path: &str) -> Option<SceneNote> {
        let key = find(path)?;
        let name = key.list().unwrap_or(key.path);
        let of = |note: &SceneNote| matches!(note, SceneNote::NoEffect { key, .. } if key == name);
        self.notes().into_iter().find(of)
    }

    /// Whether a key has a value of its own.
    fn gives(&self, key: &Key) -> bool {
        let value = key.get(self, 0);
        key.exists(self) && value.is_some_and(|v| !self.is_default(key, &v))
    }
}
