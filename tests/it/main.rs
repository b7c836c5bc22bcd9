//! Tests of the library against closed forms, tables and independent methods, by subject.

mod cam;
mod dynamics;
mod examples;
mod identify;
mod immutable;
mod law;
mod layering;
mod public_examples;
mod readme;
mod scene;
mod sweep;
mod synth;
