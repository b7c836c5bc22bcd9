//! Every key of the page has a text in both languages, and every text is used.

use std::collections::BTreeSet;
use std::path::Path;

use gaitcam_test_support::words;

#[test]
fn every_key_has_a_text_and_every_text_is_used() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let code = words::sources(&root.join("page"), &["html", "js"]);
    let parts = code.split(['"', '`', '\'']);
    let used: BTreeSet<&str> = parts
        .filter(|k| k.starts_with("studio-") && !k.contains(['$', ' ']))
        .collect();
    let stems: Vec<&str> = code
        .split('`')
        .filter(|k| k.starts_with("studio-"))
        .filter_map(|k| Some(k.split_once("${")?.0))
        .collect();
    let text = std::fs::read_to_string(root.join("../app/src/page/words/en.ftl")).unwrap();
    let known = words::keys(&text, &["studio-"]);
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
    words::assert_same_messages(
        include_str!("../../../app/src/page/words/en.ftl"),
        include_str!("../../../app/src/page/words/es.ftl"),
    );
}
