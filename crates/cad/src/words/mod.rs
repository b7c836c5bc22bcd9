//! Labels and lengths of drawings, with one Fluent file per language.

use std::ops::Deref;

use gaitcam::wording::{Catalogue, Language, Sentences, Words};

use crate::Units;

static WORDS: Catalogue = Catalogue::new(&[Sentences {
    files: &[[include_str!("en.ftl"), include_str!("es.ftl")]],
    ..Sentences::NONE
}]);

/// Labels of a drawing, and lengths in its unit.
#[derive(Clone, Copy)]
pub(crate) struct Labels {
    words: Words,
    units: Units,
}

impl Deref for Labels {
    type Target = Words;

    fn deref(&self) -> &Words {
        &self.words
    }
}

impl Labels {
    /// Creates the labels for a language and a unit.
    pub fn new(language: Language, units: Units) -> Self {
        let words = Words::new(WORDS.of(language));
        Labels { words, units }
    }

    /// Unit of lengths.
    pub fn units(&self) -> Units {
        self.units
    }

    /// A length in m as a number with a given number of decimals of a millimetre.
    pub fn length(&self, length: f64, decimals: usize) -> String {
        self.decimal(self.units.number(length, decimals))
    }

    /// Heading of a column of lengths, such as "r, mm".
    pub fn column(&self, symbol: &str) -> String {
        format!("{symbol}, {}", self.units.name())
    }
}
