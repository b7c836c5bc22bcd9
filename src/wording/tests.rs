//! Every code has a message, and every message has a code.

use std::collections::BTreeSet;

use crate::criterion::{Criterion, LimitKind};
use crate::dynamics::reason::{ForceMargin, LiftoffMargin, ModelReason, RunNote, Vibration};
use crate::error::{
    CamError, CamInputError, DynamicsError, Error, FileError, JoinCure, JoinError, LawError,
    LogError, NoDesignError, NoNewCamError, SceneError, SegmentName, SweepError, SynthError,
    WriteError,
};
use crate::law::End;
use crate::problem;
use crate::scene::SCENES;
use crate::scene::keys::KEYS;
use crate::sweep::difference::Difference;
use crate::synth::qp::Demand;
use crate::synth::report::method::Ended;
use crate::synth::report::proof::Doubt;
use crate::synth::report::reason::Change;
use crate::synth::{FIGURES, Method, PassedOver, Reason};
use crate::units::Quantity;
use crate::wording::{Language, SENTENCES, catalogue};
use strum::{EnumCount, VariantNames};

use gaitcam_test_support::words::assert_same_messages;

/// Areas with the variants of their messages. A missing area makes the test below fail.
fn areas() -> Vec<(&'static str, &'static [&'static str])> {
    vec![
        ("cam", CamError::VARIANTS),
        ("cam", CamInputError::VARIANTS),
        ("dynamics", DynamicsError::VARIANTS),
        ("model", ModelReason::VARIANTS),
        ("model", LiftoffMargin::VARIANTS),
        ("model", ForceMargin::VARIANTS),
        ("model", Vibration::VARIANTS),
        ("run", RunNote::VARIANTS),
        ("law", LawError::VARIANTS),
        ("law", JoinError::VARIANTS),
        ("law", SegmentName::VARIANTS),
        ("law", JoinCure::VARIANTS),
        ("log", LogError::VARIANTS),
        ("log", NoNewCamError::VARIANTS),
        ("scene", SceneError::VARIANTS),
        ("reason", Reason::VARIANTS),
        ("reason", Change::VARIANTS),
        ("demand", Demand::VARIANTS),
        ("design", problem::Note::VARIANTS),
        ("doubt", Doubt::VARIANTS),
        ("method", Method::VARIANTS),
        ("ended", Ended::VARIANTS),
        ("passed-over", PassedOver::VARIANTS),
        ("file", FileError::VARIANTS),
        ("differs", Difference::VARIANTS),
        ("sweep", SweepError::VARIANTS),
        ("synth", SynthError::VARIANTS),
        ("synth", NoDesignError::VARIANTS),
        ("write", WriteError::VARIANTS),
    ]
}

#[test]
fn every_code_has_a_sentence_and_every_sentence_a_code() {
    let mut codes: BTreeSet<String> = BTreeSet::new();
    for (area, variants) in areas() {
        codes.extend(variants.iter().map(|v| format!("{area}-{v}")));
    }
    // Descriptions of the keys of a scene.
    codes.extend(
        KEYS.iter()
            .map(|k| format!("key-{}", k.path.replace('.', "-"))),
    );
    // Labels of the fields of limits.
    let limits = KEYS.iter().filter(|k| k.limit.is_some());
    codes.extend(limits.map(|k| format!("label-{}", k.path.replace('.', "-"))));
    codes.extend(SCENES.iter().map(|s| format!("built-in-{}", s.name)));
    let figure = |column: &str| format!("figure-{}", column.replace('_', "-"));
    codes.extend(FIGURES.iter().map(|f| figure(f.column)));
    codes.insert("scene-no-effect".to_string());
    codes.extend(
        End::JOINS
            .iter()
            .map(|j| format!("joins-{}", j.replace(' ', "-"))),
    );
    let keys = SENTENCES
        .files
        .iter()
        .flat_map(|[english, _]| english.lines());
    let keys = keys.filter(|line| line.starts_with(|c: char| c.is_ascii_lowercase()));
    let keys = keys.filter_map(|line| Some(line.split_once(" =")?.0.to_string()));
    let keys: BTreeSet<String> = keys.filter(|key| !key.starts_with("name-")).collect();
    let unsaid: Vec<_> = codes.difference(&keys).collect();
    let unused: Vec<_> = keys.difference(&codes).collect();
    assert!(
        unsaid.is_empty() && unused.is_empty(),
        "without a sentence: {unsaid:?}; without a code: {unused:?}"
    );
}

#[test]
fn spanish_has_the_messages_help_texts_and_arguments_of_english() {
    for [english, spanish] in SENTENCES.files {
        assert_same_messages(english, spanish);
    }
    assert_eq!(
        catalogue(Language::En).keys(),
        catalogue(Language::Es).keys(),
        "the messages stand in another order"
    );
}

#[test]
fn every_criterion_has_a_name_in_both_languages() {
    use Criterion as C;
    let others = [
        C::RmsError,
        C::Accuracy,
        C::Band,
        C::BaseCircle,
        C::Bore,
        C::BaseOutsideBore,
        C::BaseRadius,
        C::GivenPrimeRadius,
        C::Inertia,
        C::Concave,
        C::Interference,
        C::UpperWall,
        C::LowerWall,
        C::Monotone,
        C::Peak,
        C::SecondCurvature,
        C::SecondDiameter,
        C::SecondConcave,
        C::SecondInterference,
        C::SecondPressureAngleRise,
        C::SecondPressureAngleFall,
    ];
    assert_eq!(others.len() + 1, Criterion::COUNT);
    let limits = LimitKind::ALL.iter().map(|kind| Criterion::from(*kind));
    let keys = catalogue(Language::Es).keys();
    for criterion in limits.chain(others) {
        let key = format!("name-{}", criterion.name().replace(['_', '.'], "-"));
        assert!(keys.contains(&key), "{key}");
    }
}

#[test]
fn spanish_sentences_have_spanish_names_and_a_decimal_comma() {
    let reason = Reason::LimitBroken {
        limit: LimitKind::Stroke.into(),
        at: Quantity::angle(0.0),
        value: Quantity::length(0.0305),
        allowed: Quantity::length(0.03),
    };
    let said = reason.sentence(Language::Es);
    assert!(
        said.contains("carrera") && said.contains("30,5 mm"),
        "{said}"
    );
    // Words from a scene are not translated.
    let error = SceneError::UnknownWord {
        word: "splin".to_string(),
        nearest: Some("spline".to_string()),
        known: "auto, harmonic".to_string(),
    };
    let help = Error::from(error).help(Language::Es).unwrap();
    assert!(
        help.contains("spline") && help.contains("auto, harmonic"),
        "{help}"
    );
}

#[test]
fn spanish_names_of_laws_and_followers_are_values_of_a_scene() {
    use crate::cam::FollowerKind;
    use crate::law::Rise;
    let spanish = |name: &str| catalogue(Language::Es).name(name).to_uppercase();
    for rise in Rise::catalogue() {
        let found = Rise::from_name(&spanish(rise.name()));
        let found = found.unwrap_or_else(|e| panic!("{}: {e}", spanish(rise.name())));
        assert_eq!(found.name(), rise.name());
    }
    for (word, name) in super::SPANISH.iter().filter(|(_, name)| *name == "dwell") {
        assert_eq!(Rise::from_name(word).unwrap().name(), *name);
    }
    let scene = crate::scene::built_in("footbridge").unwrap();
    let scene = scene.scene().unwrap();
    let called = FollowerKind::ALL
        .iter()
        .map(|kind| (spanish(kind.name()), *kind));
    let others = super::SPANISH.iter().filter_map(|(word, name)| {
        let kind = FollowerKind::named(name)?;
        Some(((*word).to_string(), kind))
    });
    for (word, kind) in called.chain(others) {
        match scene.with("cam.follower", &word) {
            Ok(read) => assert_eq!(read.cam.follower, kind, "{word}"),
            // A recognised follower may still lack its lengths.
            Err(e) => assert_ne!(e.code(), "scene-unknown-word", "{word}: {e}"),
        }
    }
}
