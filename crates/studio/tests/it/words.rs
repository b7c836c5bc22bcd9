//! Every key of the page has its text in both languages, and every text is used.

use std::collections::BTreeSet;
use std::path::Path;

#[path = "../../../../tests/it/fluent.rs"]
mod fluent;

fn texts(folder: &Path, endings: &[&str], out: &mut String) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            texts(&path, endings, out);
        } else if path
            .extension()
            .is_some_and(|e| endings.iter().any(|ending| e == *ending))
        {
            out.push_str(&std::fs::read_to_string(&path).unwrap());
        }
    }
}

#[test]
fn every_key_has_a_text_and_every_text_is_used() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut code = String::new();
    texts(&root.join("page"), &["html", "js"], &mut code);
    let parts = code.split(['"', '`', '\'']);
    let used: BTreeSet<&str> = parts
        .filter(|k| k.starts_with("studio-") && !k.contains(['$', ' ']))
        .collect();
    let stems: Vec<&str> = code
        .split('`')
        .filter(|k| k.starts_with("studio-"))
        .filter_map(|k| Some(k.split_once("${")?.0))
        .collect();
    let text = std::fs::read_to_string(root.join("src/words/en.ftl")).unwrap();
    let known: BTreeSet<&str> = text
        .lines()
        .filter_map(|line| Some(line.split_once(" = ")?.0))
        .filter(|key| key.starts_with("studio-"))
        .collect();
    let unsaid: Vec<_> = used.difference(&known).collect();
    let made = |key: &str| stems.iter().any(|stem| key.starts_with(stem));
    let unused: Vec<_> = known.difference(&used).filter(|key| !made(key)).collect();
    assert!(
        unsaid.is_empty() && unused.is_empty(),
        "without a text: {unsaid:?}; not used: {unused:?}"
    );
}

#[test]
fn spanish_has_the_messages_and_arguments_of_english() {
    fluent::assert_same_messages(
        include_str!("../../src/words/en.ftl"),
        include_str!("../../src/words/es.ftl"),
    );
}
