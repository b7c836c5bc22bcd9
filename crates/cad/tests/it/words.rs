//! Every label has a text in both languages, and every text is used.

use std::path::Path;

use gaitcam_test_support::words;

const ENGLISH: &str = include_str!("../../src/words/en.ftl");

#[test]
fn every_key_has_a_text_and_every_text_is_used() {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    words::assert_keys_are_used(&src, ENGLISH, &["drawing-"]);
}

#[test]
fn spanish_has_the_messages_and_arguments_of_english() {
    words::assert_same_messages(ENGLISH, include_str!("../../src/words/es.ftl"));
}
