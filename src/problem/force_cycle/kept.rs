//! Cache of a limited number of results.

use std::sync::Mutex;

/// Maximum number of cached results. Before a further result is added, all earlier results are removed.
const MOST: usize = 64;

/// Cache. Each entry contains a result and the parameters from which it was computed.
#[derive(Debug)]
pub struct Cache<V>(Mutex<Vec<V>>);

impl<V> Default for Cache<V> {
    fn default() -> Self {
        Cache(Mutex::default())
    }
}

impl<V: Clone> Cache<V> {
    /// The cached result for which `is_same` is true. If it does not exist, the result of `find` is cached and returned.
    ///
    /// # Errors
    ///
    /// The errors of `find`.
    pub fn get<E>(
        &self,
        is_same: impl Fn(&V) -> bool,
        find: impl FnOnce() -> Result<V, E>,
    ) -> Result<V, E> {
        if let Ok(kept) = self.0.lock()
            && let Some(same) = kept.iter().rev().find(|v| is_same(v))
        {
            return Ok(same.clone());
        }
        let new = find()?;
        if let Ok(mut kept) = self.0.lock() {
            if kept.len() >= MOST {
                kept.clear();
            }
            kept.push(new.clone());
        }
        Ok(new)
    }
}
