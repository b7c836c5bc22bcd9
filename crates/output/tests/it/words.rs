//! Every key of the report and the pictures has its text, and every text is used.

use std::collections::BTreeSet;
use std::path::Path;

#[path = "../../../../tests/it/fluent.rs"]
mod fluent;

fn sources(folder: &Path, out: &mut String) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources(&path, out);
        } else if path.extension().is_some_and(|e| e == "rs") {
            out.push_str(&std::fs::read_to_string(&path).unwrap());
        }
    }
}

#[test]
fn every_key_has_a_text_and_every_text_is_used() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut code = String::new();
    sources(&root, &mut code);
    let area = |k: &&str| {
        ["report-", "figure-", "sheet-", "drawing-"]
            .iter()
            .any(|area| k.starts_with(area))
    };
    let used: BTreeSet<&str> = code.split('"').filter(area).collect();
    let text = std::fs::read_to_string(root.join("words/en.ftl")).unwrap();
    let known: BTreeSet<&str> = text
        .lines()
        .filter_map(|line| Some(line.split_once(" = ")?.0))
        .filter(area)
        .collect();
    let unsaid: Vec<_> = used.difference(&known).collect();
    let unused: Vec<_> = known.difference(&used).collect();
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
