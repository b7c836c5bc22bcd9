//! Every fault of a quantity has its sentence in both languages.

use gaitcam_base::error::{Fault, UnitsError};
use gaitcam_base::wording::{FILES, Language, WORDS};
use strum::VariantNames;

#[path = "../../test-support/src/fluent.rs"]
mod fluent;

#[test]
fn every_fault_has_a_sentence_and_every_sentence_a_fault() {
    let keys = WORDS.of(Language::En).keys();
    let sentences = keys.iter().filter(|key| !key.starts_with("name-"));
    let mut codes = UnitsError::VARIANTS
        .iter()
        .map(|variant| format!("{}-{variant}", UnitsError::AREA))
        .collect::<Vec<_>>();
    codes.sort();
    let mut sentences = sentences.cloned().collect::<Vec<_>>();
    sentences.sort();
    assert_eq!(sentences, codes);
}

#[test]
fn spanish_has_the_messages_help_texts_and_arguments_of_english() {
    for [english, spanish] in FILES {
        fluent::assert_same_messages(english, spanish);
    }
}
