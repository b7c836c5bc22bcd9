//! Comparison of Fluent files with the code that uses them and with each other.

use std::collections::BTreeSet;
use std::path::Path;

pub use crate::fluent::assert_same_messages;

/// Text of all files of a folder with one of the endings.
///
/// # Panics
///
/// If a folder or a file cannot be read.
pub fn sources(folder: &Path, endings: &[&str]) -> String {
    let mut out = String::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let ending = path.extension().and_then(|e| e.to_str());
        if path.is_dir() {
            out += &sources(&path, endings);
        } else if ending.is_some_and(|e| endings.contains(&e)) {
            out += &std::fs::read_to_string(&path).unwrap();
        }
    }
    out
}

/// Keys of a Fluent file that begin with one of `areas`.
pub fn keys<'a>(messages: &'a str, areas: &[&str]) -> BTreeSet<&'a str> {
    let keys = messages
        .lines()
        .filter_map(|line| Some(line.split_once(" = ")?.0));
    keys.filter(|k| is_of(k, areas)).collect()
}

/// Whether a key belongs to one of the areas.
fn is_of(key: &str, areas: &[&str]) -> bool {
    areas.iter().any(|area| key.starts_with(area))
}

/// Asserts that the string literals in the sources of a crate that begin with one of `areas` are the keys of its English file in these areas.
///
/// # Panics
///
/// If they differ.
pub fn assert_keys_are_used(src: &Path, english: &str, areas: &[&str]) {
    let code = sources(src, &["rs"]);
    let used: BTreeSet<&str> = code.split('"').filter(|k| is_of(k, areas)).collect();
    let keys = keys(english, areas);
    let missing: Vec<_> = used.difference(&keys).collect();
    let unused: Vec<_> = keys.difference(&used).collect();
    assert!(
        missing.is_empty() && unused.is_empty(),
        "without a text: {missing:?}; not used: {unused:?}"
    );
}
