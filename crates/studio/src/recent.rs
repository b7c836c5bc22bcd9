//! A short memory: the last few of something by their names.

use std::collections::VecDeque;

/// The last `most` values.
pub struct Recent<K, V> {
    most: usize,
    list: VecDeque<(K, V)>,
}

impl<K: PartialEq, V: Clone> Recent<K, V> {
    /// An empty memory.
    pub fn new(most: usize) -> Self {
        let list = VecDeque::new();
        Recent { most, list }
    }

    /// What is kept under a name; it counts as new again.
    pub fn get(&mut self, key: &K) -> Option<V> {
        let at = self.list.iter().position(|(k, _)| k == key)?;
        let entry = self.list.remove(at)?;
        let value = entry.1.clone();
        self.list.push_back(entry);
        Some(value)
    }

    /// Keeps a value and forgets the oldest where there are too many.
    pub fn put(&mut self, key: K, value: V) {
        self.list.retain(|(k, _)| *k != key);
        self.list.push_back((key, value));
        while self.list.len() > self.most {
            self.list.pop_front();
        }
    }
}
