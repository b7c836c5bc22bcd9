//! Foundations shared by the crates of gaitcam.
//!
//! - [`error`]: an error in the input, with its location, a code for programs and its data;
//! - [`units`]: quantities with units as users write them, `"3 in"` or `"30 psi/in^3"`;
//! - [`wording`]: messages from data, in English and Spanish;
//! - [`text`]: format of numbers and text in files and pages;
//! - [`halt`]: stop condition of a computation;
//! - [`random`]: pseudo-random numbers that are the same on every machine;
//! - [`threads`]: threads on systems that may refuse them.
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
#![cfg_attr(not(test), deny(clippy::disallowed_methods))]
#![deny(missing_docs)]
#![deny(clippy::missing_errors_doc)]
#![cfg_attr(not(test), warn(unused_crate_dependencies))]

pub mod error;
pub mod halt;
mod quantity;
pub mod random;
pub mod text;
pub mod threads;
pub mod units;
pub mod wording;

/// Compiles and runs the program in the README as a doctest.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
