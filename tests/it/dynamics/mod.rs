//! The emitted cam on its machine.

mod on_shaft;
mod polydyne;
mod shaft;
