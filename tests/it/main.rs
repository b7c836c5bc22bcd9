//! The library against closed forms, tables and independent routes, by subject.

mod cam;
mod dynamics;
mod force;
mod law;
mod layering;
mod support;
mod synth;
mod wording;
