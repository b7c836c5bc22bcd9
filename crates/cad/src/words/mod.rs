//! Headings and labels of what people read, by language: one Fluent file each.

use gaitcam::wording::{self, Catalogue, Language, Messages};
use serde_json::{Map, Value};

use crate::Units;

static WORDS: Catalogue = Catalogue::new(&[&[[include_str!("en.ftl"), include_str!("es.ftl")]]]);

/// Labels of the drawing in a language.
pub(crate) fn words(language: Language, units: Units) -> Words {
    Words {
        units,
        ..Words::new(WORDS.of(language))
    }
}

/// The texts of a catalogue, and numbers and names in its language.
#[derive(Clone, Copy)]
pub struct Words {
    own: &'static Messages,
    units: Units,
}

impl Words {
    /// The words of a catalogue.
    pub fn new(own: &'static Messages) -> Self {
        Words {
            own,
            units: Units::default(),
        }
    }

    /// Its language.
    pub fn language(&self) -> Language {
        self.own.language()
    }

    /// The tag of the language, for `html lang`.
    pub fn tag(&self) -> &'static str {
        self.language().tag()
    }

    /// A number that is written already, with the decimal sign of the language.
    pub fn decimal(&self, written: String) -> String {
        match self.language() {
            Language::En => written,
            Language::Es => written.replace('.', ","),
        }
    }

    /// A number with a fixed count of decimals, with the decimal sign of the language; zero has no sign.
    pub fn fixed(&self, value: f64, decimals: usize) -> String {
        self.own.fixed(value, decimals)
    }

    /// The unit of lengths.
    pub fn units(&self) -> Units {
        self.units
    }

    /// A length given in m as its number, with so many decimals of a millimetre.
    pub fn length(&self, length: f64, decimals: usize) -> String {
        self.decimal(self.units.number(length, decimals))
    }

    /// The head of a column of lengths: "r, mm".
    pub fn column(&self, symbol: &str) -> String {
        format!("{symbol}, {}", self.units.name())
    }

    /// A heading or label.
    pub fn text(&self, key: &str) -> String {
        self.own.text(key)
    }

    /// A sentence with its arguments, inserted unchanged.
    pub fn fill(&self, key: &str, arguments: &[(&str, &str)]) -> String {
        let values = arguments.iter().map(|&(name, text)| {
            // Whole numbers choose plural forms.
            let value = text.parse::<i64>().map_or(Value::from(text), Value::from);
            (name.to_string(), value)
        });
        let fields: Map<String, Value> = values.collect();
        let (area, variant) = key.split_once('-').unwrap_or(("", key));
        let message = Map::from_iter([(variant.to_string(), Value::from(fields))]);
        self.own.sentence(area, &Value::from(message))
    }

    /// The name of a follower, law, limit or machine where the language has one, otherwise as it is typed but
    /// with spaces.
    pub fn name(&self, typed: &str) -> String {
        let name = wording::catalogue(self.language()).name(typed);
        if name == typed {
            typed.replace(['_', '-'], " ")
        } else {
            name
        }
    }
}
