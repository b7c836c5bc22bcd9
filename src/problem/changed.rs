//! A problem with another value of a key that searches change: a limit, the accuracy, a size of the cam.

use super::Problem;
use crate::scene::Scene;
use crate::scene::keys::{Key, Value};

impl Problem {
    /// The value that a key has; `None` where the problem leaves it open or does not keep it.
    pub fn value(&self, key: &Key) -> Option<f64> {
        key.number(&self.tables())
    }

    /// The same problem with another value of a key in `[limits]`, `[accuracy]` or `[cam]`.
    pub fn with(&self, key: &Key, value: f64) -> Problem {
        let mut scene = self.tables();
        // A number is refused by no row.
        let _ = key.set(&mut scene, 0, Value::Number(value));
        Problem {
            cam: scene.cam,
            limits: scene.limits,
            accuracy: scene.rms,
            ..self.clone()
        }
    }

    /// The tables of the scene that searches change, as they stand now.
    fn tables(&self) -> Scene {
        Scene {
            cam: self.cam.clone(),
            limits: self.limits.clone(),
            rms: self.accuracy,
            ..Scene::default()
        }
    }
}
