//! Keys that are given in a scene but have no effect. They are reported and not rejected, so that a sweep over families or followers can contain
//! them.

use super::Scene;
use super::keys::{KEYS, Key, find};
use crate::error::{Error, Placed, SceneError};

impl Scene {
    /// Notes on the given keys that have no effect, as [`SceneError::NoEffect`]. For a key of a list, the note contains the path of the list.
    ///
    /// ```
    /// use gaitcam::error::SceneError;
    /// use gaitcam::{Scene, scene};
    ///
    /// // A load model is not sampled, so the sampling rate of a recording has no effect.
    /// let scene: Scene = scene::built_in("footbridge")?.scene()?.with("gait.rate", "100 Hz")?;
    /// let [SceneError::NoEffect { key, .. }] = &scene.notes()[..] else { panic!("{:?}", scene.notes()) };
    /// assert_eq!(key, "gait.rate");
    /// # Ok::<(), gaitcam::error::Error>(())
    /// ```
    pub fn notes(&self) -> Vec<SceneError> {
        KEYS.iter().filter_map(|key| self.note_on(key)).collect()
    }

    /// Error for a changed key that has no effect in the scene; `None` if the change has an effect.
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

    /// Whether the scene contains a value of a key that differs from its default.
    fn gives(&self, key: &Key) -> bool {
        let value = key.get(self, 0);
        key.exists(self) && value.is_some_and(|v| !self.is_default(key, &v))
    }
}
