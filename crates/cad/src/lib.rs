//! Export of a designed cam to files for CAD, printing and machining.
//!
//! A [`Design`](gaitcam::synth::Design) has one or more edges to cut ([`Edge`](gaitcam::synth::Edge)): the profile of a disc, both profiles
//! of a conjugate pair, or the walls of a barrel's groove. Every exporter is a pure function from the design to the bytes of one file at
//! true scale. Lengths are in millimetres. DXF files, drawings and programs can have other [`Units`]. The bytes of the files are equal for
//! equal designs.
//!
//! | module | output | accuracy |
//! |---|---|---|
//! | [`dxf`] | outline as polyline, arcs or splines (R12, R2000) | vertices on the profile; arcs and splines within a tolerance |
//! | [`svg`] | outline for a laser cutter or for printing | vertices on the profile |
//! | [`step`] | solid with B-spline faces (AP214) | [`step::FAITHFUL`] |
//! | [`solid`] | STL and 3MF of the plate, walls of a barrel's groove | vertices on the profile |
//! | [`drawing`] | PDF sheet with views, dimensions, table of radii | lengths with three decimals of a millimetre |
//! | [`ecam`] | electronic cam for a motion controller | evaluated in the number type of the controller |
//! | [`gcode`], [`cutter`] | programs for milling, a rotary axis and wire cutting; detection of gouges | arcs within a tolerance ([`biarc`]) |
//!
//! ```
//! use gaitcam::scene::built_in;
//! use gaitcam::synth::synthesise;
//! use gaitcam_cad::{Units, dxf, step};
//!
//! let scene = built_in("camdas_01_roller").unwrap().scene().unwrap();
//! let design = synthesise(&scene, None).unwrap();
//! let outline = dxf::profile(&design, 720, dxf::Content::CutOnly, dxf::Curves::Arcs, Units::Inches);
//! let solid = step::solid(&design).unwrap();
//! assert!(outline.len() > 10_000 && solid.starts_with(b"ISO-10303-21;"));
//! ```

#![forbid(unsafe_code)]
#![cfg_attr(not(test), deny(clippy::disallowed_methods))]
#![deny(missing_docs)]
#![cfg_attr(not(test), warn(unused_crate_dependencies))]

pub mod biarc;
pub mod cutter;
pub mod drawing;
pub mod dxf;
pub mod ecam;
pub mod gcode;
pub mod outline;
pub mod solid;
mod spline;
pub mod step;
pub mod svg;
mod units;
mod words;

pub use units::Units;

#[cfg(test)]
use gaitcam_test_support as _;
