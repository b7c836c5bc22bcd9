//! Messages from data: code + data + language → sentence.
//!
//! An error, a note or a reason is an enum variant with fields. Its sentence is in a Fluent file under the key `area-variant`, both in kebab-case, the fields being its arguments; the remedy of a fault is the
//! attribute `.help` of the same message:
//!
//! ```text
//! law-uncovered = the segments cover { $covered } of { $wanted }
//!     .help = lengthen or add segments until they cover the turn
//! ```
//!
//! Arguments: a [`Quantity`](crate::units::Quantity) is shown in the customary unit with six significant digits (four in a note or reason), a plain number with
//! six, a list joined by commas; a unit variant (a follower, a limit, a law) by the message `name-…` of that variant, where there is one, otherwise
//! as it is typed in scenes. `None` is the word `none`, which selectors can match.

mod catalogue;
mod language;
mod messages;
mod number;

pub use catalogue::{Catalogue, File, Sentences};
pub use language::{InLanguages, Language};
pub use messages::{Messages, code};
pub use number::{DIGITS, degrees, exact, fixed, number, people, quantity, range, rounded, walker};

/// Messages of this crate: names of quantities, faults of quantities.
pub const SENTENCES: Sentences = Sentences {
    files: &[
        [include_str!("en/names.ftl"), include_str!("es/names.ftl")],
        [include_str!("en/units.ftl"), include_str!("es/units.ftl")],
    ],
    as_typed: &["example", "nearest", "text"],
    ..Sentences::NONE
};

/// The catalogue of this crate.
pub static WORDS: Catalogue = Catalogue::new(&[SENTENCES]);
