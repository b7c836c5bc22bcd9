//! The key table, with one row for each key of a scene file.
//!
//! The rows of [`KEYS`] are used to read and write TOML, to change single values, for sweeps and for suggested changes. Messages, the JSON Schema and
//! the reference page also use them. A new key needs one row in `table.rs`, its field, and its two texts in `wording/*/keys.ftl`.

mod field;
mod kind;
mod list;
mod read;
mod row;
mod schema;
mod special;
mod table;
mod value;

use super::LimitKind;

pub use kind::{Kind, Range, Relax};
pub use list::{json, markdown, takes};
pub(super) use read::read as read_value;
pub use row::Key;
pub use schema::schema;
pub use table::KEYS;
pub use value::Value;
pub(super) use value::short;

/// Row of the key with a dotted path; `None` for an unknown key. In a list, the path contains the number of an entry or the letter N:
/// `law.segment.2.lift`, `law.segment.N.lift`.
pub fn find(path: &str) -> Option<&'static Key> {
    KEYS.iter().find(|k| k.index_in(path).is_some())
}

/// Row of the key that sets a limit; `None` if no key sets it.
pub fn of_limit(kind: LimitKind) -> Option<&'static Key> {
    KEYS.iter().find(|k| k.limit == Some(kind))
}

/// Rows of the keys that may be relaxed in an infeasible scene: first the limits, then the accuracy, then the given dimensions of the cam.
pub fn relaxable() -> impl Iterator<Item = &'static Key> {
    let of = |section: &'static str| {
        KEYS.iter()
            .filter(move |k| k.section() == section && k.relax.is_some())
    };
    of("limits").chain(of("accuracy")).chain(of("cam"))
}
