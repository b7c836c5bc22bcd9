//! Every label has a text in both languages, and every text is used.

use std::path::Path;

use gaitcam_test_support::words;

const ENGLISH: &str = include_str!("../../src/words/en.ftl");
const GAIT: &str = include_str!("../../src/gait/en.ftl");

#[test]
fn every_key_has_a_text_and_every_text_is_used() {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    words::assert_keys_are_used(
        &src,
        ENGLISH,
        &["report-", "figure-", "sheet-", "simulation-"],
    );
    // A label with data is a variant of an enum.
    let plain: Vec<&str> = GAIT.lines().filter(|line| !line.contains("{ $")).collect();
    words::assert_keys_are_used(&src, &plain.join("\n"), &["gait-"]);
}

#[test]
fn spanish_has_the_messages_and_arguments_of_english() {
    words::assert_same_messages(ENGLISH, include_str!("../../src/words/es.ftl"));
    words::assert_same_messages(GAIT, include_str!("../../src/gait/es.ftl"));
}
