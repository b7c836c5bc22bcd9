//! Every code has its sentence, and every sentence its code.

use std::collections::BTreeSet;

use gaitcam::error::{
    CamError, DynamicsError, ForceError, JoinCure, LawError, ReadError, SceneError, SegmentName,
    UnitsError,
};
use gaitcam::force::{CycleSource, Format, Idle, LABELS, MassSource, Note, RejectReason};
use gaitcam::scene::SCENES;
use gaitcam::scene::keys::KEYS;
use gaitcam::wording::{Language, catalogue};
use strum::VariantNames;

/// Areas with the variants of their messages. An area that is missing here fails the test below.
fn areas() -> Vec<(&'static str, &'static [&'static str])> {
    vec![
        ("units", UnitsError::VARIANTS),
        ("cam", CamError::VARIANTS),
        ("dynamics", DynamicsError::VARIANTS),
        ("force", ForceError::VARIANTS),
        ("law", LawError::VARIANTS),
        ("law", SegmentName::VARIANTS),
        ("law", JoinCure::VARIANTS),
        ("read", ReadError::VARIANTS),
        ("note", Note::VARIANTS),
        ("cycle", CycleSource::VARIANTS),
        ("mass-from", MassSource::VARIANTS),
        ("channel", Idle::VARIANTS),
        ("contact", RejectReason::VARIANTS),
        ("format", Format::VARIANTS),
        ("gait", LABELS),
        ("scene", SceneError::VARIANTS),
    ]
}

#[test]
fn every_code_has_a_sentence_and_every_sentence_a_code() {
    let mut codes: BTreeSet<String> = BTreeSet::new();
    for (area, variants) in areas() {
        codes.extend(variants.iter().map(|v| format!("{area}-{v}")));
    }
    // What each key of a scene means.
    codes.extend(
        KEYS.iter()
            .map(|k| format!("key-{}", k.path.replace('.', "-"))),
    );
    codes.extend(SCENES.iter().map(|s| format!("built-in-{}", s.name)));
    codes.insert("scene-no-effect".to_string());
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
