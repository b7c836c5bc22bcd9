//! Cache of the most recently used values.

use std::collections::VecDeque;

/// Cache for at most `most` values. The value that has not been used for the longest time is dropped first.
pub struct Recent<K, V> {
    most: usize,
    list: VecDeque<(K, V)>,
}

impl<K: PartialEq, V: Clone> Recent<K, V> {
    /// Creates an empty cache for `most` values.
    pub fn new(most: usize) -> Self {
        let list = VecDeque::new();
        Recent { most, list }
    }

    /// Value of a key, which becomes the most recently used value; `None` if the value is not in the cache.
    pub fn get(&mut self, key: &K) -> Option<V> {
        let at = self.list.iter().position(|(k, _)| k == key)?;
        let entry = self.list.remove(at)?;
        let value = entry.1.clone();
        self.list.push_back(entry);
        Some(value)
    }

    /// Stores a value. If there are more than `most` values, the least recently used one is dropped.
    pub fn put(&mut self, key: K, value: V) {
        self.list.retain(|(k, _)| *k != key);
        self.list.push_back((key, value));
        while self.list.len() > self.most {
            self.list.pop_front();
        }
    }

    /// Drops the least recently used values until the total size is at most `most`. One value always remains.
    pub fn shrink(&mut self, most: usize, size: impl Fn(&V) -> usize) {
        let mut all: usize = self.list.iter().map(|(_, value)| size(value)).sum();
        while all > most && self.list.len() > 1 {
            all -= self.list.pop_front().map_or(0, |(_, value)| size(&value));
        }
    }
}
