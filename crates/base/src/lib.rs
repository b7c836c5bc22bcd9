//! Foundations shared by the crates of gaitcam.
//!
//! - [`error`]: a fault in the input, with its place, a code for programs and its data;
//! - [`units`]: quantities with units as users write them, `"3 in"` or `"30 psi/in^3"`;
//! - [`wording`]: sentences made from data, in English and Spanish;
//! - [`text`]: numbers and text as files and pages show them;
//! - [`halt`]: how a caller ends a computation;
//! - [`threads`]: threads where the system may refuse them.
//!
//! ```
//! use gaitcam_base::units::{Dimension, parse};
//! use gaitcam_base::wording::Language;
//!
//! let error = parse("3 parsec", Dimension::Length).unwrap_err();
//! assert_eq!(error.code(), "units-unknown-unit");
//! assert_eq!(error.sentence(Language::Es).split(';').next(), Some("unidad desconocida «parsec»"));
//! ```
#![forbid(unsafe_code)]
#![deny(missing_docs)]
#![deny(clippy::missing_errors_doc)]
#![cfg_attr(not(test), warn(unused_crate_dependencies))]

pub mod error;
pub mod halt;
mod quantity;
pub mod text;
pub mod threads;
pub mod units;
pub mod wording;

/// The program in the README compiles and runs.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
