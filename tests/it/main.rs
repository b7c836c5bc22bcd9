//! The library against closed forms, tables and independent routes, by subject.

mod cam;
mod dynamics;
mod examples;
mod force;
mod law;
mod layering;
mod public_examples;
mod scene;
mod support;
mod synth;
mod wording;
