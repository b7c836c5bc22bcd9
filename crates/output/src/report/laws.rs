//! Advice on when to use each law in the catalogue of rises.

use crate::words;
use gaitcam::law::Rise;
use gaitcam::wording::Language;

/// Advice on when to use a law of the catalogue, in a language.
pub fn advice(rise: &Rise, language: Language) -> String {
    words::words(language).text(&format!("laws-use-{}", rise.name()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_law_has_its_words_in_both_languages() {
        for language in [Language::En, Language::Es] {
            let named = gaitcam::wording::catalogue(language).keys();
            for rise in Rise::catalogue() {
                let name = rise.name();
                assert!(
                    named.contains(&format!("name-{name}")),
                    "{language:?}: {name}"
                );
                assert!(!advice(&rise, language).contains("laws-use"), "{name}");
            }
        }
    }
}
