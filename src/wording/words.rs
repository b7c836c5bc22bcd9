//! Texts of one message catalogue in one language.

use serde_json::{Map, Value};

use super::{Language, Messages, catalogue, degrees, number, quantity, range};

/// Texts of a catalogue, and formatting of numbers and names in its language.
///
/// ```
/// use gaitcam::wording::{Language, Words, catalogue};
///
/// let words = Words::new(catalogue(Language::Es));
/// assert_eq!((words.fixed(1.25, 2), words.tag()), ("1,25".to_string(), "es"));
/// ```
#[derive(Clone, Copy)]
pub struct Words(&'static Messages);

impl Words {
    /// Creates the texts for the messages of one catalogue.
    pub fn new(own: &'static Messages) -> Self {
        Words(own)
    }

    /// Language of the messages.
    pub fn language(&self) -> Language {
        self.0.language()
    }

    /// Tag of the language, such as `en`, for the attribute `lang` of an HTML page.
    pub fn tag(&self) -> &'static str {
        self.language().tag()
    }

    /// A formatted number with the decimal separator of the language.
    pub fn decimal(&self, written: String) -> String {
        match self.language() {
            Language::En => written,
            Language::Es => written.replace('.', ","),
        }
    }

    /// A number with a fixed number of decimals and the decimal separator of the language. Zero has no sign.
    pub fn fixed(&self, value: f64, decimals: usize) -> String {
        self.0.fixed(value, decimals)
    }

    /// A number for display, with at most four significant digits.
    pub fn number(&self, value: f64) -> String {
        number(self.language(), value)
    }

    /// A number for display. A value below 1e-9 times `scale` counts as a rounding error and is displayed as 0.
    ///
    /// ```
    /// use gaitcam::wording::{Language, Words, catalogue};
    ///
    /// let words = Words::new(catalogue(Language::En));
    /// assert_eq!(words.number_beside(3e-15, 18.5), "0");
    /// ```
    pub fn number_beside(&self, value: f64, scale: f64) -> String {
        let is_rounding = value.abs() < 1e-9 * scale.abs();
        self.number(if is_rounding { 0.0 } else { value })
    }

    /// Range "low … high" for display.
    pub fn range(&self, low: f64, high: f64) -> String {
        range(self.language(), low, high)
    }

    /// A length in m, displayed in the unit of lengths. Values below a picometre are displayed as 0.
    pub fn length(&self, length: f64) -> String {
        let length = if length.abs() < 1e-12 { 0.0 } else { length };
        quantity(self.language(), length, "m")
    }

    /// An angle in rad, displayed in degrees with one decimal.
    pub fn degrees(&self, theta: f64) -> String {
        degrees(self.language(), theta)
    }

    /// Text of a heading or label with this key.
    pub fn text(&self, key: &str) -> String {
        self.0.text(key)
    }

    /// Text of the message `key` with these arguments, which are inserted unchanged.
    pub fn fill(&self, key: &str, arguments: &[(&str, &str)]) -> String {
        let values = arguments.iter().map(|&(name, text)| {
            // Whole numbers are passed as numbers, because they select plural forms.
            let value = text.parse::<i64>().map_or(Value::from(text), Value::from);
            (name.to_string(), value)
        });
        let fields: Map<String, Value> = values.collect();
        let (area, variant) = key.split_once('-').unwrap_or(("", key));
        let message = Map::from_iter([(variant.to_string(), Value::from(fields))]);
        self.0.sentence(area, &Value::from(message))
    }

    /// Name of a follower, law, limit or machine in the language. An unknown name is returned with spaces instead of `_` and `-`.
    pub fn name(&self, typed: &str) -> String {
        let name = catalogue(self.language()).name(typed);
        if name == typed {
            typed.replace(['_', '-'], " ")
        } else {
            name
        }
    }
}
