//! Texts of drawings, with one Fluent file per language.

use std::ops::Deref;

use gaitcam::wording::{Catalogue, Language, Sentences, Words};

use crate::Units;

static WORDS: Catalogue = Catalogue::new(&[Sentences {
    files: &[[include_str!("en.ftl"), include_str!("es.ftl")]],
    ..Sentences::NONE
}]);

/// Texts of a drawing in its language, and lengths in its unit.
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
    /// Creates the texts for a language and a unit of lengths.
    pub fn new(language: Language, units: Units) -> Self {
        let words = Words::new(WORDS.of(language));
        Labels { words, units }
    }

    /// Unit of lengths in the drawing.
    pub fn units(&self) -> Units {
        self.units
    }

    /// Text of a length, given in m, in the unit of the drawing and without the unit. `decimals` applies to millimetres.
    pub fn length(&self, length: f64, decimals: usize) -> String {
        self.decimal(self.units.number(length, decimals))
    }

    /// Heading of a column of lengths, such as "r, mm".
    pub fn column(&self, symbol: &str) -> String {
        format!("{symbol}, {}", self.units.name())
    }
}
