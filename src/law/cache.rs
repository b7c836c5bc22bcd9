//! Cached results of a law: extremes, joints and scaled coefficients.

use std::sync::{Arc, Mutex, OnceLock};

use super::joint::Joint;
use crate::poly::Extreme;

/// Pair of minimum and maximum.
pub type Extremes = (Extreme, Extreme);

/// Cached properties of a law. Clones share the cache. Comparisons of laws ignore it.
#[derive(Debug, Clone, Default)]
pub struct Cache(Arc<Cached>);

#[derive(Debug, Default)]
struct Cached {
    /// Extremes of w₀s + w₁v + w₂a + w₃j, with the weights [w₀, w₁, w₂, w₃] as keys.
    extremes: Mutex<Vec<([f64; 4], Extremes)>>,
    joints: OnceLock<Vec<Joint>>,
    /// Bernstein coefficients of s, v, a, j, multiplied by the binomial coefficients.
    scaled: OnceLock<[Vec<f64>; 4]>,
}

impl PartialEq for Cache {
    fn eq(&self, _: &Cache) -> bool {
        true
    }
}

impl Cache {
    /// Cache for the law with a constant added to its lift. Extremes of combinations without the lift remain valid.
    pub fn on_any_level(&self) -> Cache {
        let same = |list: &Vec<([f64; 4], Extremes)>| {
            let all = list.iter().filter(|(weights, _)| weights[0] == 0.0);
            all.copied().collect()
        };
        let list = self.0.extremes.lock().map(|list| same(&list));
        Cache(Arc::new(Cached {
            extremes: Mutex::new(list.unwrap_or_default()),
            joints: self.0.joints.clone(),
            scaled: OnceLock::new(),
        }))
    }

    /// Cached extremes. `search` computes them on the first request.
    pub fn extremes(&self, weights: [f64; 4], search: impl FnOnce() -> Extremes) -> Extremes {
        let cached = self.0.extremes.lock().ok().and_then(|list| {
            let same = list.iter().find(|(key, _)| *key == weights);
            same.map(|(_, extremes)| *extremes)
        });
        cached.unwrap_or_else(|| {
            let extremes = search();
            if let Ok(mut list) = self.0.extremes.lock() {
                list.push((weights, extremes));
            }
            extremes
        })
    }

    /// Cached joints. `find` computes them on the first request.
    pub fn joints(&self, find: impl FnOnce() -> Vec<Joint>) -> &[Joint] {
        self.0.joints.get_or_init(find)
    }

    /// Cached scaled coefficients. `find` computes them on the first request.
    pub fn scaled(&self, find: impl FnOnce() -> [Vec<f64>; 4]) -> &[Vec<f64>; 4] {
        self.0.scaled.get_or_init(find)
    }
}
