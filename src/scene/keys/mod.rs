//! The key table: one row for each key of a scene file.
//!
//! Reading and writing TOML, changing single values, sweeps, relaxations, suggestions in messages, the JSON Schema and the reference page use the
//! rows of [`KEYS`]. A new key needs one row in `table.rs`, its field, and its two texts in `wording/*/keys.ftl`.

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

/// Row of a key. List entries have a number or the letter N: `law.segment.2.lift`, `law.segment.N.lift`.
pub fn find(path: &str) -> Option<&'static Key> {
    KEYS.iter().find(|k| k.index_in(path).is_some())
}

/// Row of a limit in the key table.
pub fn of_limit(kind: LimitKind) -> Option<&'static Key> {
    KEYS.iter().find(|k| k.limit == Some(kind))
}

/// Keys that may be relaxed in an infeasible scene: first limits, then accuracy and given sizes.
pub fn relaxable() -> impl Iterator<Item = &'static Key> {
    let of = |section: &'static str| {
        KEYS.iter()
            .filter(move |k| k.section() == section && k.relax.is_some())
    };
    of("limits").chain(of("accuracy")).chain(of("cam"))
}
