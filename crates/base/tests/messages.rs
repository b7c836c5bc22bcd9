//! Every error of a quantity has a message in both languages.

use gaitcam_base::error::{Fault, UnitsError};
use gaitcam_base::units::Quantity;
use gaitcam_base::wording::{Catalogue, Language, SENTENCES, Sentences, WORDS};
use serde::Serialize;
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
    for [english, spanish] in SENTENCES.files {
        fluent::assert_same_messages(english, spanish);
    }
}

#[derive(Serialize)]
#[serde(rename_all = "kebab-case")]
enum Message {
    Forces { mean: Quantity, weight: Quantity },
}

#[test]
fn quantities_of_notes_have_four_digits_and_those_typed_back_six() {
    const ENGLISH: &str = "design-forces = { $mean }, { $weight }\nreason-forces = { $mean }, { $weight }\nscene-forces = { $mean }, { $weight }\n";
    static WORDS: Catalogue = Catalogue::new(&[Sentences {
        files: &[[ENGLISH, ENGLISH]],
        notes: &["design", "reason"],
        typed_back: &["reason-forces"],
        ..Sentences::NONE
    }]);
    let say = |language, area, mean, weight| {
        let (mean, weight) = (Quantity::force(mean), Quantity::force(weight));
        let message = Message::Forces { mean, weight };
        WORDS.of(language).sentence(area, &message)
    };
    let (en, es) = (Language::En, Language::Es);
    let (a, b) = (4.951_794_3, 25.438_216);
    assert_eq!(say(en, "design", a, b), "4.952 N, 25.44 N");
    assert_eq!(say(es, "design", a, b), "4,952 N, 25,44 N");
    assert_eq!(say(en, "reason", a, b), "4.95179 N, 25.4382 N");
    assert_eq!(say(en, "scene", a, b), "4.95179 N, 25.4382 N");
    // Two that four digits would show as one number.
    assert_eq!(say(en, "design", 700.0, 700.042), "700 N, 700.042 N");
}
