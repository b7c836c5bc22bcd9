//! The emitted cam on its machine.

mod polydyne;
mod shaft;
