//! Messages in English and Spanish, from codes and data.
//!
//! An error, a note or a reason is an enum variant with fields. Its text is in a Fluent file with the key `area-variant`, where area and
//! variant are in kebab-case. The fields are the arguments of the text. The suggested change of an error is the attribute `.help` of the
//! same message:
//!
//! ```text
//! law-uncovered = the segments cover { $covered } of { $wanted }
//!     .help = lengthen or add segments until they cover the turn
//! ```
//!
//! The arguments are displayed as follows:
//!
//! - A [`Quantity`](crate::units::Quantity) is displayed in its common unit, with six significant digits (four in a note or reason).
//! - A number is displayed with six significant digits.
//! - The items of a list are joined by commas.
//! - An enum variant without data (a follower, a limit, a law) is displayed by the message `name-…`. Without such a message it is displayed
//!   as written in scenes.
//! - `None` is the word `none`, which selectors can match.

mod catalogue;
mod language;
mod messages;
mod number;

pub use catalogue::{Catalogue, File, Sentences};
pub use language::{InLanguages, Language};
pub use messages::{Messages, code};
pub use number::{
    DIGITS, LengthUnit, degrees, display_lengths_in, exact, fixed, number, people, quantity, range,
    rounded, walker,
};

/// Messages of this crate: names of quantities, and errors in quantities.
pub const SENTENCES: Sentences = Sentences {
    files: &[
        [include_str!("en/names.ftl"), include_str!("es/names.ftl")],
        [include_str!("en/units.ftl"), include_str!("es/units.ftl")],
    ],
    as_typed: &["example", "nearest", "text"],
    ..Sentences::NONE
};

/// Messages of this crate, without those of other crates.
pub static WORDS: Catalogue = Catalogue::new(&[SENTENCES]);
