//! Every error, note and name of a recording has a message in both languages.

use std::collections::BTreeSet;
use std::path::Path;

use gaitcam_gait::error::{Fault, ForceError, ReadError};
use gaitcam_gait::wording::{Language, SENTENCES, WORDS};
use gaitcam_gait::{
    ClockSource, CycleSource, Format, Idle, Kind, LeftOut, MassSource, Note, OpenQuestion,
    ReadOptions, RejectReason, read,
};
use strum::VariantNames;

#[path = "../../../test-support/src/fluent.rs"]
mod fluent;

#[test]
fn every_code_has_a_sentence_and_every_sentence_a_code() {
    let areas = [
        (ForceError::AREA, ForceError::VARIANTS),
        (ReadError::AREA, ReadError::VARIANTS),
        ("note", Note::VARIANTS),
        ("cycle", CycleSource::VARIANTS),
        ("mass-from", MassSource::VARIANTS),
        ("kind", Kind::VARIANTS),
        ("open", OpenQuestion::VARIANTS),
        ("left-out", LeftOut::VARIANTS),
        ("left-out", OpenQuestion::VARIANTS),
        ("clock", ClockSource::VARIANTS),
        ("channel", Idle::VARIANTS),
        ("contact", RejectReason::VARIANTS),
        ("format", Format::VARIANTS),
    ];
    let code = |area, variants: &[&str]| -> Vec<String> {
        let codes = variants.iter().map(|variant| format!("{area}-{variant}"));
        codes.collect()
    };
    let codes: BTreeSet<String> = (areas.iter().flat_map(|(a, v)| code(a, v))).collect();
    let keys = SENTENCES
        .files
        .iter()
        .flat_map(|[english, _]| english.lines());
    let keys = keys.filter(|line| line.starts_with(|c: char| c.is_ascii_lowercase()));
    let keys = keys.filter_map(|line| Some(line.split_once(" =")?.0.to_string()));
    let keys: BTreeSet<String> = keys.filter(|key| !key.starts_with("name-")).collect();
    let missing: Vec<_> = codes.difference(&keys).collect();
    let unused: Vec<_> = keys.difference(&codes).collect();
    assert!(
        missing.is_empty() && unused.is_empty(),
        "without a sentence: {missing:?}; without a code: {unused:?}"
    );
}

#[test]
fn spanish_has_the_messages_help_texts_and_arguments_of_english() {
    for [english, spanish] in SENTENCES.files {
        fluent::assert_same_messages(english, spanish);
    }
    let keys = [Language::En, Language::Es].map(|language| WORDS.of(language).keys());
    assert_eq!(keys[0], keys[1], "the messages stand in another order");
}

#[test]
fn a_refusal_has_the_columns_by_their_whole_names() {
    let names = ["time", "left foot, raw", "height"];
    let table = "time;left foot, raw;height\n0;1;2\n1;2;3\n2;3;4\n";
    let refused = |force: Vec<String>| {
        let options = ReadOptions {
            force,
            ..ReadOptions::default()
        };
        read(Path::new("bad.csv"), table.as_bytes(), &options).unwrap_err()
    };
    for e in [
        refused(Vec::new()),
        refused(vec!["right".to_string()]),
        refused(vec!["heigth".to_string()]),
    ] {
        match e.fault() {
            Some(
                ReadError::NoForceColumn { columns }
                | ReadError::NoColumn { columns, .. }
                | ReadError::MisspeltColumn { columns, .. },
            ) => assert_eq!(columns[..], names, "{e}"),
            _ => panic!("{e}"),
        }
        let help = e.help(Language::En).unwrap_or_default();
        assert!(help.contains("time, left foot, raw, height"), "{help}");
    }
}
