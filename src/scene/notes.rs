//! Given keys without effect in a scene. They are reported but not rejected, so that a sweep over families or followers can keep them.

use super::Scene;
use super::keys::{KEYS, Key, find};
use crate::error::{Error, Placed, SceneError};

impl Scene {
    /// [`SceneError::NoEffect`] for each given key without effect. Keys of a list are given without the number of an entry.
    ///
    /// ```
    /// use gaitcam::error::SceneError;
    /// use gaitcam::{Scene, scene};
    ///
    /// // A load model has its own stride: the rate of a recording changes nothing.
    /// let scene: Scene = scene::built_in("footbridge")?.scene()?.with("gait.rate", "100 Hz")?;
    /// let [SceneError::NoEffect { key, .. }] = &scene.notes()[..] else { panic!("{:?}", scene.notes()) };
    /// assert_eq!(key, "gait.rate");
    /// # Ok::<(), gaitcam::error::Error>(())
    /// ```
    pub fn notes(&self) -> Vec<SceneError> {
        KEYS.iter().filter_map(|key| self.note_on(key)).collect()
    }

    /// Error for a change of one key, if the key has no effect.
    pub fn no_effect_of(&self, path: &str) -> Option<Error> {
        let key = find(path)?;
        let name = key.list().unwrap_or(key.path);
        let mut same = KEYS.iter().filter(|k| k.list().unwrap_or(k.path) == name);
        same.find_map(|key| Some(self.note_on(key)?.at_key(name)))
    }

    fn note_on(&self, key: &Key) -> Option<SceneError> {
        let why = key.idle(self).filter(|_| self.gives(key))?;
        Some(SceneError::NoEffect {
            key: key.list().unwrap_or(key.path).to_string(),
            why: why.name(),
            family: self.law.family.name(),
            follower: self.cam.follower.name(),
            drive: self.drive.kind.name(),
        })
    }

    /// Whether a key has an explicit value in the scene.
    fn gives(&self, key: &Key) -> bool {
        let value = key.get(self, 0);
        key.exists(self) && value.is_some_and(|v| !self.is_default(key, &v))
    }
}
