//! The key table: one row for each key of a scene file.
//!
//! Reading and writing TOML, changing single values, sweeps, relaxations, the names that messages suggest, the
//! JSON Schema and the reference page all come from these rows. A new key is one row here and its two sentences
//! in `wording/*/keys.ftl`.

mod cam;
mod drive;
mod force;
mod kind;
mod law;
mod limits;
mod list;
mod row;
mod schema;
mod value;

use std::sync::LazyLock;

use super::LimitKind;

pub use kind::{Idle, Kind, Measure, Range, Relax};
pub use list::{json, markdown, takes};
pub use row::Key;
pub use schema::schema;
pub use value::Value;
pub(super) use value::{read as read_value, shown};

/// Every key, in the order in which a scene is read and written: a row stands after those that decide about it.
pub static KEYS: LazyLock<Vec<Key>> = LazyLock::new(|| {
    let name = [row::other(
        "name",
        Kind::Text,
        row::Access {
            get: |s, _| Some(Value::Text(s.name.clone())),
            set: |s, _, v| {
                s.name = v.text();
                Ok(())
            },
        },
    )
    .default("cam")];
    [
        &name[..],
        force::ROWS,
        cam::ROWS,
        drive::ROWS,
        law::ROWS,
        limits::LIMITS,
        limits::REST,
    ]
    .concat()
});

/// The row of a key; entries of lists go by number or by the letter N: `law.segment.2.lift`, `law.segment.N.lift`.
pub fn find(path: &str) -> Option<&'static Key> {
    KEYS.iter().find(|k| k.index_in(path).is_some())
}

/// The row that sets a limit.
pub fn of_limit(kind: LimitKind) -> Option<&'static Key> {
    KEYS.iter().find(|k| k.limit == Some(kind))
}

/// The rows that may be relaxed when a scene cannot be met: limits first, then accuracy and given sizes.
pub fn relaxable() -> impl Iterator<Item = &'static Key> {
    let of = |section: &'static str| {
        KEYS.iter()
            .filter(move |k| k.section() == section && k.relax.is_some())
    };
    of("limits").chain(of("accuracy")).chain(of("cam"))
}
