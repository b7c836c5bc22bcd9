//! Messages of the command, in one file per language: `words/LANGUAGE/cli.ftl`.

use gaitcam::synth::Figure;
use gaitcam::wording::{Catalogue, Language, Messages, Sentences};
use serde_json::Value;

use crate::console::language;

/// Messages in the language of the output.
pub fn catalogue() -> &'static Messages {
    WORDS.of(language::current())
}

/// Catalogue of the command's messages in all languages.
pub static WORDS: Catalogue = Catalogue::new(&[Sentences {
    files: &[[
        include_str!("../../words/en/cli.ftl"),
        include_str!("../../words/es/cli.ftl"),
    ]],
    as_typed: &[
        "column", "columns", "fault", "file", "folder", "key", "known", "list", "name", "near",
        "nearest", "text", "typed", "who",
    ],
    ..Sentences::NONE
}]);

/// Text of the heading or label with the message key `key`, in the language of the output.
pub fn text(key: &str) -> String {
    catalogue().text(key)
}

/// Message `key` in which the values of the JSON object `arguments` replace the placeholders.
pub fn fill(key: &str, arguments: &Value) -> String {
    let (area, variant) = key.split_once('-').unwrap_or(("", key));
    catalogue().sentence(area, &serde_json::json!({ variant: arguments }))
}

/// Length, given in m, as text in the displayed unit.
pub fn length(metres: f64) -> String {
    gaitcam::wording::quantity(language::current(), metres, "m")
}

/// Name of a follower, law, limit or solver in the language of the output. Other texts are returned unchanged.
pub fn name(typed: &str) -> String {
    gaitcam::wording::catalogue(language::current()).name(typed)
}

/// Heading of a table column with its SI unit, such as `RMS force error, N`. For a column of a scene key, the heading is the key.
pub fn column(name: &str) -> String {
    let label = gaitcam::sweep::table::label(name);
    let (quantity, unit) = label.rsplit_once(", ").unwrap_or((&label, ""));
    let quantity = match Figure::of_column(name) {
        Some(figure) => figure.label(language::current()),
        None => match text(&format!("column-{quantity}")) {
            missing if missing.starts_with("column-") => quantity.to_string(),
            quantity => quantity,
        },
    };
    match unit {
        "" => quantity,
        unit => format!("{quantity}, {unit}"),
    }
}

/// Number as text with at most four significant digits.
pub fn number(value: f64) -> String {
    gaitcam::wording::number(language::current(), value)
}

/// Number as text with a fixed number of decimals and the decimal sign of the language.
pub fn fixed(value: f64, decimals: usize) -> String {
    gaitcam::wording::fixed(language::current(), value, decimals)
}

/// Number in scientific notation, such as `1.2e-15`.
pub fn power(value: f64, decimals: usize) -> String {
    if value == 0.0 {
        return "0".to_string();
    }
    decimal(format!("{value:.decimals$e}"))
}

/// Replaces the decimal point of a formatted number by the decimal sign of the language.
pub fn decimal(number: String) -> String {
    match language::current() {
        Language::En => number,
        Language::Es => number.replace('.', ","),
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use strum::VariantNames;

    use super::*;
    use crate::console::error::CliError;

    #[test]
    fn every_fault_has_its_sentence_and_both_languages_the_same_keys() {
        let keys =
            |language| -> BTreeSet<String> { WORDS.of(language).keys().into_iter().collect() };
        let (english, spanish) = (keys(Language::En), keys(Language::Es));
        for variant in CliError::VARIANTS {
            assert!(english.contains(&format!("cli-{variant}")), "{variant}");
        }
        let faults = english.iter().filter(|k| k.starts_with("cli-")).count();
        assert_eq!(faults, CliError::VARIANTS.len());
        for language in [Language::En, Language::Es] {
            // A message is parsed only when it is requested, so every message is requested here.
            assert!(
                english
                    .iter()
                    .all(|key| !WORDS.of(language).text(key).is_empty())
            );
        }
        let missing: Vec<_> = english.symmetric_difference(&spanish).collect();
        assert!(missing.is_empty(), "{missing:?}");
    }
}
