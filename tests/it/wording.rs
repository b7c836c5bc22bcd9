//! Every code has its sentence, and every sentence its code.

use std::collections::BTreeSet;

use gaitcam::error::{CamError, DynamicsError, ForceError, ReadError, UnitsError};
use gaitcam::force::{CycleSource, Format, Idle, LABELS, MassSource, Note, RejectReason};
use gaitcam::wording::{Language, catalogue};
use strum::VariantNames;

/// Areas with the variants of their messages. An area that is missing here fails the test below.
fn areas() -> Vec<(&'static str, &'static [&'static str])> {
    vec![
        ("units", UnitsError::VARIANTS),
        ("cam", CamError::VARIANTS),
        ("dynamics", DynamicsError::VARIANTS),
        ("force", ForceError::VARIANTS),
        ("read", ReadError::VARIANTS),
        ("note", Note::VARIANTS),
        ("cycle", CycleSource::VARIANTS),
        ("mass-from", MassSource::VARIANTS),
        ("channel", Idle::VARIANTS),
        ("contact", RejectReason::VARIANTS),
        ("format", Format::VARIANTS),
        ("gait", LABELS),
    ]
}

#[test]
fn every_code_has_a_sentence_and_every_sentence_a_code() {
    let mut codes: BTreeSet<String> = BTreeSet::new();
    for (area, variants) in areas() {
        codes.extend(variants.iter().map(|v| format!("{area}-{v}")));
    }
    let words = catalogue(Language::En);
    let own = words.keys().iter().filter(|k| !k.starts_with("name-"));
    let keys: BTreeSet<String> = own.cloned().collect();
    let unsaid: Vec<_> = codes.difference(&keys).collect();
    let unused: Vec<_> = keys.difference(&codes).collect();
    assert!(
        unsaid.is_empty() && unused.is_empty(),
        "without a sentence: {unsaid:?}; without a code: {unused:?}"
    );
}
