//! Simulation of the emitted cam on its machine.

mod floor;
mod on_shaft;
mod polydyne;
mod shaft;
mod walking;
