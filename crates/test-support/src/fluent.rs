//! Comparison of two Fluent files that must have the same messages.

use std::collections::{BTreeMap, BTreeSet};

/// Asserts that two languages have the same keys, attributes and arguments.
///
/// # Panics
///
/// If they differ.
pub fn assert_same_messages(english: &str, spanish: &str) {
    let (english, spanish) = (arguments(english), arguments(spanish));
    for (key, wanted) in &english {
        assert_eq!(Some(wanted), spanish.get(key), "{key} in Spanish");
        // A field `at_ends` is the argument `$at-ends`.
        let filled = wanted.iter().all(|argument| !argument.contains('_'));
        assert!(
            filled,
            "{key} has an argument that no field fills: {wanted:?}"
        );
    }
    for key in spanish.keys() {
        assert!(english.contains_key(key), "{key} in Spanish alone");
    }
}

/// Arguments of every message and of every attribute (`key.attribute`) of a Fluent file.
fn arguments(text: &str) -> BTreeMap<String, BTreeSet<String>> {
    let mut found: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    let (mut key, mut part) = (String::new(), String::new());
    for line in text.lines().filter(|l| !l.starts_with('#')) {
        let start = line.trim_start();
        let is_message = line.starts_with(|c: char| c.is_ascii_lowercase());
        if is_message || start.starts_with('.') {
            let (name, _) = start.split_once(" =").unwrap();
            if is_message {
                key = name.to_string();
                part = key.clone();
            } else {
                part = format!("{key}{name}");
            }
            found.insert(part.clone(), BTreeSet::new());
        }
        for after in line.split('$').skip(1) {
            let ends = |c: char| !(c.is_ascii_alphanumeric() || c == '-' || c == '_');
            let name = after.split(ends).next().unwrap_or_default();
            found.get_mut(&part).unwrap().insert(name.to_string());
        }
    }
    found
}
